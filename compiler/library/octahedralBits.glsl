// needs: octahedralWhole
// Packs octahedralWhole, offset to start at 0, in 2 * bits bits: x in the lower half.
uint octahedralBits(vec3 n, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    uvec2 code = uvec2(octahedralWhole(n, bits) + scale);
    return code.x | code.y << bits;
}
