// needs:
// Three numbers >= 0 with one exponent: mantissas m of `bits` bits, 4 to 9, and above them an exponent e of 5:
// v = m 2^(e - 15 - bits), at most 65536 (1 - 2^-bits). With 9 bits that is the texture format RGB9E5. The exponent is read from
// the float's own, so that no logarithm errs; where a mantissa is rounded up to 2^bits, the next exponent is taken.
uint sharedExponentBits(vec3 v, int bits) {
    float steps = float(1 << bits);
    vec3 c = clamp(v, 0.0, 65536.0 - 65536.0 / steps);
    float greatest = max(max(c.x, c.y), max(c.z, 1.0 / 65536.0));
    int e = int(floatBitsToUint(greatest) >> 23) - 111;
    float scale = uintBitsToFloat(uint(142 + bits - e) << 23);
    if (floor(greatest * scale + 0.5) >= steps) { e += 1; scale *= 0.5; }
    uvec3 m = uvec3(floor(c * scale + 0.5));
    return m.x | m.y << bits | m.z << (2 * bits) | uint(e) << (3 * bits);
}
