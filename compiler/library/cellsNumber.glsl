// needs:
// A number of 24 bits in [0, 1) out of a cell's hash, of which its place knows nothing.
float cellsNumber(uint hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return float((hash ^ (hash >> 16u)) >> 8u) * (1.0 / 16777216.0);
}
