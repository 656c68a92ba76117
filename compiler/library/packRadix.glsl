// needs: halfFromCode
// Packs two numbers, clamped to [0, 1], into a number that is exact in a half float: x in 247
// steps, y in 248, mixed radix.
float packRadix(vec2 v) {
    vec2 q = floor(clamp(v, 0.0, 1.0) * vec2(246.0, 247.0) + 0.5);
    return halfFromCode(q.x + 247.0 * q.y);
}
