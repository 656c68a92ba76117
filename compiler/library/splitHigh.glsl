// needs:
// The upper 12 bits of each mantissa: products of two are exact.
vec3 splitHigh(vec3 x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xFFFFF000u);
}
