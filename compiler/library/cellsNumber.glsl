// needs:
// A 24-bit number in [0, 1) from a cell's hash, independent of its point's position.
float cellsNumber(uint hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return float((hash ^ (hash >> 16u)) >> 8u) * (1.0 / 16777216.0);
}
