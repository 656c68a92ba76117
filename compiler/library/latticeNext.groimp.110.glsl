// needs:
// GroIMP's next output: the random table from another place on.
vec4 latticeNext(vec4 hash) {
    return hash + 8.0;
}
