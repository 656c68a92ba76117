// needs:
// Index of GroIMP's next output in the random table.
vec4 latticeNext(vec4 hash) {
    return hash + 8.0;
}
