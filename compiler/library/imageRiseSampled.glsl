// needs:
// Finite difference of the filtered texture's component `lane` over one texel along u and v, per
// unit of uv.
vec2 imageRiseSampled(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 at = uv + 0.5 / size;
    float here = textureGrad(s, at, right, up)[lane];
    float beyondU = textureGrad(s, at + vec2(1.0 / size.x, 0.0), right, up)[lane];
    float beyondV = textureGrad(s, at + vec2(0.0, 1.0 / size.y), right, up)[lane];
    return (vec2(beyondU, beyondV) - here) * size;
}
