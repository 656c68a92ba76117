// needs:
// Gradient, by the sample position, of the distance to a point given as (offset, cellsFar2); 0 at
// the point.
vec2 cellsRise2(vec3 point, int metric) {
    vec2 side = -sign(point.xy);
    vec2 a = abs(point.xy);
    if (metric == 0) return -point.xy / sqrt(max(point.z, 1.0e-30));
    return metric == 1 ? side : side * step(max(a.x, a.y), a);
}
