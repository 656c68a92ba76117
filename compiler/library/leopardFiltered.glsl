// needs: sinc sine3
// Mean of leopard over a box around p, exact where its axes are independent: (sum of sin)^2 / 9 from the means of sin and sin^2.
// Error 4.3e-7 where sin and cos have 1e-7.
float leopardFiltered(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 mean = sine * sinc(0.5 * edge);
    vec3 square = 0.5 - (0.5 - sine * sine) * sinc(edge);
    float sum = mean.x + mean.y + mean.z;
    return max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
}
