// needs:
// ((sin x + sin y + sin z) / 3)^2, in [0, 1]. Error of sin(): 3e-7 on llvmpipe up to 1e6; GLSL has
// no bound.
float leopard(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return mean * mean;
}
