// Simplex noise as in most shaders on the web: McEwan, Sheets, Gustavson, Richardson, "Efficient
// computational noise in GLSL" (2012). Corners are hashed by the permutation polynomial (34 x + 1)
// x mod 289; gradients are 7 x 7 points of an octahedron.
vec3 residue(vec3 x) { return x - 289.0 * floor(x * (1.0 / 289.0)); }
vec4 residue(vec4 x) { return x - 289.0 * floor(x * (1.0 / 289.0)); }
vec4 permuted(vec4 x) { return residue((34.0 * x + 1.0) * x); }
float noise(vec3 p) {
    vec3 cell = floor(p + dot(p, vec3(1.0 / 3.0)));
    vec3 x0 = p - cell + dot(cell, vec3(1.0 / 6.0));
    vec3 greater = step(x0.yzx, x0.xyz);
    vec3 less = 1.0 - greater;
    vec3 second = min(greater, less.zxy);
    vec3 third = max(greater, less.zxy);
    vec3 x1 = x0 - second + 1.0 / 6.0;
    vec3 x2 = x0 - third + 1.0 / 3.0;
    vec3 x3 = x0 - 0.5;
    cell = residue(cell);
    vec4 h = permuted(cell.z + vec4(0.0, second.z, third.z, 1.0));
    h = permuted(h + cell.y + vec4(0.0, second.y, third.y, 1.0));
    h = permuted(h + cell.x + vec4(0.0, second.x, third.x, 1.0));
    vec4 j = h - 49.0 * floor(h * (1.0 / 49.0));
    vec4 row = floor(j * (1.0 / 7.0));
    vec4 x = row * (2.0 / 7.0) - 13.0 / 14.0;
    vec4 y = floor(j - 7.0 * row) * (2.0 / 7.0) - 13.0 / 14.0;
    vec4 z = 1.0 - abs(x) - abs(y);
    vec4 fold = -step(z, vec4(0.0));
    x += (floor(x) * 2.0 + 1.0) * fold;
    y += (floor(y) * 2.0 + 1.0) * fold;
    vec4 scale = 1.79284291400159 - 0.85373472095314 * (x * x + y * y + z * z);
    vec4 t = max(0.5 - vec4(dot(x0, x0), dot(x1, x1), dot(x2, x2), dot(x3, x3)), 0.0);
    t *= t;
    vec4 dx = vec4(x0.x, x1.x, x2.x, x3.x), dy = vec4(x0.y, x1.y, x2.y, x3.y),
        dz = vec4(x0.z, x1.z, x2.z, x3.z);
    return 105.0 * dot(t * t, scale * (x * dx + y * dy + z * dz));
}
