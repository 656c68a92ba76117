// needs:
// Packs three numbers >= 0 with a shared exponent: mantissas m of `bits` bits (4 to 9), then a
// 5-bit exponent e: v = m 2^(e - 15 - bits), at most 65536 (1 - 2^-bits). 9 bits are the format
// RGB9E5. The float's own exponent is used, so no logarithm errs. A mantissa that rounds to 2^bits
// uses the next exponent.
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
