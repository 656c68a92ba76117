/* Random placement of copies. Numbers in [0, 1) are the upper 53 bits of the generator's output,
 * over 2^53.
 *
 *     seed 0, size [2, 2, 0]: the first two numbers are 0.8833 and 0.4315, so the first copy is
 *     at (0.767, -0.137, 0) */
#include "runtime/tessellate/scene_scatter.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

uint64_t scene_scatter_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

float scene_object_random(int object)
{
    uint64_t state = (uint64_t)object;
    return (float)(scene_scatter_next(&state) >> 40) / 16777216;
}

static double part(uint64_t *state)
{
    return (double)(scene_scatter_next(state) >> 11) / 9007199254740992.0;
}

/* Returns a rotation that maps z to the normal n, after Duff and others (2017). With g = 1 or
 * -1, the sign of n's z, a = -1 / (g + nz) and b = nx ny a, x and y map to (1 + g nx nx a, g b,
 * -g nx) and (b, g + ny ny a, -ny).
 *
 *     n = (0, 0, 1): x and y stay; n = (1, 0, 0): g = 1, a = -1, b = 0, so x maps to (0, 0, -1),
 *     and y stays */
SceneMatrix scene_scatter_turn(const double n[3])
{
    const double g = copysign(1, n[2]), a = -1 / (g + n[2]), b = n[0] * n[1] * a;
    return (SceneMatrix){{1 + g * n[0] * n[0] * a, g * b, -g * n[0], 0, b, g + n[1] * n[1] * a,
                          -n[1], 0, n[0], n[1], n[2], 0, 0, 0, 0, 1}};
}

void scene_scatter_numbers(uint64_t state, double numbers[3])
{
    for (int i = 0; i < 3; i++)
        numbers[i] = part(&state);
}

/* Returns a copy's position, and its rotation there before the copy's own. */
static SceneMatrix stand(const SceneScatter *scatter, uint64_t *state)
{
    SceneMatrix result = scene_matrix_identity();
    double numbers[3], normal[3];
    for (int i = 0; i < 3; i++) {
        numbers[i] = part(state);
        result.m[12 + i] = (numbers[i] - .5) * scatter->size[i];
    }
    if (!scatter->surface)
        return result;
    double point[3];
    scene_surface_point(scatter->surface, numbers, point, normal);
    if (scatter->aligned)
        result = scene_scatter_turn(normal);
    memcpy(result.m + 12, point, sizeof point);
    return result;
}

SceneMatrix scene_scatter_matrix(const SceneScatter *scatter, uint64_t *state)
{
    const SceneMatrix here = stand(scatter, state);
    ScenePlace place = {.shear = {0}};
    for (int i = 0; i < 3; i++)
        place.rotation[i] = (2 * part(state) - 1) * scatter->rotation[i];
    place.scale[0] = place.scale[1] = place.scale[2] =
        scatter->least + part(state) * (scatter->most - scatter->least);
    const SceneMatrix own = scene_matrix_place(&place);
    return scene_matrix_multiply(&here, &own);
}
