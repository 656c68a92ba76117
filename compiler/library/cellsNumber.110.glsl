// needs: latticePermute
// One of 761 numbers in (0, 1) from a cell's hash, independent of its point's position.
float cellsNumber(float hash) {
    return (latticePermute(vec4(hash + 17.0)).x + 0.5) * (1.0 / 761.0);
}
