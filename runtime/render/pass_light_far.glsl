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

int farPlace(int at, int i) { return int(far_words[at + 1 + i / 2] >> (i % 2 * 16) & 0xffffu); }

// Plain ones come first. A loop of its own for each kind: some compilers run both sides of a branch.
vec3 farNear(int at, Seen seen)
{
    int count = int(far_words[at]), i = 0;
    vec3 sum = vec3(0.0);
    for (int light; i < count && (light = farPlace(at, i)) < light_plain; i++)
        sum += lightFromPlain(light, seen);
#ifdef FAR_OTHERS
    for (; i < count; i++)
        sum += lightFromOther(farPlace(at, i), seen);
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
        int list = block * FAR_WORDS + FAR_MAP + group * FAR_LIST;
        if (far_words[list] > uint(FAR_MOST)) return vec4(sum + lightFromAll(seen), 1.0);
        sum += surfaceEven(seen.m) * farIrradiance((block * FAR_GROUPS + group) * FAR_TEXELS, seen.point, seen.m.normal);
        sum += farNear(list, seen);
    }
    return vec4(sum, 1.0);
}
