// needs: cellsCell3 cellsDistance cellsSearch3
// Cellular noise at p + rest. Each cell has a point, at most jitter/2 per axis from the center.
// Returns the distance to the nearest point (value 0), to the second nearest (1), or second minus
// nearest (2), which is 0 at cell borders. Metric: 0 Euclidean, 1 Manhattan, 2 Chebyshev. In [0,
// 3]. Error 6e-7.
float cells3(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.w, metric);
    float next = cellsDistance(second.w, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}
