// Where pixels' surfaces are, and which pixel shows a point; what is random from pixel to pixel. The eye's space; places of the picture in pixels,
// whose middles lie at .5.
uniform sampler2D indirect_depth; // near over distance, or 1 to 0 where orthographic; 0: nothing is there
layout(std140) uniform Indirect {
    vec4 indirect_ray, indirect_view; // of view_space.h
    vec4 indirect_reach;              // x: radius; y: how far off the surface rays begin, and z: the same in pixels; w: contrast
    vec4 indirect_models;             // x: how far the picture is asked, of hybrid; y: how thick what it shows is
    vec4 indirect_picture;            // xy: its size in pixels
    vec4 indirect_samples[INDIRECT_RAYS];
};

bool indirectIsOrthographic() { return indirect_view.y > 0.0; }

// Of a surface whose depth is greater than 0.
vec3 indirectPoint(ivec2 pixel, float depth)
{
    vec3 ray = vec3((vec2(2 * pixel + 1) - indirect_ray.zw) * indirect_ray.xy, -1.0);
    return indirectIsOrthographic() ? vec3(ray.xy, (depth - 1.0) * indirect_view.x) : ray * (indirect_view.x / depth);
}

// Where the picture shows a point that lies before the eye.
vec2 indirectPlace(vec3 point)
{
    vec2 flat_ = indirectIsOrthographic() ? point.xy : point.xy / -point.z;
    return 0.5 * (flat_ / indirect_ray.xy + indirect_ray.zw);
}

// Of a pixel, at a point: its width in space.
float indirectPixelSize(vec3 point)
{
    return 2.0 * indirect_ray.x * (indirectIsOrthographic() ? 1.0 : -point.z);
}

// A point lies behind the surface that a pixel shows.
bool indirectIsBehind(vec3 point, float depth)
{
    return indirectIsOrthographic() ? point.z < (depth - 1.0) * indirect_view.x : -point.z * depth > indirect_view.x;
}

// O'Neill's PCG with two lanes (Jarzynski and Olano 2020): two numbers from 0 to 1 for a pair of whole ones.
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

// The shift of a pixel's samples, modulo 1, and what its first step is short of a whole one.
//
// Of n samples (i / n, mirrored bits of i) in a tile of 4 x 4 pixels: pixel k's are shifted by (k / (16 n), mirrored bits of k), so that all of the
// tile's are 16 n that are as even as those of one pixel. All tiles are alike: the mean over any 4 x 4 pixels has just these.
//
// Samples behind the first are shifted on by steps of the plastic number, 1 / p and 1 / p^2, which fill a square evenly (Roberts 2018).
vec3 indirectShift(ivec2 pixel, int number)
{
    uvec2 at = uvec2(pixel), seed = at + uvec2(0u, 65536u * uint(number));
    vec3 more = float(number) * vec3(0.7548777, 0.5698403, 0.6180340);
#if INDIRECT_ROTATION == 2
    uvec2 low = at & 3u, mixed = low ^ low.yx;
    uint k = (mixed.x & 1u) << 3u | (low.y & 1u) << 2u | (mixed.x & 2u) | low.y >> 1u; // the order of Bayer's matrix
    uint mirrored = (k & 1u) << 3u | (k & 2u) << 1u | (k & 4u) >> 1u | k >> 3u;
    return vec3(float(k) / float(16 * INDIRECT_RAYS), float(mirrored) / 16.0, float(k * 7u & 15u) / 16.0) + more;
#elif INDIRECT_ROTATION == 1
    return vec3(indirectRandom(seed), indirectRandom(seed.yx + 7919u).x);
#else
    return vec3(0.0, 0.0, indirectRandom(seed.yx + 7919u).x) + more;
#endif
}

// Two vectors that are at right angles to a unit vector and to each other (Duff et al. 2017).
void indirectBasis(vec3 n, out vec3 u, out vec3 v)
{
    float side = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (side + n.z), b = n.x * n.y * a;
    u = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    v = vec3(b, side + n.y * n.y * a, -n.y);
}

// The direction of a sample of the unit square, the normal being z: as dense as its cosine, or everywhere alike.
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

// What is kept off by something at a share of the radius.
float indirectWeight(float t)
{
#if INDIRECT_WEIGHT == 1
    return max(1.0 - t, 0.0);
#elif INDIRECT_WEIGHT == 2
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

// What a ray meets.
struct IndirectHit {
    float t;     // share of the radius to it; less than 0: nothing
    ivec2 pixel; // that shows it; less than 0: none
};

// Of one pixel of INDIRECT_COARSE x INDIRECT_COARSE of the picture: for which of these rays go out.
ivec2 indirectPixel(ivec2 small) { return min(small * INDIRECT_COARSE + INDIRECT_COARSE / 2, ivec2(indirect_picture.xy) - 1); }

#ifdef INDIRECT_LIGHT
uniform sampler2D indirect_light;
#ifdef INDIRECT_AGAIN
uniform sampler2D indirect_before; // what bounces before this one found
#endif

// What the surface of a pixel sends against a way, of light and of the bounces before; nothing if the side that is seen is turned away.
vec3 indirectSent(ivec2 pixel, vec3 way)
{
    if (dot(indirectNormal(pixel), way) >= 0.0) return vec3(0.0);
    vec3 light = texelFetch(indirect_light, pixel, 0).xyz;
#ifdef INDIRECT_AGAIN
    light += surfaceEven(surfaceLit(unpackSurface(pixel), -normalize(way))) * texelFetch(indirect_before, pixel, 0).xyz;
#endif
    return light;
}
#endif
