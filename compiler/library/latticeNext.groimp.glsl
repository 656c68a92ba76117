// needs:
// Index of GroIMP's next output in the random table.
ivec4 latticeNext(ivec4 hash) {
    return hash + 8;
}
