// needs: cellsCell2 cellsDistance cellsRise2 cellsSearch2
// Gradient by p (xyz) and value (w) of cells2(p, rest, jitter, metric, value). Error of the
// gradient 6e-6, divided by the distance to the point; of the value 6e-7.
vec4 cells2Gradient(vec2 p, vec2 rest, float jitter, int metric, int value) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    vec3 nearest = vec3(cellsRise2(first, metric), cellsDistance(first.z, metric));
    vec3 next = vec3(cellsRise2(second, metric), cellsDistance(second.z, metric));
    vec3 rise = value == 0 ? nearest : value == 1 ? next : next - nearest;
    return vec4(rise.xy, 0.0, rise.z);
}
