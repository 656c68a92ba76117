// needs: perlinHash
// Gradient of Perlin noise at a corner, times 0.9820 (3D) or 0.6616 (2D) so that the noise is in
// about [-1, 1]: the middle of one of a cube's 12 edges (four count twice), in 2D (+-1, +-2) or
// (+-2, +-1). Exact but for the factor's rounding.
vec3 perlinDirection(vec3 corner, int dimensions) {
    float h = perlinHash(corner, dimensions);
    float pairs = floor(h * 0.5);
    float s = 1.0 - 2.0 * (h - 2.0 * pairs);
    float t = 1.0 - 2.0 * (pairs - 2.0 * floor(pairs * 0.5));
    if (dimensions < 3)
        return 0.6616 * (h - 8.0 * floor(h * 0.125) < 4.0 ? vec3(s, 2.0 * t, 0.0) : vec3(2.0 * t, s, 0.0));
    if (h < 8.0)
        return 0.982 * (h < 4.0 ? vec3(s, t, 0.0) : vec3(s, 0.0, t));
    return 0.982 * (h == 12.0 || h == 14.0 ? vec3(t, s, 0.0) : vec3(0.0, s, t));
}
