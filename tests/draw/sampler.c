/* Shifts the texels of pictures in place, and restores them. */
#include "sampler.h"
#include <stdlib.h>
#include <string.h>

enum { COMPONENTS = 4, WORDS_OF_CODE = 257 };

static size_t texel_numbers(const Image *image)
{
    return (size_t)image->width * (size_t)image->height * COMPONENTS;
}

static int limited(int number, int most) { return number < 0 ? 0 : number > most ? most : number; }

static void shift(const Image *image, const void *kept, const int codes[COMPONENTS])
{
    const uint8_t *bytes = kept;
    const uint16_t *words = kept;
    for (size_t i = 0; i < texel_numbers(image); i++)
        if (image->bits == 8)
            ((uint8_t *)image->texels)[i] =
                (uint8_t)limited(bytes[i] + codes[i % COMPONENTS], UINT8_MAX);
        else
            ((uint16_t *)image->texels)[i] =
                (uint16_t)limited(words[i] + WORDS_OF_CODE * codes[i % COMPONENTS], UINT16_MAX);
}

static void *copy_of(const Image *image)
{
    const size_t size = texel_numbers(image) * (size_t)image->bits / 8;
    void *copy = malloc(size);
    if (!copy)
        abort();
    return memcpy(copy, image->texels, size);
}

void sampler_widen(Oracle *oracle, const Graph *graph, int material, const PointSet *points,
                   Hull *hulls)
{
    static const int signs[][COMPONENTS] = {{1, 1, 1, 1},   {-1, -1, -1, -1}, {1, -1, 1, -1},
                                            {-1, 1, -1, 1}, {1, 1, -1, -1},   {-1, -1, 1, 1},
                                            {0, 0, 0, 0}}; /* the last shift restores the texels */
    void **kept = calloc((size_t)graph->image_count + 1, sizeof *kept);
    if (!kept)
        abort();
    for (int i = 0; i < graph->image_count; i++)
        kept[i] = copy_of(graph->images[i]);
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++) {
        for (int i = 0; i < graph->image_count; i++)
            shift(graph->images[i], kept[i], signs[k]);
        points_widen(oracle, graph->materials[material].node, points, hulls);
    }
    for (int i = 0; i < graph->image_count; i++)
        free(kept[i]);
    free(kept);
}
