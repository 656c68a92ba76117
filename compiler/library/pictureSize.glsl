// needs:
// Width and height of a picture, texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
}
