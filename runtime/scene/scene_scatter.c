/* Numbers in [0, 1) are the upper 53 bits of what the generator gives, over 2^53.
 *
 *     seed 0, size [2, 2, 0]: the first two numbers are 0.8833 and 0.4315, so the first copy stands at (0.767, -0.137, 0) */
#include "runtime/scene/scene_scatter.h"
#include "runtime/scene/scene_matrix.h"

uint64_t scene_scatter_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static double part(uint64_t *state) { return (double)(scene_scatter_next(state) >> 11) / 9007199254740992.0; }

SceneMatrix scene_scatter_matrix(const SceneScatter *scatter, uint64_t *state)
{
    ScenePlace place = {.shear = {0}};
    for (int i = 0; i < 3; i++)
        place.translation[i] = (part(state) - .5) * scatter->size[i];
    for (int i = 0; i < 3; i++)
        place.rotation[i] = (2 * part(state) - 1) * scatter->rotation[i];
    place.scale[0] = place.scale[1] = place.scale[2] = scatter->least + part(state) * (scatter->most - scatter->least);
    return scene_matrix_place(&place);
}
