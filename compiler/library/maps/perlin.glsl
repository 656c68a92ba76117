// needs: perlinOctave
// Octaves of Perlin's noise: the sum over k < octaves of diminish^k N(lacunarity^k p), coordinates cut at 2^24 in each. Error 2e-6 of the sum of
// |diminish|^k, where lacunarity is a power of two; else what rounding makes of the coordinates as well.
float perlin(vec3 p, int octaves, float lacunarity, float diminish, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0);
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < octaves; k++) {
        sum += strength * perlinOctave(q, dimensions);
        strength *= diminish;
        q = clamp(q * lacunarity, -16777216.0, 16777216.0);
    }
    return sum;
}
