/* Inputs of the passes light_cluster and light for light clustering: constants of the GLSL, error
 * budgets, the buffers of light_storage.c. */
#include "runtime/light/light_far.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/light/lighting.h"
#include <stdio.h>

enum { NUMBERS_BINDING = 5, WORDS_BINDING = 4 };
/* Work group sizes. Summing a series uses few invocations: each needs many registers, and sums
 * wait for one warp only. */
static const int invocations_hardware[] = {[LIGHT_FAR_groups] = 64,
                                           [LIGHT_FAR_near] = 64,
                                           [LIGHT_FAR_cluster] = 32,
                                           [LIGHT_FAR_light] = 0};
enum { INVOCATIONS_SOFTWARE = 8 /* llvmpipe's SIMD width */ };
enum { TEXELS_UNIT = LIGHTING_FREE_UNIT, BITS_UNIT };

void light_far_define(const Renderer *renderer, LightFarUse use,
                      char defined[LIGHT_FAR_DEFINITIONS])
{
    const LightFarWords words = light_far_words(renderer);
    snprintf(defined, LIGHT_FAR_DEFINITIONS,
             "#define FAR_LIGHTS %d\n#define FAR_INVOCATIONS %d\n%s#define FAR_BITS %d\n#define "
             "FAR_TOPS %d\n"
             "#define FAR_NEAR %d\n#define FAR_MARKS %d\n#define FAR_WORDS %d\n"
             "#define FAR_NUMBERS_BINDING %d\n#define FAR_WORDS_BINDING %d\n",
             light_far_most(renderer),
             renderer->gl->hardware ? invocations_hardware[use] : INVOCATIONS_SOFTWARE,
             renderer->light->counts[VIEW_SPACE_POINTS] ? "#define FAR_OTHERS\n" : "", words.bits,
             words.tops, words.near, words.marks, words.block, NUMBERS_BINDING, WORDS_BINDING);
}

/* Sets the error budget. Under transparent layers a relative error stays the same, but an
 * absolute one may grow, so none is allowed. */
void light_far_set(const Renderer *renderer, ScreenPass *pass)
{
    const bool covered = transparency_is(renderer, renderer->transparency);
    double budget[2] = {0};
    light_far_budget(renderer->scene->tone, renderer->options.linear, budget);
    material_set_number(&pass->material, "far_relative", (float)budget[0]);
    material_set_number(&pass->material, "far_absolute",
                        (float)(covered ? 0 : budget[1] / renderer->scene->exposure));
    screen_pass_sampler(pass, "far_texels", TEXELS_UNIT);
    screen_pass_sampler(pass, "far_bits", BITS_UNIT);
    material_set_number(&pass->material, "far_row", (float)light_far_blocks(renderer->size[0]));
}

void light_far_bind(const Renderer *renderer)
{
    renderer->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, NUMBERS_BINDING,
                                 renderer->light->far.numbers);
    renderer->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, WORDS_BINDING,
                                 renderer->light->far.words);
}

void light_far_bind_read(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    gl->ActiveTexture(GL_TEXTURE0 + TEXELS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->light->far.texels);
    gl->ActiveTexture(GL_TEXTURE0 + BITS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->light->far.bits);
}
