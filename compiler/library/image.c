/* Images and height maps, semantics.md 2.2. Arguments: the texture's index, u, v, and the
 * texture's size, which the texture itself contains. */
#include "compiler/library/reference.h"
#include "compiler/library/srgb.h"
#include <stddef.h>
#include <string.h>

enum { COMPONENTS = 4 };

static const ReferenceTexture *texture_of(const void *context, double index)
{
    return &((const ReferenceContext *)context)->textures[(int)index];
}

/* The texture as texel-fetching functions sample it. */
static ReferenceTexture fetched_of(const void *context, double index)
{
    ReferenceTexture texture = *texture_of(context, index);
    if (texture.sampler_wraps)
        texture.wrap = REFERENCE_REPEAT;
    return texture;
}

enum { NOWHERE = -1 };

static double rest(double whole, double divisor)
{
    return whole - divisor * floor(whole / divisor);
}

/* Converts an integer to an index below size, or NOWHERE; infinity and NaN give NOWHERE, and 0
 * keeps the cast defined. */
static int index_of(ReferenceWrap wrap, double whole, int size)
{
    if (whole >= 0 && whole < size)
        return (int)whole;
    double index = whole;
    if (wrap == REFERENCE_REPEAT)
        index = rest(whole, size);
    if (wrap == REFERENCE_MIRROR)
        index = fmin(rest(whole, 2. * size), 2. * size - 1 - rest(whole, 2. * size));
    if (wrap == REFERENCE_CLAMP)
        index = clamp(whole, 0, size - 1);
    if (wrap == REFERENCE_BORDER && (whole < 0 || whole >= size))
        return NOWHERE;
    return index >= 0 && index < size ? (int)index : 0;
}

/* Converts a coordinate to texels. Whole periods are removed first: a large product would have
 * no digits left for the weight. */
static double in_texels(const ReferenceTexture *texture, double coordinate, int size)
{
    const double turn = texture->wrap == REFERENCE_REPEAT   ? 1
                        : texture->wrap == REFERENCE_MIRROR ? 2
                                                            : 0;
    return turn > 0 ? fraction(coordinate / turn) * turn * size : coordinate * size;
}

/* Reads a texel as OpenGL does: missing components of a single-channel texture are 0, 0, 1. */
static void texel(const ReferenceTexture *texture, double column, double row,
                  double result[COMPONENTS])
{
    const int x = index_of(texture->wrap, column, texture->width),
              y = index_of(texture->wrap, row, texture->height);
    const bool there = x != NOWHERE && y != NOWHERE;
    const size_t at = there ? (size_t)y * (size_t)texture->width + (size_t)x : 0;
    for (int component = 0; component < COMPONENTS; component++) {
        size_t number = at * (size_t)texture->components + (size_t)component;
        if (!there)
            result[component] = 0;
        else if (component >= texture->components)
            result[component] = component == COMPONENTS - 1;
        else
            result[component] = texture->bytes   ? texture->bytes[number] / 255.
                                : texture->words ? texture->words[number] / 65535.
                                                 : (double)texture->floats[number];
        if (texture->srgb && component < 3)
            result[component] = srgb_decode(result[component]);
    }
}

static double blend(double a, double b, double t) { return a * (1 - t) + b * t; }

/* Interpolates the four texels starting at (column, row). Weights may be negative. */
static void mixed(const ReferenceTexture *texture, const double at[2], const double weight[2],
                  double result[COMPONENTS])
{
    double corner[4][COMPONENTS];
    for (int i = 0; i < 4; i++)
        texel(texture, at[0] + (i & 1), at[1] + (i >> 1), corner[i]);
    for (int component = 0; component < COMPONENTS; component++)
        result[component] =
            blend(blend(corner[0][component], corner[1][component], weight[0]),
                  blend(corner[2][component], corner[3][component], weight[0]), weight[1]);
}

REFERENCE(imageNearest)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    double column = floor(in_texels(&texture, args[1], texture.width));
    double row = floor(in_texels(&texture, args[2], texture.height));
    if (texture.wrap == REFERENCE_REPEAT) {
        /* The fraction of a tiny negative number rounds to 1; clamp to the last texel. */
        column = fmin(column, texture.width - 1);
        row = fmin(row, texture.height - 1);
    }
    texel(&texture, column, row, result);
}

static void bilinear(const ReferenceTexture *texture, const double uv[2], double result[COMPONENTS])
{
    const double at[2] = {in_texels(texture, uv[0], texture->width),
                          in_texels(texture, uv[1], texture->height)};
    const double low[2] = {floor(at[0]), floor(at[1])};
    const double weight[2] = {at[0] - low[0], at[1] - low[1]};
    mixed(texture, low, weight, result);
}

REFERENCE(imageBilinear)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    bilinear(&texture, &args[1], result);
}

/* The sampler interpolates the same four texels. */
REFERENCE(imageSampled) { bilinear(texture_of(context, args[0]), &args[1], result); }

REFERENCE(imageCentred)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    bilinear(texture, (double[]){args[1] - .5 / texture->width, args[2] - .5 / texture->height},
             result);
}

REFERENCE(pictureSize)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    result[0] = texture->width;
    result[1] = texture->height;
}

REFERENCE(carpenterRelief)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    /* Whole periods are removed first: the product of a large coordinate and the size would have
     * no digits left for the weight. */
    const double at[2] = {(args[1] - trunc(args[1])) * texture->width,
                          (args[2] - trunc(args[2])) * texture->height};
    const double low[2] = {trunc(at[0]), trunc(at[1])};
    const double weight[2] = {at[0] - low[0], at[1] - low[1]};
    double components[COMPONENTS];
    mixed(texture, low, weight, components);
    result[0] = components[0];
}

/* Derivative of the interpolation as its weights change by `rate`. */
static void mixed_along(const ReferenceTexture *texture, const double at[2], const double weight[2],
                        const double rate[2], double result[COMPONENTS])
{
    double corner[4][COMPONENTS];
    for (int i = 0; i < 4; i++)
        texel(texture, at[0] + (i & 1), at[1] + (i >> 1), corner[i]);
    for (int component = 0; component < COMPONENTS; component++) {
        double by_u = blend(corner[1][component] - corner[0][component],
                            corner[3][component] - corner[2][component], weight[1]);
        double by_v = blend(corner[2][component] - corner[0][component],
                            corner[3][component] - corner[1][component], weight[0]);
        result[component] = by_u * rate[0] + by_v * rate[1];
    }
}

REFERENCE(imageAlong)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    const double at[2] = {in_texels(&texture, args[1], texture.width),
                          in_texels(&texture, args[2], texture.height)};
    const double low[2] = {floor(at[0]), floor(at[1])},
                 weight[2] = {at[0] - low[0], at[1] - low[1]};
    mixed_along(&texture, low, weight,
                (double[]){args[5] * texture.width, args[6] * texture.height}, result);
}

REFERENCE(reliefAlong)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    const double at[2] = {(args[1] - trunc(args[1])) * texture->width,
                          (args[2] - trunc(args[2])) * texture->height};
    const double low[2] = {trunc(at[0]), trunc(at[1])},
                 weight[2] = {at[0] - low[0], at[1] - low[1]};
    double components[COMPONENTS];
    mixed_along(texture, low, weight,
                (double[]){args[5] * texture->width, args[6] * texture->height}, components);
    result[0] = components[0];
}

/* Mean of samples over a footprint: the derivatives of u and v to the right, then upward. */
static void footprint_mean(const ReferenceTexture *texture, const double uv[2],
                           const double spread[4], double result[COMPONENTS])
{
    enum { SIDE = 16 };
    for (int component = 0; component < COMPONENTS; component++)
        result[component] = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double a = (i % SIDE + .5) / SIDE - .5, b = (i / SIDE + .5) / SIDE - .5, sample[COMPONENTS];
        const double at[2] = {uv[0] + a * spread[0] + b * spread[2],
                              uv[1] + a * spread[1] + b * spread[3]};
        bilinear(texture, at, sample);
        for (int component = 0; component < COMPONENTS; component++)
            result[component] += sample[component] / (SIDE * SIDE);
    }
}

REFERENCE(imageFiltered)
{
    footprint_mean(texture_of(context, args[0]), &args[1], &args[5], result);
}

/* Returns the length, in texels, of a change of uv. */
static double texels_across(const ReferenceTexture *texture, const double *change)
{
    return hypot(texture->width * change[0], texture->height * change[1]);
}

/* Value that the sampler returns: the point value under magnification (at most a texel per
 * pixel), else the footprint's mean. */
static void shown(const ReferenceTexture *texture, const double uv[2], const double spread[4],
                  double result[COMPONENTS])
{
    if (fmax(texels_across(texture, spread), texels_across(texture, spread + 2)) <= 1)
        bilinear(texture, uv, result);
    else
        footprint_mean(texture, uv, spread, result);
}

REFERENCE(imageSampledOver) { shown(texture_of(context, args[0]), &args[1], &args[5], result); }

/* Finite difference of a component over one texel along u and v, per unit of uv. */
static void rise(const ReferenceTexture *texture, const double uv[2], double component,
                 const double spread[4], double *result)
{
    const int one = whole_between(component, 0, COMPONENTS - 1),
              size[] = {texture->width, texture->height};
    double here[COMPONENTS], beyond[COMPONENTS];
    shown(texture, uv, spread, here);
    for (int axis = 0; axis < 2; axis++) {
        double there[] = {uv[0], uv[1]};
        there[axis] += 1. / size[axis];
        shown(texture, there, spread, beyond);
        result[axis] = (beyond[one] - here[one]) * size[axis];
    }
}

REFERENCE(imageRise)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    rise(&texture, &args[1], args[5], (double[4]){0}, result);
}

REFERENCE(imageRiseOver)
{
    rise(texture_of(context, args[0]), &args[1], args[5], &args[6], result);
}

/* Far from the origin, the texture is sampled and the given difference is ignored. */
REFERENCE(imageRiseNear)
{
    enum { FAR = 65536 };
    const ReferenceTexture *texture = texture_of(context, args[0]);
    const bool minified =
        fmax(texels_across(texture, &args[6]), texels_across(texture, &args[8])) > 1;
    if (minified && fmax(fabs(args[1]) * texture->width, fabs(args[2]) * texture->height) <= FAR)
        memcpy(result, &args[10], 2 * sizeof *result);
    else
        rise(texture, &args[1], args[5], &args[6], result);
}

REFERENCE(imageRiseBeyond)
{
    ReferenceTexture texture = *texture_of(context, args[0]);
    texture.wrap = (ReferenceWrap)whole_between(args[6], REFERENCE_REPEAT, REFERENCE_BORDER);
    rise(&texture, &args[1], args[5], &args[7], result);
}
