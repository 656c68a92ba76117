// needs: halfFromCode
// Two numbers, taken to [0, 1], in one number that a half float holds exactly: x rounded to 247 steps, y to 248, by mixed radix.
float packRadix(vec2 v) {
    vec2 q = floor(clamp(v, 0.0, 1.0) * vec2(246.0, 247.0) + 0.5);
    return halfFromCode(q.x + 247.0 * q.y);
}
