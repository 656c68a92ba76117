// needs:
// The 16 bits of the half float nearest to v, ties to even; at most 65504 in size, subnormal ones kept. Not packHalf2x16, which
// GLSL 3.30 lacks, and whose rounding is the driver's choice. From 2^-14 on, the mantissa is rounded as part of a whole number,
// and a carry goes on into the exponent; below, it is |v| in units of 2^-24.
uint halfBits(float v) {
    float c = clamp(v, -65504.0, 65504.0);
    uint word = floatBitsToUint(abs(c));
    uint normal = ((word + 0xFFFu + (word >> 13 & 1u)) >> 13) - 0x1C000u;
    uint subnormal = uint(roundEven(abs(c) * 16777216.0));
    return (c < 0.0 ? 0x8000u : 0u) | (word < 0x38800000u ? subnormal : normal);
}
