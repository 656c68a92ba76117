// needs:
// Width and height of an image in texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
}
