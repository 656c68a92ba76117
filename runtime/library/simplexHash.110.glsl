// needs: latticeAxis latticePermute
// Hashes in [0, 761) of a simplex' corners.
vec4 simplexHash(vec3 first, vec3 second, vec3 third) {
    vec4 c0 = latticeAxis(first);
    vec4 c1 = latticeAxis((first + 1.0) * (1.0 - step(65535.5, first + 1.0)));
    vec4 x = vec4(c0.x, mix(c0.x, c1.x, second.x), mix(c0.x, c1.x, third.x), c1.x);
    vec4 y = vec4(c0.y, mix(c0.y, c1.y, second.y), mix(c0.y, c1.y, third.y), c1.y);
    vec4 z = vec4(c0.z, mix(c0.z, c1.z, second.z), mix(c0.z, c1.z, third.z), c1.z);
    return latticePermute(latticePermute(latticePermute(x + 17.0) + y) + z);
}
