// needs:
// Gradient (xyz; 0 on the axis) and value (w) of wood. Error 3e-7, relative for the value.
vec4 woodGradient(vec3 p) {
    vec2 a = clamp(p.xy, -1.0e37, 1.0e37);
    float greater = max(max(abs(a.x), abs(a.y)), 1.0e-37);
    vec2 unit = a / greater;
    float size = length(unit);
    return vec4(unit / max(size, 1.0), 0.0, greater * size);
}
