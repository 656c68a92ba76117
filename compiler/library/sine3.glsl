// needs:
// Sine by lane. As accurate as the sine.
vec3 sine3(vec3 x) {
    return sin(x);
}
