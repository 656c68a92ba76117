// needs: sinc sine3 cosine3
// Gradient by p (xyz) and value (w) of leopardFiltered. Error 5e-7 if sin and cos err by 1e-7.
vec4 leopardFilteredGradient(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 left = sinc(0.5 * edge);
    vec3 leftOfTwice = sinc(edge);
    vec3 mean = sine * left;
    vec3 square = 0.5 - (0.5 - sine * sine) * leftOfTwice;
    float sum = mean.x + mean.y + mean.z;
    float value = max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
    return vec4(cosine3(p) * ((sum - mean) * left + sine * leftOfTwice) * (2.0 / 9.0), value);
}
