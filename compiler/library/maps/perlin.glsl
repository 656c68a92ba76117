// needs: perlinOctave
// Fractal Perlin noise: the sum over k < octaves of diminish^k N(lacunarity^k p), coordinates
// clamped to 2^24. Error 2e-6 of the sum of |diminish|^k if lacunarity is a power of two; otherwise
// rounding of coordinates adds to it.
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
