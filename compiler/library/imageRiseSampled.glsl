// needs:
// Finite difference of one component of the filtered texture over one texel along u and v, per unit
// of uv.
vec2 imageRiseSampled(sampler2D s, vec2 uv, vec2 size, int component, vec2 right, vec2 up) {
    vec2 at = uv + 0.5 / size;
    float here = textureGrad(s, at, right, up)[component];
    float beyondU = textureGrad(s, at + vec2(1.0 / size.x, 0.0), right, up)[component];
    float beyondV = textureGrad(s, at + vec2(0.0, 1.0 / size.y), right, up)[component];
    return (vec2(beyondU, beyondV) - here) * size;
}
