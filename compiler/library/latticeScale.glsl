// needs:
// A hash read as a signed number is this much of 1.
const float latticeScale = 1.0 / 2147483648.0;
