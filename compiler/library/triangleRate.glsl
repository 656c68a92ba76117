// needs:
// Derivative of triangleMean by v: below an edge of 1/2 the slope of the side less what reaches over the nearest corner, at which
// it is 0; above the difference of the wave at the box's ends over its edge. Error 3e-6.
float triangleRate(float v, float edge) {
    float t = fract(fract(v) - 0.25);
    float corner = min(min(t, 1.0 - t), abs(t - 0.5));
    float over = max(0.5 * edge - corner, 0.0);
    float side = corner > 0.0 ? (t < 0.5 ? -4.0 : 4.0) : 0.0;
    float near = side * (1.0 - 2.0 * over / max(edge, 1.0e-37));
    vec2 ends = abs(4.0 * fract(vec2(t - 0.5 * edge, t + 0.5 * edge)) - 2.0);
    return edge < 0.5 ? near : (ends.y - ends.x) / max(edge, 0.25);
}
