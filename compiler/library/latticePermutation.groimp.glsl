// needs:
// GroIMP's permutation of [0, 65536): 256 x 256 texels R32F, entry i at (i mod 256, i / 256).
uniform highp sampler2D matc_permutation;
int latticePermutation(int i) {
    return int(texelFetch(matc_permutation, ivec2(i & 255, i >> 8), 0).r);
}
