// A step of a reduction: a block of texels becomes one. The first step turns pixels into the three
// texels of tone.glsl, side by side; further steps reduce these triples.
layout(std140) uniform Measure {
    int measure_width, measure_height; // size of the picture, in pixels or in triples of texels
    int measure_first;                 // 1: the input has pixels
    int measure_x, measure_y;          // first pixel or triple that counts
};
uniform sampler2D measure_from;

const int BLOCK = 16;

vec4 measureOf(int what, vec3 c)
{
#ifdef MEASURE_ADAPTED
    c = toneAdapted(c);
    return vec4(c, min(min(c.x, c.y), c.z));
#else
    float luminance = toneLuminance(c);
    bool counts = luminance > LEAST;
    return what < 2 ? vec4(c, luminance) : counts ? vec4(log(luminance), 1.0, luminance, luminance)
        : vec4(0.0, 0.0, GREATEST, GREATEST);
#endif
}

vec4 passPixel(ivec2 place)
{
    int what = place.x % 3;
    ivec2 first = ivec2(place.x / 3, place.y) * BLOCK,
        last = min(first + BLOCK, ivec2(measure_width, measure_height));
    first = max(first, ivec2(measure_x, measure_y));
    vec4 result = vec4(0.0, 0.0, what < 2 ? 0.0 : GREATEST, what < 2 ? 0.0 : GREATEST);
    for (int y = first.y; y < last.y; y++)
        for (int x = first.x; x < last.x; x++) {
            vec4 one = texelFetch(measure_from, measure_first != 0 ? ivec2(x, y)
                : ivec2(3 * x + what, y), 0);
            // excludes the backdrop's pixels
            if (measure_first != 0)
                one = measureOf(what, one.w > 0.0 ? toneGuard(one.xyz) : vec3(0.0));
            result = what == 0   ? max(result, one)
                     : what == 1 ? result + one
                                 : vec4(result.xy + one.xy, min(result.zw, one.zw));
        }
    return result;
}
