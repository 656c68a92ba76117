// The pass light with light clustering: distant lights by the sums of pass_light_cluster.glsl for
// the pixel's group, near lights one by one. Preceded by lighting.glsl, far_terms.glsl and
// far_blocks.glsl.
uniform sampler2D light_depth;

// buffer textures: some software renderers serialize reads of storage buffers
uniform samplerBuffer far_texels;
uniform usamplerBuffer far_bits;

vec4 farTexel(int i) { return texelFetch(far_texels, i); }

uint farWord(int i) { return texelFetch(far_bits, i).x; }

// Returns the irradiance of distant lights at a point with a normal.
vec3 farIrradiance(int at, vec3 point, vec3 normal)
{
    vec4 centre = farTexel(at + FAR_CENTER);
    float s[FAR_TERMS];
    farSlopes((point - centre.xyz) * centre.w, normal, s);
    vec3 sum = vec3(0.0);
    vec4 four;
#define FAR_FOUR(k) \
    four = vec4(s[4 * k], s[4 * k + 1], s[4 * k + 2], s[4 * k + 3]); \
    sum += vec3(dot(farTexel(at + FAR_SUMS + k), four), \
        dot(farTexel(at + FAR_SUMS + FAR_QUADS + k), four), \
        dot(farTexel(at + FAR_SUMS + 2 * FAR_QUADS + k), four));
    FAR_FOUR(0) FAR_FOUR(1) FAR_FOUR(2) FAR_FOUR(3) FAR_FOUR(4) FAR_FOUR(5)
    FAR_FOUR(6) FAR_FOUR(7) FAR_FOUR(8) FAR_FOUR(9) FAR_FOUR(10) FAR_FOUR(11)
    return max(sum, 0.0);
}

#ifdef SURFACE_HAS_specular
// Specular light of distant lights for reflectance 1, at a point with a mirrored view.
vec3 farSpecular(int at, vec3 point, vec3 mirror)
{
    vec4 centre = farTexel(at + FAR_CENTER), u = vec4((point - centre.xyz) * centre.w, 1.0);
    vec4 red = farTexel(at + FAR_MIRROR), green = farTexel(at + FAR_MIRROR + 1),
        blue = farTexel(at + FAR_MIRROR + 2);
    vec3 turn = mirror - vec3(red.w, green.w, blue.w);
    vec3 sum = vec3(dot(farTexel(at + FAR_SPECULAR), u), dot(farTexel(at + FAR_SPECULAR + 1), u),
        dot(farTexel(at + FAR_SPECULAR + 2), u));
    return max(sum + vec3(dot(red.xyz, turn), dot(green.xyz, turn), dot(blue.xyz, turn)), 0.0);
}
#endif

// Group of a pixel in its block, by the pixel numbers of pass_groups.glsl: the pixels of an
// invocation are 8 apart.
int farGroup(int block, ivec2 pixel)
{
    ivec2 p = pixel % FAR_BLOCK, q = p / 8, own = p % 8;
    return int(farWord(block * FAR_WORDS + 8 * own.y + own.x) >> 2 * (q.y * FAR_SPAN + q.x) & 3u);
}

#ifdef FAR_OTHERS
// Mask of the lowest n bits.
uint farLowest(int n) { return n >= 32 ? 0xffffffffu : (1u << max(n, 0)) - 1u; }
#endif

// Selects the plain lights of a word.
uint farPlain(int word, uint lights)
{
#ifdef FAR_OTHERS
    return lights & farLowest(light_plain - 32 * word);
#else
    return lights;
#endif
}

// Sums the near lights, skipping words that are 0. Each kind has a loop of its own: some compilers
// execute both sides of a branch.
vec3 farNear(int at, Seen seen)
{
    vec3 sum = vec3(0.0);
    for (int top = 0; top < FAR_TOPS; top++)
        for (uint words = farWord(at + top); words != 0u; words &= words - 1u) {
            int word = 32 * top + findLSB(words);
            uint lights = farWord(at + FAR_TOPS + word);
            for (uint bits = farPlain(word, lights); bits != 0u; bits &= bits - 1u)
                sum += lightFromPlain(32 * word + findLSB(bits), seen);
#ifdef FAR_OTHERS
            for (uint bits = lights & ~farPlain(word, lights); bits != 0u; bits &= bits - 1u)
                sum += lightFromOther(32 * word + findLSB(bits), seen);
#endif
        }
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
        int at = (block * FAR_GROUPS + group) * FAR_TEXELS;
        sum += surfaceEven(seen.m) * farIrradiance(at, seen.point, seen.m.normal);
#ifdef SURFACE_HAS_specular
        sum += surfaceSpecular(seen.m) * farSpecular(at, seen.point, surfaceMirror(seen.m));
#endif
        sum += farNear(block * FAR_WORDS + FAR_MAP + group * FAR_MARKS, seen);
    }
    return vec4(sum, 1.0);
}
