// needs:
// Gradient (xyz) and value (w) of leopard. Error 4.3e-7 if sin and cos err by 1e-7.
vec4 leopardGradient(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return vec4(cos(p) * (mean * (2.0 / 3.0)), mean * mean);
}
