// needs: latticeNext latticeNumbers latticeScale simplexHash simplexPlace
// Derivative of the vector noise along a direction.
vec3 vectorNoiseAlong(vec3 cell, vec3 d, vec3 direction) {
    vec3 first, second, third, x;
    simplexPlace(cell, d, first, second, third, x);
    uvec4 hash = simplexHash(first, second, third);
    vec4 dx = x.x + vec4(0.0, 1.0 / 6.0 - second.x, 1.0 / 3.0 - third.x, -0.5);
    vec4 dy = x.y + vec4(0.0, 1.0 / 6.0 - second.y, 1.0 / 3.0 - third.y, -0.5);
    vec4 dz = x.z + vec4(0.0, 1.0 / 6.0 - second.z, 1.0 / 3.0 - third.z, -0.5);
    vec4 t = max(0.5 - dx * dx - dy * dy - dz * dz, 0.0);
    vec4 kernel = t * t * t * t;
    vec4 fall = -8.0 * t * t * t * (dx * direction.x + dy * direction.y + dz * direction.z);
    vec4 value, gx, gy, gz;
    vec3 sum;
    for (int i = 0; i < 3; i++) {
        latticeNumbers(hash, value, gx, gy, gz);
        sum.x = sum.y;
        sum.y = sum.z;
        sum.z = dot(kernel, gx * direction.x + gy * direction.y + gz * direction.z)
              + dot(fall, gx * dx + gy * dy + gz * dz);
        hash = latticeNext(hash);
    }
    return 71.0 * latticeScale * sum;
}
