// needs: latticeCell octaveShare vectorNoiseAlong
// Derivative of vectorTurbulenceFiltered(p, rest, ...) along a direction. Error of
// turbulenceGradient, times |direction|.
vec3 vectorTurbulenceAlong(vec3 p, vec3 rest, int octaves, float frequencyRatio, float noiseRatio, float width,
                           vec3 direction) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; k++) {
        float share = octaveShare(width);
        if (share <= 0.0 && abs(frequencyRatio) >= 1.0) break;
        vec3 cell, d;
        latticeCell(p, rest, cell, d);
        sum += strength * share * vectorNoiseAlong(cell, d, direction);
        strength *= noiseRatio * frequencyRatio;
        p *= frequencyRatio;
        rest *= frequencyRatio;
        width *= abs(frequencyRatio);
    }
    return sum;
}
