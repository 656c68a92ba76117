// needs:
// Distance from the z axis, coordinates clamped to 1e37 and scaled so that no square over- or
// underflows. Relative error 2e-7.
float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
}
