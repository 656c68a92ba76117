// needs:
// Scales a signed 32-bit hash to [-1, 1].
const float latticeScale = 1.0 / 2147483648.0;
