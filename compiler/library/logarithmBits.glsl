// needs:
// Quantizes v in equal steps of log2: code 0 is 0, code 1 is 1/16, the last is 65504 =
// 2^(19.9992954 - 4). Values below 1/32 become 0. bits in [4, 16].
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}
