// needs:
// GroIMP's permutation of [0, 65536): 256 x 256 texels R32F, entry i at (i mod 256, i / 256),
// nearest filter.
uniform sampler2D matc_permutation;
float latticePermutation(float i) {
    float row = floor(i * (1.0 / 256.0));
    return texture2D(matc_permutation, (vec2(i - 256.0 * row, row) + 0.5) * (1.0 / 256.0)).r;
}
