// needs: sineBounded
// Component-wise sine. Error 1.5e-7 for |x| <= 1e5 on every driver.
vec3 sine3(vec3 x) {
    return vec3(sineBounded(x.x), sineBounded(x.y), sineBounded(x.z));
}
