// needs: latticeNumbers latticeScale simplexCorners
// Gradient (xyz) and value (w) of simplex noise. Error 5e-6.
vec4 latticeSlope(vec3 cell, vec3 d) {
    vec4 hash;
    vec4 dx, dy, dz;
    simplexCorners(cell, d, hash, dx, dy, dz);
    vec4 t = clamp(0.5 - dx * dx - dy * dy - dz * dz, 0.0, 1.0);
    vec4 kernel = t * t * t * t;
    vec4 value, gx, gy, gz;
    latticeNumbers(hash, value, gx, gy, gz);
    vec4 term = gx * dx + gy * dy + gz * dz;
    vec4 fall = -8.0 * t * t * t * term;
    return 71.0 * latticeScale * vec4(dot(kernel, gx) + dot(fall, dx), dot(kernel, gy) + dot(fall, dy),
                                      dot(kernel, gz) + dot(fall, dz), dot(kernel, term));
}
