// needs: encodeOctahedral halfFromCode
// Packs a unit normal into a number that is exact in a half float: a 247 x 247 octahedral grid by
// mixed radix. The axes are exact.
float octahedralRadix(vec3 n) {
    vec2 q = floor(encodeOctahedral(n) * 123.0 + 0.5) + 123.0;
    return halfFromCode(q.x + 247.0 * q.y);
}
