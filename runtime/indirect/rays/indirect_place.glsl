// Conversions between pixels and points of surfaces, and per-pixel random numbers. Points are in
// eye space; positions in the picture are in pixels, whose centers lie at .5.
// near / distance, or 1 to 0 in an orthographic view; 0: background
uniform sampler2D indirect_depth;
layout(std140) uniform Indirect {
#include "indirect.layout.def"
    // sample points; z: third coordinate, for the method points
    vec4 indirect_samples[INDIRECT_RAYS];
#ifdef INDIRECT_ROTATION_blue
    uvec4 indirect_shifts[INDIRECT_SHIFTS]; // random shifts as blue noise ranks, two per component
#elif defined INDIRECT_ROTATION_tile
    vec4 indirect_shifts[INDIRECT_SHIFTS]; // random shifts of a tile's pixels
#endif
};

bool indirectIsOrthographic() { return indirect_view.y > 0.0; }

// Returns the eye-space point of a pixel's surface; depth > 0.
vec3 indirectPoint(ivec2 pixel, float depth)
{
    vec3 ray = vec3((vec2(2 * pixel + 1) - indirect_ray.zw) * indirect_ray.xy, -1.0);
    return indirectIsOrthographic() ? vec3(ray.xy, (depth - 1.0) * indirect_view.x)
        : ray * (indirect_view.x / depth);
}

// Returns the position in the picture of a point before the eye.
vec2 indirectPlace(vec3 point)
{
    vec2 flat_ = indirectIsOrthographic() ? point.xy : point.xy / -point.z;
    return 0.5 * (flat_ / indirect_ray.xy + indirect_ray.zw);
}

// Lower bound of the picture within the tile: the guard band may extend past the picture's border.
vec2 indirectLow() { return max(-indirect_models.zw, vec2(0.0)); }
bool indirectIsShown(vec2 place)
{
    return all(greaterThanEqual(place, indirectLow())) && all(lessThan(place, indirect_picture.xy));
}

// Returns the width of a pixel in eye-space units, at a point.
float indirectPixelSize(vec3 point)
{
    return 2.0 * indirect_ray.x * (indirectIsOrthographic() ? 1.0 : -point.z);
}

// Reports whether a point lies behind the surface of a pixel.
bool indirectIsBehind(vec3 point, float depth)
{
    return indirectIsOrthographic() ? point.z < (depth - 1.0) * indirect_view.x : -point.z * depth >
        indirect_view.x;
}

// Hashes a pair of integers to two numbers in [0, 1): O'Neill's PCG in two dimensions (Jarzynski
// and Olano 2020).
vec2 indirectRandom(uvec2 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    return vec2(v >> 8u) / 16777216.0;
}

// Shift of a pixel's samples (indirect_sequence.h), and a further shift for each set of samples:
// for Sobol's sequence in tiles as described there; otherwise multiples of 1 / p and 1 / p^2, p the
// plastic number, which fill a square evenly (Roberts 2018), and of the golden ratio.
struct IndirectShift {
    // shifts in xy: both are applied by exclusive or, or both by addition modulo 1
    vec3 at, more;
};

#ifdef INDIRECT_ROTATION_blue
float indirectBlue(ivec2 pixel)
{
    int i = (pixel.y & 63) << 6 | (pixel.x & 63);
    uvec4 ranks = indirect_shifts[i >> 3];
    return (float(ranks[i >> 1 & 3] >> uint(i & 1) * 16u & 0xFFFFu) + 0.5) / 4096.0;
}
#endif

#ifdef INDIRECT_TURNS_BITS
// The first 16 bits of a sample of Sobol's sequence (indirect_sequence.h).
vec2 indirectSobol(uint number)
{
    uvec2 bits = uvec2(0u), more = uvec2(32768u);
    for (; number != 0u; number >>= 1) {
        if ((number & 1u) != 0u) bits ^= more;
        more = uvec2(more.x >> 1, more.y ^ more.y >> 1);
    }
    return vec2(bits) / 65536.0;
}
#endif

IndirectShift indirectShift(ivec2 here, int number)
{
    ivec2 pixel = here + ivec2(indirect_models.zw);
    vec3 more = fract(float(number) * vec3(0.7548777, 0.5698403, 0.6180340));
#ifdef INDIRECT_TURNS_BITS
    more.xy = indirectSobol(uint(number * INDIRECT_BLOCK));
#endif
#ifdef INDIRECT_ROTATION_blue
    return IndirectShift(vec3(indirectBlue(pixel), indirectBlue(pixel + ivec2(21, 43)),
        indirectBlue(pixel + ivec2(43, 21))), more);
#elif defined INDIRECT_ROTATION_tile
    ivec2 low = pixel & (INDIRECT_TILE - 1);
    return IndirectShift(indirect_shifts[low.y * INDIRECT_TILE + low.x].xyz, more);
#else
    uvec2 seed = uvec2(pixel);
#ifdef INDIRECT_ROTATION_random
    seed.y += 65536u * uint(number);
#endif
    vec3 at = vec3(indirectRandom(seed), indirectRandom(seed.yx + 7919u).x);
#ifdef INDIRECT_ROTATION_random
    return IndirectShift(at, vec3(0.0));
#else
    return IndirectShift(vec3(0.0, 0.0, at.z), more);
#endif
#endif
}

vec2 indirectSample(int i, IndirectShift shift)
{
#ifdef INDIRECT_TURNS_BITS
    return vec2(uvec2(65536.0 * indirect_samples[i].xy) ^ uvec2(65536.0 *
        shift.at.xy) ^ uvec2(65536.0 * shift.more.xy)) / 65536.0;
#else
    return fract(indirect_samples[i].xy + shift.at.xy + shift.more.xy);
#endif
}

// Maps a sample of the unit square to a direction around the normal z: importance sampling of the
// cosine (density cos / pi), or, with INDIRECT_UNIFORM, uniform over the hemisphere (density 1 / (2
// pi)).
vec3 indirectDirection(vec2 s)
{
#ifdef INDIRECT_UNIFORM
    float z = 1.0 - s.x, r = sqrt(max(1.0 - z * z, 0.0));
#else
    float z = sqrt(1.0 - s.x), r = sqrt(s.x);
#endif
    float turn = 6.28318530717959 * s.y;
    return vec3(r * cos(turn), r * sin(turn), z);
}

// Returns the occlusion by a hit at a share t of the ray length, in [0, 1].
float indirectWeight(float t)
{
#ifdef INDIRECT_WEIGHT_linear
    return max(1.0 - t, 0.0);
#elif defined INDIRECT_WEIGHT_quadratic
    return max(1.0 - t * t, 0.0);
#else
    return 1.0;
#endif
}

vec3 indirectNormal(ivec2 pixel)
{
#ifdef SURFACE_HAS_normal
    return unpackSurface(pixel).normal;
#else
    return vec3(0.0, 0.0, 1.0);
#endif
}

// The hit of a ray: its distance, the pixel that shows it, and further radiance.
struct IndirectHit {
    float t;     // distance as a share of the ray length; < 0: no hit
    ivec2 pixel; // pixel that shows the hit; < 0: none
    vec3 sent;   // radiance from the radiance cache, added to the pixel's
};

// Returns the pixel of the picture from which a pixel of the ray pass traces its rays.
ivec2 indirectPixel(ivec2 small)
{
    return min(small * INDIRECT_COARSE + INDIRECT_COARSE / 2, ivec2(indirect_picture.xy) - 1);
}

#ifdef INDIRECT_LIGHT
uniform sampler2D indirect_light;
#ifdef INDIRECT_AGAIN
uniform sampler2D indirect_before; // light of the previous bounces
#endif

// Returns the radiance that a pixel's surface sends against the direction `way`, with previous
// bounces; 0 if its visible side faces away.
vec3 indirectSent(ivec2 pixel, vec3 way)
{
    if (dot(indirectNormal(pixel), way) >= 0.0) return vec3(0.0);
    vec3 light = texelFetch(indirect_light, pixel, 0).xyz;
#ifdef INDIRECT_AGAIN
    light += surfaceEven(surfaceLit(unpackSurface(pixel), -normalize(way))) *
        texelFetch(indirect_before, pixel, 0).xyz;
#endif
    return light;
}
#endif
