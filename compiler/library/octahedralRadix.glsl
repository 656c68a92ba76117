// needs: encodeOctahedral halfFromCode
// Unit normal in one number that a half float holds exactly: 247 x 247 points of the octahedron by mixed radix, the axes among
// them.
float octahedralRadix(vec3 n) {
    vec2 q = floor(encodeOctahedral(n) * 123.0 + 0.5) + 123.0;
    return halfFromCode(q.x + 247.0 * q.y);
}
