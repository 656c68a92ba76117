// needs: latticePermute
// Derives a second, unrelated hash from a corner's hash.
vec4 latticeNext(vec4 hash) {
    return latticePermute(hash + 17.0);
}
