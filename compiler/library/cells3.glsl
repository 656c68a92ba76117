// needs: cellsCell3 cellsDistance cellsSearch3
// Cells of p + rest, each of which has a point, moved from its middle by up to jitter/2: the distance to the nearest point (value 0), to the second
// nearest (1), or the second less the first (2): 0 on the walls between the points. Distances: 0 euclidean, 1 manhattan, 2 chebyshev. In [0, 3].
// Error 6e-7.
float cells3(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.w, metric);
    float next = cellsDistance(second.w, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}
