// needs: imageBilinear
// Filters an image over the footprint of the pixel's uv derivatives `right` and `up`: bilinear
// below one texel, else by the mipmaps, which the texture must have.
vec4 imageFiltered(sampler2D s, vec2 uv, vec2 size, vec2 right, vec2 up) {
    vec2 edges = max(abs(right), abs(up)) * size;
    float texels = max(edges.x, edges.y);
    vec4 near = imageBilinear(s, uv, size);
    if (texels <= 1.0)
        return near;
    vec4 far = textureGrad(s, uv + 0.5 / size, right, up);
    return mix(near, far, min(texels - 1.0, 1.0));
}
