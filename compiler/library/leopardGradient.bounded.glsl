// needs: cosineBounded sineBounded
// Gradient (xyz) and value (w) of leopard. Error 4.3e-7.
vec4 leopardGradient(vec3 p) {
    float mean = (sineBounded(p.x) + sineBounded(p.y) + sineBounded(p.z)) * (1.0 / 3.0);
    return vec4(vec3(cosineBounded(p.x), cosineBounded(p.y), cosineBounded(p.z)) * (mean * (2.0 / 3.0)), mean * mean);
}
