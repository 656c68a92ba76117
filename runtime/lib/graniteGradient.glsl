// needs: magnitudeShare noiseSlope noiseStatistics
// Gradient by p of graniteFiltered(p, rest, width), then its value. Error 1e-4.
vec4 graniteGradient(vec3 p, vec3 rest, float width) {
    float frequency = 4.0;
    float strength = 1.0;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 6; k++) {
        float share = magnitudeShare(frequency * width);
        vec4 magnitude = vec4(0.0, 0.0, 0.0, noiseMagnitude);
        if (share > 0.0) {
            vec4 octave = noiseSlope(frequency * p, frequency * rest);
            octave.xyz *= frequency;
            magnitude = mix(magnitude, octave * (octave.w < 0.0 ? -1.0 : 1.0), share);
        }
        sum += strength * (magnitude - vec4(0.0, 0.0, 0.0, 0.5));
        strength *= 0.5;
        frequency *= 2.0;
    }
    return sum;
}
