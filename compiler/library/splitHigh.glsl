// needs:
// The upper 12 bits of each number's mantissa: a product of two such numbers is exact.
vec3 splitHigh(vec3 x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xFFFFF000u);
}
