// needs: latticeNext latticeNumbers latticeScale simplexHash simplexPlace
// Three simplex noises at a point of a cell: the first is lattice(cell, d), the others take further hashes of the same corners.
vec3 vectorNoise(vec3 cell, vec3 d) {
    vec3 first, second, third, x;
    simplexPlace(cell, d, first, second, third, x);
    uvec4 hash = simplexHash(first, second, third);
    vec4 dx = x.x + vec4(0.0, 1.0 / 6.0 - second.x, 1.0 / 3.0 - third.x, -0.5);
    vec4 dy = x.y + vec4(0.0, 1.0 / 6.0 - second.y, 1.0 / 3.0 - third.y, -0.5);
    vec4 dz = x.z + vec4(0.0, 1.0 / 6.0 - second.z, 1.0 / 3.0 - third.z, -0.5);
    vec4 t = max(0.5 - dx * dx - dy * dy - dz * dz, 0.0);
    vec4 kernel = t * t * t * t;
    vec4 value, gx, gy, gz;
    vec3 sum;
    latticeNumbers(hash, value, gx, gy, gz);
    sum.x = dot(kernel, gx * dx + gy * dy + gz * dz);
    hash = latticeNext(hash);
    latticeNumbers(hash, value, gx, gy, gz);
    sum.y = dot(kernel, gx * dx + gy * dy + gz * dz);
    latticeNumbers(latticeNext(hash), value, gx, gy, gz);
    sum.z = dot(kernel, gx * dx + gy * dy + gz * dz);
    return 71.0 * latticeScale * sum;
}
