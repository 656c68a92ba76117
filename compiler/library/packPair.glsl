// needs:
// Two numbers in [0, 1], cut to seven bits each, in one number of [1, 65504] that a half float holds exactly: x gives the
// exponent and the first three bits of the mantissa, y the other seven. The power of two is exact: exp2 errs by at most 33 ulp
// of 32768, an eighth, before it is rounded to a whole number.
float packPair(vec2 v) {
    vec2 q = floor(127.5 * clamp(v, 0.0, 1.0));
    float exponent = floor(q.x * 0.125);
    float mantissa = 1.0 + (q.x * 0.125 - exponent) + q.y * (1.0 / 1024.0);
    return mantissa * floor(exp2(exponent) + 0.5);
}
