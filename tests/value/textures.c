/* Textures for the evaluator. */
#include "textures.h"
#include "runtime/lib/carpenter.h"

bool textures_of(Arena *arena, const Ir *ir, ReferenceTexture *textures, size_t room)
{
    if (ir->texture_count > room)
        return false;
    for (size_t i = 0; i < ir->texture_count; i++) {
        const IrTexture *t = &ir->textures[i];
        textures[i] = (ReferenceTexture){.width = t->width, .height = t->height, .lanes = 1};
        if (t->kind == TEXTURE_image) {
            textures[i].lanes = 4;
            textures[i].bytes = t->image->bytes;
            continue;
        }
        double n[4];
        float *floats = arena_alloc(arena, sizeof *floats * (size_t)t->width * (size_t)t->height);
        for (int k = 0; k < 4; k++) {
            double lanes[4];
            value_number(&t->node->params[1 + k], TYPE_float, lanes);
            n[k] = lanes[0];
        }
        carpenter_bake(n[0], n[1], n[2], (int64_t)n[3], t->width, t->height, floats);
        textures[i].floats = floats;
    }
    return true;
}
