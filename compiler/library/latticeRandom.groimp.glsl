// needs:
// Entries hash to hash + 3, modulo 512, of GroIMP's random table: 512 x 1 texels RGBA32F, four
// entries each.
uniform highp sampler2D matc_random;
vec4 latticeRandom(int hash) {
    return texelFetch(matc_random, ivec2(hash & 511, 0), 0);
}
