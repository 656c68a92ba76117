// needs: cellsCell2 cellsDistance cellsSearch2
// Cells of p + rest, each of which has a point, moved from its middle by up to jitter/2: the distance to the nearest point (value 0), to the second
// nearest (1), or the second less the first (2): 0 on the walls between the points. Distances: 0 euclidean, 1 manhattan, 2 chebyshev. In [0, 2].
// Error 6e-7.
float cells2(vec2 p, vec2 rest, float jitter, int metric, int value) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.z, metric);
    float next = cellsDistance(second.z, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}
