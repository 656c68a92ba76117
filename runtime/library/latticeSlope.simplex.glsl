// needs: latticeNumbers latticeScale simplexHash simplexPlace
// Gradient of simplex noise, then its value. Error 5e-6 in each lane.
vec4 latticeSlope(vec3 cell, vec3 d) {
    vec3 first, second, third, x;
    simplexPlace(cell, d, first, second, third, x);
    uvec4 hash = simplexHash(first, second, third);
    vec4 dx = x.x + vec4(0.0, 1.0 / 6.0 - second.x, 1.0 / 3.0 - third.x, -0.5);
    vec4 dy = x.y + vec4(0.0, 1.0 / 6.0 - second.y, 1.0 / 3.0 - third.y, -0.5);
    vec4 dz = x.z + vec4(0.0, 1.0 / 6.0 - second.z, 1.0 / 3.0 - third.z, -0.5);
    vec4 t = max(0.5 - dx * dx - dy * dy - dz * dz, 0.0);
    vec4 kernel = t * t * t * t;
    vec4 value, gx, gy, gz;
    latticeNumbers(hash, value, gx, gy, gz);
    vec4 term = gx * dx + gy * dy + gz * dz;
    vec4 fall = -8.0 * t * t * t * term;
    return 71.0 * latticeScale * vec4(dot(kernel, gx) + dot(fall, dx), dot(kernel, gy) + dot(fall, dy),
                                      dot(kernel, gz) + dot(fall, dz), dot(kernel, term));
}
