// needs: latticeScale simplexCorners simplexNumbers
// Simplex noise at position d in a cell: gradients at a simplex' four corners, kernel (1/2 -
// r^2)^4, which is 0 at the simplex' border: continuous. About [-1, 1], standard deviation 1/4, 0
// at lattice points. Error 1e-6. clamp() to [0, 1] is free on GPUs, max() with 0 is not.
float lattice(vec3 cell, vec3 d) {
    uvec4 hash;
    vec4 dx, dy, dz;
    simplexCorners(cell, d, hash, dx, dy, dz);
    vec4 t = clamp(0.5 - dx * dx - dy * dy - dz * dz, 0.0, 1.0);
    vec4 kernel = t * t * t * t;
    vec4 gx, gy, gz;
    simplexNumbers(hash, gx, gy, gz);
    return 71.0 * latticeScale * dot(kernel, gx * dx + gy * dy + gz * dz);
}
