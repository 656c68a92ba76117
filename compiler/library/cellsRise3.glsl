// needs:
// Gradient, by the sample position, of the distance to a point given as (offset, cellsFar3); 0 at
// the point.
vec3 cellsRise3(vec4 point, int metric) {
    vec3 side = -sign(point.xyz);
    vec3 a = abs(point.xyz);
    if (metric == 0) return -point.xyz / sqrt(max(point.w, 1.0e-30));
    return metric == 1 ? side : side * step(max(a.x, max(a.y, a.z)), a);
}
