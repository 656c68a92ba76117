// needs: latticeFinal
// Hashes of a simplex' corners.
uvec4 simplexHash(vec3 first, vec3 second, vec3 third) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(first));
    uvec3 c1 = ((c + uvec3(ivec3(second))) & 65535u) * factor;
    uvec3 c2 = ((c + uvec3(ivec3(third))) & 65535u) * factor;
    uvec3 c3 = ((c + 1u) & 65535u) * factor;
    c *= factor;
    return latticeFinal(uvec4(c.x, c1.x, c2.x, c3.x) ^ uvec4(c.y, c1.y, c2.y, c3.y)
                        ^ (uvec4(c.z, c1.z, c2.z, c3.z) + 0x165667B1u));
}
