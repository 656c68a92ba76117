// needs: latticeNext latticeScale simplexCorners simplexNumbers
// Three simplex noises at position d in a cell: x is lattice(cell, d); y and z use further hashes.
vec3 vectorNoise(vec3 cell, vec3 d) {
    uvec4 hash;
    vec4 dx, dy, dz;
    simplexCorners(cell, d, hash, dx, dy, dz);
    vec4 t = clamp(0.5 - dx * dx - dy * dy - dz * dz, 0.0, 1.0);
    vec4 kernel = t * t * t * t;
    vec4 gx, gy, gz;
    vec3 sum;
    simplexNumbers(hash, gx, gy, gz);
    sum.x = dot(kernel, gx * dx + gy * dy + gz * dz);
    hash = latticeNext(hash);
    simplexNumbers(hash, gx, gy, gz);
    sum.y = dot(kernel, gx * dx + gy * dy + gz * dz);
    simplexNumbers(latticeNext(hash), gx, gy, gz);
    sum.z = dot(kernel, gx * dx + gy * dy + gz * dz);
    return 71.0 * latticeScale * sum;
}
