// needs: latticeNext latticeScale simplexCorners simplexNumbers
// Derivative of the vector noise along a direction.
vec3 vectorNoiseAlong(vec3 cell, vec3 d, vec3 direction) {
    uvec4 hash;
    vec4 dx, dy, dz;
    simplexCorners(cell, d, hash, dx, dy, dz);
    vec4 t = clamp(0.5 - dx * dx - dy * dy - dz * dz, 0.0, 1.0);
    vec4 kernel = t * t * t * t;
    vec4 fall = -8.0 * t * t * t * (dx * direction.x + dy * direction.y + dz * direction.z);
    vec4 gx, gy, gz;
    vec3 sum;
    for (int i = 0; i < 3; i++) {
        simplexNumbers(hash, gx, gy, gz);
        sum.x = sum.y;
        sum.y = sum.z;
        sum.z = dot(kernel, gx * direction.x + gy * direction.y + gz * direction.z)
              + dot(fall, gx * dx + gy * dy + gz * dz);
        hash = latticeNext(hash);
    }
    return 71.0 * latticeScale * sum;
}
