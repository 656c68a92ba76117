/* Pictures and reliefs, semantics.md 2.2. Arguments: the texture's index, u, v, and its size, which the texture itself knows. */
#include "runtime/library/reference.h"
#include "runtime/library/srgb.h"
#include <stddef.h>

enum { LANES = 4 };

static const ReferenceTexture *texture_of(const void *context, double index)
{
    return &((const ReferenceContext *)context)->textures[(int)index];
}

/* The same to a function that fetches texels. */
static ReferenceTexture fetched_of(const void *context, double index)
{
    ReferenceTexture texture = *texture_of(context, index);
    if (texture.sampler_wraps)
        texture.wrap = REFERENCE_REPEAT;
    return texture;
}

enum { NOWHERE = -1 };

static double rest(double whole, double divisor) { return whole - divisor * floor(whole / divisor); }

/* A whole number as an index below size, or NOWHERE; a coordinate that is not finite has none, and 0 keeps the cast defined. */
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

/* A coordinate in texels. Whole turns go first: the product of a great one has no digits left for the weight. */
static double in_texels(const ReferenceTexture *texture, double coordinate, int size)
{
    const double turn = texture->wrap == REFERENCE_REPEAT ? 1 : texture->wrap == REFERENCE_MIRROR ? 2 : 0;
    return turn > 0 ? fraction(coordinate / turn) * turn * size : coordinate * size;
}

/* A texel as OpenGL reads it: the lanes that a texture of one lane lacks are 0, 0, 1. */
static void texel(const ReferenceTexture *texture, double column, double row, double result[LANES])
{
    const int x = index_of(texture->wrap, column, texture->width), y = index_of(texture->wrap, row, texture->height);
    const bool there = x != NOWHERE && y != NOWHERE;
    const size_t at = there ? (size_t)y * (size_t)texture->width + (size_t)x : 0;
    for (int lane = 0; lane < LANES; lane++) {
        size_t number = at * (size_t)texture->lanes + (size_t)lane;
        if (!there)
            result[lane] = 0;
        else if (lane >= texture->lanes)
            result[lane] = lane == LANES - 1;
        else
            result[lane] = texture->bytes   ? texture->bytes[number] / 255.
                           : texture->words ? texture->words[number] / 65535.
                                            : (double)texture->floats[number];
        if (texture->srgb && lane < 3)
            result[lane] = srgb_decode(result[lane]);
    }
}

static double blend(double a, double b, double t) { return a * (1 - t) + b * t; }

/* The texels from (column, row) on, mixed. The weights may be negative. */
static void mixed(const ReferenceTexture *texture, const double at[2], const double weight[2], double result[LANES])
{
    double corner[4][LANES];
    for (int i = 0; i < 4; i++)
        texel(texture, at[0] + (i & 1), at[1] + (i >> 1), corner[i]);
    for (int lane = 0; lane < LANES; lane++)
        result[lane] = blend(blend(corner[0][lane], corner[1][lane], weight[0]),
                             blend(corner[2][lane], corner[3][lane], weight[0]), weight[1]);
}

REFERENCE(imageNearest)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    double column = floor(in_texels(&texture, args[1], texture.width));
    double row = floor(in_texels(&texture, args[2], texture.height));
    if (texture.wrap == REFERENCE_REPEAT) {
        /* The fraction of a tiny negative number rounds to 1, which belongs to the last texel. */
        column = fmin(column, texture.width - 1);
        row = fmin(row, texture.height - 1);
    }
    texel(&texture, column, row, result);
}

static void bilinear(const ReferenceTexture *texture, const double uv[2], double result[LANES])
{
    const double at[2] = {in_texels(texture, uv[0], texture->width), in_texels(texture, uv[1], texture->height)};
    const double low[2] = {floor(at[0]), floor(at[1])};
    const double weight[2] = {at[0] - low[0], at[1] - low[1]};
    mixed(texture, low, weight, result);
}

REFERENCE(imageBilinear)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    bilinear(&texture, &args[1], result);
}

/* The sampler's own weights are those of the four texels. */
REFERENCE(imageSampled) { bilinear(texture_of(context, args[0]), &args[1], result); }

REFERENCE(pictureSize)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    result[0] = texture->width;
    result[1] = texture->height;
}

REFERENCE(carpenterRelief)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    /* Whole turns go first, as the product of a great coordinate and the size has no digits left for the weight. */
    const double at[2] = {(args[1] - trunc(args[1])) * texture->width, (args[2] - trunc(args[2])) * texture->height};
    const double low[2] = {trunc(at[0]), trunc(at[1])};
    const double weight[2] = {at[0] - low[0], at[1] - low[1]};
    double lanes[LANES];
    mixed(texture, low, weight, lanes);
    result[0] = lanes[0];
}

/* How the mix of four texels changes with its weights, each moving by `rate`. */
static void mixed_along(const ReferenceTexture *texture, const double at[2], const double weight[2],
                        const double rate[2], double result[LANES])
{
    double corner[4][LANES];
    for (int i = 0; i < 4; i++)
        texel(texture, at[0] + (i & 1), at[1] + (i >> 1), corner[i]);
    for (int lane = 0; lane < LANES; lane++) {
        double by_u = blend(corner[1][lane] - corner[0][lane], corner[3][lane] - corner[2][lane], weight[1]);
        double by_v = blend(corner[2][lane] - corner[0][lane], corner[3][lane] - corner[1][lane], weight[0]);
        result[lane] = by_u * rate[0] + by_v * rate[1];
    }
}

REFERENCE(imageAlong)
{
    const ReferenceTexture texture = fetched_of(context, args[0]);
    const double at[2] = {in_texels(&texture, args[1], texture.width), in_texels(&texture, args[2], texture.height)};
    const double low[2] = {floor(at[0]), floor(at[1])}, weight[2] = {at[0] - low[0], at[1] - low[1]};
    mixed_along(&texture, low, weight, (double[]){args[5] * texture.width, args[6] * texture.height}, result);
}

REFERENCE(reliefAlong)
{
    const ReferenceTexture *texture = texture_of(context, args[0]);
    const double at[2] = {(args[1] - trunc(args[1])) * texture->width, (args[2] - trunc(args[2])) * texture->height};
    const double low[2] = {trunc(at[0]), trunc(at[1])}, weight[2] = {at[0] - low[0], at[1] - low[1]};
    double lanes[LANES];
    mixed_along(texture, low, weight, (double[]){args[5] * texture->width, args[6] * texture->height}, lanes);
    result[0] = lanes[0];
}

/* The mean of samples over the footprint. */
static void footprint_mean(const void *context, const double *args, double *result)
{
    enum { SIDE = 16 };
    for (int lane = 0; lane < LANES; lane++)
        result[lane] = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double a = (i % SIDE + .5) / SIDE - .5, b = (i / SIDE + .5) / SIDE - .5, sample[LANES];
        const double at[2] = {args[1] + a * args[5] + b * args[7], args[2] + a * args[6] + b * args[8]};
        bilinear(texture_of(context, args[0]), at, sample);
        for (int lane = 0; lane < LANES; lane++)
            result[lane] += sample[lane] / (SIDE * SIDE);
    }
}

REFERENCE(imageFiltered) { footprint_mean(context, args, result); }

/* Texels that a change of uv crosses. */
static double texels_across(const double *size, const double *change)
{
    return hypot(size[0] * change[0], size[1] * change[1]);
}

/* Up to a texel a pixel the sampler magnifies: the value at the point. */
REFERENCE(imageSampledOver)
{
    const double *size = &args[3], *right = &args[5], *up = &args[7];
    if (fmax(texels_across(size, right), texels_across(size, up)) <= 1)
        bilinear(texture_of(context, args[0]), &args[1], result);
    else
        footprint_mean(context, args, result);
}
