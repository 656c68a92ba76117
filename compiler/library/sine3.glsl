// needs:
// Component-wise sine. Error of sin().
vec3 sine3(vec3 x) {
    return sin(x);
}
