// needs: imageBilinear
// Mean of a picture over the footprint that the changes of uv to the pixel's right and upper neighbour span: the four texels
// as they are while it is below a texel, from there on the picture's mipmaps, with which its texture must come.
vec4 imageFiltered(sampler2D s, vec2 uv, vec2 size, vec2 right, vec2 up) {
    vec2 edges = max(abs(right), abs(up)) * size;
    float texels = max(edges.x, edges.y);
    vec4 near = imageBilinear(s, uv, size);
    if (texels <= 1.0)
        return near;
    vec4 far = textureGrad(s, uv + 0.5 / size, right, up);
    return mix(near, far, min(texels - 1.0, 1.0));
}
