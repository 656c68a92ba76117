// needs: magnitudeShare noiseSlope noiseStatistics
// Gradient by p (xyz) and value (w) of graniteFiltered(p, rest, width). Error 1e-4.
vec4 graniteGradient(vec3 p, vec3 rest, float width) {
    float frequency = 4.0;
    float strength = 1.0;
    vec4 sum = vec4(0.0, 0.0, 0.0, (noiseMagnitude - 0.5) * (63.0 / 32.0));
    for (int k = 0; k < 6; k++) {
        float share = magnitudeShare(frequency * width);
        if (share <= 0.0) break;
        vec4 octave = noiseSlope(frequency * p, frequency * rest);
        octave *= octave.w < 0.0 ? -1.0 : 1.0;
        sum += strength * share * vec4(frequency * octave.xyz, octave.w - noiseMagnitude);
        strength *= 0.5;
        frequency *= 2.0;
    }
    return sum;
}
