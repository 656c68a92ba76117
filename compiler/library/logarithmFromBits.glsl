// needs:
// Inverse of logarithmBits, in [0, 65504].
float logarithmFromBits(uint code, int bits) {
    float place = float(code) - 1.0;
    float value = exp2(place * (19.9992954 / float((1 << bits) - 2)) - 4.0);
    return code == 0u ? 0.0 : min(value, 65504.0);
}
