/* Texels of lights on the GPU: a uniform block of each program that lights, if the driver's
 * limit allows, else a texture. The pass light_cluster always takes the texture, since its
 * invocations read different lights, which a block serializes. */
#include "runtime/light/light_far.h"
#include "runtime/light/lighting.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>
#include <stdlib.h>

enum { LEAST = 16 /* min size of the table in texels */ };

/* Rounds up to a power of two, so that programs are shared by similar numbers of lights. */
static int capacity_for(int texels)
{
    int capacity = LEAST;
    while (capacity < texels)
        capacity *= 2;
    return capacity;
}

static bool write_texture(Renderer *renderer, int unit)
{
    LightTable *lights = &renderer->light->table;
    const TextureSpec spec = {.width = lights->count < LIGHT_ROW ? lights->count : LIGHT_ROW,
                              .height = (lights->count + LIGHT_ROW - 1) / LIGHT_ROW,
                              .components = 4,
                              .floats = lights->texels[0]};
    /* making a texture binds it to this unit */
    renderer->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    if (lights->texture)
        texture_rewrite(renderer->gl, lights->texture, &spec);
    else
        lights->texture =
            texture_check(renderer->gl, &spec) ? texture_make(renderer->gl, &spec) : 0;
    return lights->texture != 0;
}

/* Reports whether all texels fit into a uniform block. Drivers allow at least 16 KiB; 64 KiB are
 * usual, which are 2048 plain lights. */
static bool fits_block(const Renderer *renderer)
{
    GLint most = 0;
    renderer->gl->GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &most);
    return (size_t)renderer->light->table.count * sizeof *renderer->light->table.texels <=
           (size_t)most;
}

bool light_table_write(Renderer *renderer, int unit)
{
    LightTable *lights = &renderer->light->table;
    const bool others = renderer->light->counts[VIEW_SPACE_POINTS] > 0;
    if (!lights->texels)
        lights->texels = calloc((size_t)capacity_for(renderer->scene->light_count * LIGHT_TEXELS),
                                sizeof *lights->texels);
    if (!lights->texels)
        return gl_fail(renderer->gl, "out of memory");
    view_space_lights(&renderer->space, renderer->scene, !renderer->options.no_shadows,
                      lights->texels, renderer->light->counts);
    if (light_far_used(renderer) && !light_order((float(*)[LIGHT_PLAIN_TEXELS][4])lights->texels,
                                                 renderer->light->counts[VIEW_SPACE_PLAIN]))
        return gl_fail(renderer->gl, "out of memory");
    shadow_put_lights(renderer, renderer->light->counts, lights->texels);
    if (renderer->light->far.numbers && others != (renderer->light->counts[VIEW_SPACE_POINTS] > 0))
        return gl_fail(renderer->gl,
                       "shadows of lights were turned on or off: the scene must be set again");
    const int count = capacity_for(view_space_texels(renderer->light->counts, VIEW_SPACE_SECTIONS));
    if (lights->count && count > lights->count)
        return gl_fail(renderer->gl, "the lights take %d texels, not %d: this is another scene",
                       count, lights->count);
    lights->count = lights->count ? lights->count : count;
    return (fits_block(renderer) && !light_far_used(renderer)) || write_texture(renderer, unit);
}

void light_table_define(const Renderer *renderer, bool scattered,
                        char defined[LIGHT_TABLE_DEFINITION])
{
    *defined = 0;
    if (fits_block(renderer) && !scattered)
        snprintf(defined, LIGHT_TABLE_DEFINITION, "#define LIGHT_BLOCK %d\n",
                 renderer->light->table.count);
}

void light_table_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    const LightTable *lights = &renderer->light->table;
    if (lights->texture)
        screen_pass_sampler(pass, "light_lights", unit);
    if (fits_block(renderer)) /* the program has either the block or the texture */
        material_write(&pass->material, "Lights", lights->texels,
                       (size_t)lights->count * sizeof *lights->texels);
}

void light_table_bind(const Renderer *renderer, int unit)
{
    if (renderer->light->table.texture)
        texture_bind(renderer->gl, renderer->light->table.texture, unit);
}

void light_table_delete(Renderer *renderer)
{
    renderer->gl->DeleteTextures(1, &renderer->light->table.texture); /* GL ignores the name 0 */
    free(renderer->light->table.texels);
    renderer->light->table = (LightTable){0};
}
