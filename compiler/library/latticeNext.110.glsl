// needs: latticePermute
// A second, unrelated hash out of a corner's hash.
vec4 latticeNext(vec4 hash) {
    return latticePermute(hash + 17.0);
}
