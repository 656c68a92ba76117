// needs: cellsCell3 cellsDistance cellsRise3 cellsSearch3
// Gradient by p (xyz) and value (w) of cells3(p, rest, jitter, metric, value). Error of the
// gradient 6e-6, divided by the distance to the point; of the value 6e-7.
vec4 cells3Gradient(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    vec4 nearest = vec4(cellsRise3(first, metric), cellsDistance(first.w, metric));
    vec4 next = vec4(cellsRise3(second, metric), cellsDistance(second.w, metric));
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}
