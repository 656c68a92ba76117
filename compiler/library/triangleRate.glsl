// needs:
// Derivative of triangleMean by v: for edge < 1/2 the slope, less the part beyond the nearest
// corner (0 at a corner); else the wave's difference between the box's ends over the edge. Error
// 3e-6.
float triangleRate(float v, float edge) {
    float t = fract(fract(v) - 0.25);
    float corner = min(min(t, 1.0 - t), abs(t - 0.5));
    float over = max(0.5 * edge - corner, 0.0);
    float side = corner > 0.0 ? (t < 0.5 ? -4.0 : 4.0) : 0.0;
    float near = side * (1.0 - 2.0 * over / max(edge, 1.0e-37));
    vec2 ends = abs(4.0 * fract(vec2(t - 0.5 * edge, t + 0.5 * edge)) - 2.0);
    return edge < 0.5 ? near : (ends.y - ends.x) / max(edge, 0.25);
}
