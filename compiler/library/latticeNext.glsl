// needs:
// Derives a second, unrelated hash from a corner's hash. One round suffices for a mixed hash.
uvec4 latticeNext(uvec4 hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return hash ^ (hash >> 16u);
}
