// needs: latticePermute
// One of 761 numbers in (0, 1) out of a cell's hash, of which its place knows nothing.
float cellsNumber(float hash) {
    return (latticePermute(vec4(hash + 17.0)).x + 0.5) * (1.0 / 761.0);
}
