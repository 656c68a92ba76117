// needs:
// v / |v| for every finite v; (0, 0, 1) if all components are below 1e-37. v is divided by its
// largest component, so no square over- or underflows; large vectors are scaled down first, so the
// reciprocal does not underflow. Relative error 2e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}
