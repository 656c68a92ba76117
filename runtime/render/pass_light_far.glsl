// The pass light where lights are many: what is far as pass_gather.glsl has summed it for the pixel's group, what is near by itself. Before it stand
// lighting.glsl, far_terms.glsl and far_blocks.glsl.
uniform sampler2D light_depth;

layout(std430, binding = 5) readonly buffer FarTexels {
    vec4 far_texels[];
};

// Light that falls on a surface, at a point and with a normal.
vec3 farIrradiance(int at, vec3 point, vec3 normal)
{
    vec4 centre = far_texels[at];
    float s[FAR_TERMS];
    farSlopes((point - centre.xyz) * centre.w, normal, s);
    vec3 sum = vec3(0.0);
#define FAR_FOUR(k)                                                                                                    \
    sum += vec3(dot(far_texels[at + 1 + k], vec4(s[4 * k], s[4 * k + 1], s[4 * k + 2], s[4 * k + 3])),                 \
                dot(far_texels[at + 7 + k], vec4(s[4 * k], s[4 * k + 1], s[4 * k + 2], s[4 * k + 3])),                 \
                dot(far_texels[at + 13 + k], vec4(s[4 * k], s[4 * k + 1], s[4 * k + 2], s[4 * k + 3])));
    FAR_FOUR(0) FAR_FOUR(1) FAR_FOUR(2) FAR_FOUR(3) FAR_FOUR(4) FAR_FOUR(5)
    return max(sum, 0.0);
}

// The group of its block that a pixel is in. pass_gather.glsl counts pixels in squares of 8 x 8.
int farGroup(int block, ivec2 pixel)
{
    ivec2 p = pixel % FAR_BLOCK;
    int number = (p.y / 8 * 2 + p.x / 8) * 64 + p.y % 8 * 8 + p.x % 8;
    return int(far_words[block * FAR_WORDS + number / 32] >> (number % 32) & 1u);
}

// Those of a word's near lights whose numbers are from `first` on, and below `end`.
uint farBits(int at, int word, int first, int end)
{
    uint bits = far_words[at + word];
    int low = max(first - 32 * word, 0), high = end - 32 * word;
    bits = bits >> low << low;
    return high < 32 ? bits & ((1u << high) - 1u) : bits;
}

// Plain ones come first. A loop of its own for each kind: some compilers run both sides of a branch.
vec3 farNear(int at, Seen seen)
{
    int end = light_plain + light_points;
    vec3 sum = vec3(0.0);
    for (int word = 0; 32 * word < light_plain; word++)
        for (uint bits = farBits(at, word, 0, light_plain); bits != 0u; bits &= bits - 1u)
            sum += lightFromPlain(32 * word + findLSB(bits), seen);
#ifdef FAR_OTHERS
    for (int word = light_plain / 32; 32 * word < end; word++)
        for (uint bits = farBits(at, word, light_plain, end); bits != 0u; bits &= bits - 1u)
            sum += lightFromOther(32 * word + findLSB(bits), seen);
#endif
    return sum;
}

vec4 passPixel(ivec2 pixel)
{
    float depth = texelFetch(light_depth, pixel, 0).x;
    if (depth <= 0.0) return lightOfNothing(pixel);
    Seen seen = lightSeen(pixel, depth, unpackSurface(pixel));
    vec3 sum = lightEven(seen);
    if (farReflects(seen.m)) {
        ivec2 blocks = pixel / FAR_BLOCK;
        int block = blocks.y * far_row + blocks.x, group = farGroup(block, pixel);
        sum += surfaceEven(seen.m) * farIrradiance((block * FAR_GROUPS + group) * FAR_TEXELS, seen.point, seen.m.normal);
        sum += farNear(block * FAR_WORDS + FAR_MAP + group * FAR_NEAR, seen);
    }
    return vec4(sum, 1.0);
}
