// needs: latticeCell latticeSlope
// Gradient (xyz) and value (w) of noise(p + rest); the gradient is 0 where noise is clamped.
vec4 noiseSlope(vec3 p, vec3 rest) {
    vec3 cell, d;
    latticeCell(p, rest, cell, d);
    vec4 slope = 2.0 * latticeSlope(cell, d);
    return abs(slope.w) < 1.0 ? slope : vec4(0.0, 0.0, 0.0, sign(slope.w));
}
