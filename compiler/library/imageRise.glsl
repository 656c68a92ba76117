// needs: texel texelsRise
// Finite difference of imageBilinear(s, uv, size)[lane] over one texel along u and v, per unit of
// uv. Reads eight texels instead of twelve. Error 6e-7 * size.
vec3 imageRiseRow(sampler2D s, vec3 x, float y, vec2 size, int lane) {
    return vec3(texel(s, vec2(x.x, y), size)[lane], texel(s, vec2(x.y, y), size)[lane], texel(s, vec2(x.z, y), size)[lane]);
}

vec2 imageRise(sampler2D s, vec2 uv, vec2 size, int lane) {
    vec2 at = fract(uv) * size;
    vec2 low = floor(at);
    vec2 weight = at - low;
    low -= size * step(size, low);
    vec2 next = low + 1.0;
    next -= size * step(size, next);
    vec2 last = next + 1.0;
    last -= size * step(size, last);
    vec3 x = vec3(low.x, next.x, last.x);
    return texelsRise(imageRiseRow(s, x, low.y, size, lane), imageRiseRow(s, x, next.y, size, lane),
                      imageRiseRow(s, x, last.y, size, lane), weight) * size;
}
