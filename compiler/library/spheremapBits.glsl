// needs: encodeSpheremap unormBits
// The two numbers of encodeSpheremap, `bits` bits each: x in the lower ones.
uint spheremapBits(vec3 n, int bits) {
    vec2 e = encodeSpheremap(n);
    return unormBits(e.x, bits) | unormBits(e.y, bits) << bits;
}
