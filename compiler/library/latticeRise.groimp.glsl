// needs: latticeMix latticeNumbers
// Gradient (xyz) and value (w) of the interpolation of eight hashed corners, before latticeScale.
vec4 latticeRise(ivec4 low, ivec4 high, vec3 d) {
    vec4 v0, x0, y0, z0, v1, x1, y1, z1;
    latticeNumbers(low, v0, x0, y0, z0);
    latticeNumbers(high, v1, x1, y1, z1);
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    vec4 t0 = 0.5 * v0 + x0 * dx + y0 * dy + z0 * d.z;
    vec4 t1 = 0.5 * v1 + x1 * dx + y1 * dy + z1 * (d.z - 1.0);
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec3 rise = 6.0 * d * (1.0 - d);
    vec4 plane = mix(t0, t1, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    vec2 across = mix(plane.xz, plane.yw, s.x);
    vec2 depth = mix((t1 - t0).xy, (t1 - t0).zw, s.y);
    return vec4(latticeMix(x0, x1, d) + rise.x * (line.y - line.x),
                latticeMix(y0, y1, d) + rise.y * (across.y - across.x),
                latticeMix(z0, z1, d) + rise.z * mix(depth.x, depth.y, s.x), mix(line.x, line.y, s.x));
}
