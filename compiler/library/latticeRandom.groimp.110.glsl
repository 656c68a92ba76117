// needs:
// Entries hash to hash + 3, modulo 512, of GroIMP's random table: 512 x 1 texels RGBA32F, four
// entries each.
uniform sampler2D matc_random;
vec4 latticeRandom(float hash) {
    float index = hash - 512.0 * floor(hash * (1.0 / 512.0));
    return texture2D(matc_random, vec2((index + 0.5) * (1.0 / 512.0), 0.5));
}
