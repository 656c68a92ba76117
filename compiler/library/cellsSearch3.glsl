// needs: cellsFar3 cellsPlace3
// Finds the points nearest to d in a cell, as (offset, cellsFar3); `second` is valid only for count
// 2. Visits the 3 x 3 x 3 neighborhood first. Points of ring r are at least r - |d - 1/2| -
// jitter/2 away along an axis, so the search usually ends there for Euclidean distances; otherwise
// it visits the cells of rings 2 and 3 that may hold a nearer point. cells.h proves that ring 3
// suffices.
void cellsSearch3Visit(vec3 away, int metric, inout vec4 first, inout vec4 second) {
    float far = cellsFar3(away, metric);
    if (far < first.w) {
        second = first;
        first = vec4(away, far);
    } else if (far < second.w) {
        second = vec4(away, far);
    }
}

void cellsSearch3(vec3 cell, vec3 d, float jitter, int metric, int count, out vec4 first, out vec4 second) {
    vec3 corner = 0.5 - 0.5 * jitter - d;
    first = vec4(0.0, 0.0, 0.0, 64.0);
    second = first;
    for (int z = -1; z <= 1; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                vec3 offset = vec3(float(x), float(y), float(z));
                cellsSearch3Visit(offset + corner + jitter * cellsPlace3(cell, offset), metric, first, second);
            }
    vec3 side = abs(d - 0.5);
    float gap = -max(side.x, max(side.y, side.z)) - 0.5 * jitter;
    for (int ring = 2; ring <= 3; ring++) {
        float least = gap + float(ring);
        if ((count == 1 ? first.w : second.w) <= (metric == 0 ? least * least : least)) break;
        for (int z = -ring; z <= ring; z++)
            for (int y = -ring; y <= ring; y++)
                for (int x = -ring; x <= ring; x++) {
                    vec3 offset = vec3(float(x), float(y), float(z));
                    vec3 nearest = max(abs(offset + 0.5 - d) - 0.5 * jitter, 0.0);
                    bool inner = max(abs(offset.x), max(abs(offset.y), abs(offset.z))) < float(ring) - 0.5;
                    if (inner || cellsFar3(nearest, metric) >= (count == 1 ? first.w : second.w)) continue;
                    cellsSearch3Visit(offset + corner + jitter * cellsPlace3(cell, offset), metric, first, second);
                }
    }
}
