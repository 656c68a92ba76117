// needs:
// Packs two numbers in [0, 1], truncated to 7 bits, into a number in [1, 65504] that is exact in a
// half float: x sets the exponent and 3 mantissa bits, y the other 7. floor() makes the power of
// two exact: exp2 errs by at most 33 ULP of 32768, or 1/8.
float packPair(vec2 v) {
    vec2 q = floor(127.5 * clamp(v, 0.0, 1.0));
    float exponent = floor(q.x * 0.125);
    float mantissa = 1.0 + (q.x * 0.125 - exponent) + q.y * (1.0 / 1024.0);
    return mantissa * floor(exp2(exponent) + 0.5);
}
