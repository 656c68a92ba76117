// needs: sinc sine3
// Mean of leopard over a box around p: (sum of sin)^2 / 9 from the means of sin and sin^2, exact
// for independent axes. Error 4.3e-7 if sin and cos err by 1e-7.
float leopardFiltered(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 mean = sine * sinc(0.5 * edge);
    vec3 square = 0.5 - (0.5 - sine * sine) * sinc(edge);
    float sum = mean.x + mean.y + mean.z;
    return max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
}
