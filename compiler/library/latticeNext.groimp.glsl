// needs:
// GroIMP's next output: the random table from another place on.
ivec4 latticeNext(ivec4 hash) {
    return hash + 8;
}
