// needs:
// A second, unrelated hash out of a corner's hash: one round, since the first is already mixed.
uvec4 latticeNext(uvec4 hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return hash ^ (hash >> 16u);
}
