// needs: cellsCell2 cellsDistance cellsSearch2
// Cellular noise at p + rest. Each cell has a point, at most jitter/2 per axis from the center.
// Returns the distance to the nearest point (value 0), to the second nearest (1), or second minus
// nearest (2), which is 0 at cell borders. Metric: 0 Euclidean, 1 Manhattan, 2 Chebyshev. In [0,
// 2]. Error 6e-7.
float cells2(vec2 p, vec2 rest, float jitter, int metric, int value) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.z, metric);
    float next = cellsDistance(second.z, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}
