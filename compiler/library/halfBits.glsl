// needs:
// Rounds v to the nearest half float, ties to even, clamped to 65504, subnormals kept; returns the
// bits. Replaces packHalf2x16, which GLSL 3.30 lacks and whose rounding is undefined. From 2^-14 on
// the mantissa is rounded as an integer, whose carry enters the exponent; smaller values are
// multiples of 2^-24.
uint halfBits(float v) {
    float c = clamp(v, -65504.0, 65504.0);
    uint word = floatBitsToUint(abs(c));
    uint normal = ((word + 0xFFFu + (word >> 13 & 1u)) >> 13) - 0x1C000u;
    uint subnormal = uint(roundEven(abs(c) * 16777216.0));
    return (c < 0.0 ? 0x8000u : 0u) | (word < 0x38800000u ? subnormal : normal);
}
