// needs: encodeSpheremap unormBits
// Packs encodeSpheremap in 2 * bits bits: x in the lower half.
uint spheremapBits(vec3 n, int bits) {
    vec2 e = encodeSpheremap(n);
    return unormBits(e.x, bits) | unormBits(e.y, bits) << bits;
}
