// needs: cellsFar2 cellsPlace2
// Finds the points nearest to d in a cell, as (offset, cellsFar2); `second` is valid only for count
// 2. Visits the 3 x 3 neighborhood first. Points of ring r are at least r - |d - 1/2| - jitter/2
// away along an axis, so the search usually ends there for Euclidean distances; otherwise it visits
// the cells of ring 2 that may hold a nearer point. cells.h proves that ring 2 suffices.
void cellsSearch2Visit(vec2 away, int metric, inout vec3 first, inout vec3 second) {
    float far = cellsFar2(away, metric);
    if (far < first.z) {
        second = first;
        first = vec3(away, far);
    } else if (far < second.z) {
        second = vec3(away, far);
    }
}

void cellsSearch2(vec2 cell, vec2 d, float jitter, int metric, int count, out vec3 first, out vec3 second) {
    vec2 corner = 0.5 - 0.5 * jitter - d;
    first = vec3(0.0, 0.0, 64.0);
    second = first;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            vec2 offset = vec2(float(x), float(y));
            cellsSearch2Visit(offset + corner + jitter * cellsPlace2(cell, offset), metric, first, second);
        }
    vec2 side = abs(d - 0.5);
    float least = 2.0 - max(side.x, side.y) - 0.5 * jitter;
    if ((count == 1 ? first.z : second.z) <= (metric == 0 ? least * least : least)) return;
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++) {
            vec2 offset = vec2(float(x), float(y));
            vec2 nearest = max(abs(offset + 0.5 - d) - 0.5 * jitter, 0.0);
            bool inner = max(abs(offset.x), abs(offset.y)) < 1.5;
            if (inner || cellsFar2(nearest, metric) >= (count == 1 ? first.z : second.z)) continue;
            cellsSearch2Visit(offset + corner + jitter * cellsPlace2(cell, offset), metric, first, second);
        }
}
