// Gradient noise as in MaterialX and three.js (three.js translates MaterialX): the lattice noise of
// Perlin, "Improving noise" (2002), with its twelve gradients and quintic fade, hashed by the final
// mix of Jenkins' lookup3 (2006).
uint rotated(uint x, int by) { return x << by | x >> (32 - by); }
uint cornerHash(uvec3 at) {
    uint a = 0xDEADBEEFu + 12u + 13u + at.x;
    uint b = 0xDEADBEEFu + 12u + 13u + at.y;
    uint c = 0xDEADBEEFu + 12u + 13u + at.z;
    c = (c ^ b) - rotated(b, 14);
    a = (a ^ c) - rotated(c, 11);
    b = (b ^ a) - rotated(a, 25);
    c = (c ^ b) - rotated(b, 16);
    a = (a ^ c) - rotated(c, 4);
    b = (b ^ a) - rotated(a, 14);
    return (c ^ b) - rotated(b, 24);
}
float cornerTerm(uvec3 at, vec3 d) {
    uint h = cornerHash(at) & 15u;
    float u = h < 8u ? d.x : d.y;
    float v = h < 4u ? d.y : h == 12u || h == 14u ? d.x : d.z;
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}
float noise(vec3 p) {
    vec3 whole = floor(p);
    vec3 d = p - whole;
    uvec3 at = uvec3(ivec3(whole));
    vec3 s = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    float line[4];
    for (uint i = 0u; i < 4u; i++) {
        uvec3 corner = uvec3(0u, i & 1u, i >> 1u);
        line[i] = mix(cornerTerm(at + corner, d - vec3(corner)),
                      cornerTerm(at + corner + uvec3(1u, 0u, 0u),
                          d - vec3(corner) - vec3(1.0, 0.0, 0.0)), s.x);
    }
    return 0.982 * mix(mix(line[0], line[1], s.y), mix(line[2], line[3], s.y), s.z);
}
