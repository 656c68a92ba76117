// needs: perlinOctaveGradient
// Gradient by p (xyz) and value (w) of perlin. Error 6e-6 of the sum of |diminish lacunarity|^k.
vec4 perlinGradient(vec3 p, int octaves, float lacunarity, float diminish, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0);
    float strength = 1.0;
    float frequency = 1.0;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < octaves; k++) {
        vec4 octave = perlinOctaveGradient(q, dimensions);
        sum += strength * vec4(frequency * octave.xyz, octave.w);
        strength *= diminish;
        frequency *= lacunarity;
        q = clamp(q * lacunarity, -16777216.0, 16777216.0);
    }
    return sum;
}
