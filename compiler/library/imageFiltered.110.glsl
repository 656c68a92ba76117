// needs: imageBilinear
// Filters an image over the footprint of the pixel's uv derivatives `right` and `up`: bilinear
// below one texel, else 4 x 4 samples.
vec4 imageFiltered(sampler2D s, vec2 uv, vec2 size, vec2 right, vec2 up) {
    vec2 edges = max(abs(right), abs(up)) * size;
    if (max(edges.x, edges.y) <= 1.0)
        return imageBilinear(s, uv, size);
    vec4 sum = vec4(0.0);
    for (float i = -0.375; i < 0.5; i += 0.25)
        for (float k = -0.375; k < 0.5; k += 0.25)
            sum += imageBilinear(s, uv + i * right + k * up, size);
    return sum * (1.0 / 16.0);
}
