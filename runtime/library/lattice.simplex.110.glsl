// needs: latticeNumbers latticeScale simplexHash simplexPlace
// Simplex noise at a point of a cell: gradients at the four corners of a simplex, under the kernel (1/2 - r^2)^4, which ends where
// the simplex does: the noise is continuous. About [-1, 1], standard deviation 1/4, 0 at lattice points. Error 1e-6.
float lattice(vec3 cell, vec3 d) {
    vec3 first, second, third, x;
    simplexPlace(cell, d, first, second, third, x);
    vec4 hash = simplexHash(first, second, third);
    vec4 dx = x.x + vec4(0.0, 1.0 / 6.0 - second.x, 1.0 / 3.0 - third.x, -0.5);
    vec4 dy = x.y + vec4(0.0, 1.0 / 6.0 - second.y, 1.0 / 3.0 - third.y, -0.5);
    vec4 dz = x.z + vec4(0.0, 1.0 / 6.0 - second.z, 1.0 / 3.0 - third.z, -0.5);
    vec4 t = max(0.5 - dx * dx - dy * dy - dz * dz, 0.0);
    vec4 kernel = t * t * t * t;
    vec4 value, gx, gy, gz;
    latticeNumbers(hash, value, gx, gy, gz);
    return 71.0 * latticeScale * dot(kernel, gx * dx + gy * dy + gz * dz);
}
