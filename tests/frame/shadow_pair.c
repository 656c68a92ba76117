/* Draws both pictures of a pair; a failure ends the test. */
#include "tests/frame/shadow_pair.h"
#include <stdio.h>
#include <stdlib.h>

static void end(const ShadowPair *pair)
{
    fprintf(stderr, "%s\n", pair->gl->error);
    abort();
}

void shadow_pair_open(GlKind kind, ShadowPair *pair)
{
    pair->gl = frame_context_of(kind);
    pair->options = frame_exact_options();
    for (int i = 0; i < 2; i++) {
        pair->how[i] =
            (RendererOptions){.compile = &pair->options, .view = "light", .no_shadows = i > 0};
        pair->renders[i] = renderer_open(pair->gl, &pair->how[i]);
        if (!pair->renders[i])
            end(pair);
    }
}

void shadow_pair_close(ShadowPair *pair)
{
    for (int i = 0; i < 2; i++)
        renderer_close(pair->renders[i]);
    gl_close(pair->gl);
}

float *shadow_pair_draw(const ShadowPair *pair, int which, const Scene *scene)
{
    Renderer *renderer = pair->renders[which];
    float *rgba = calloc((size_t)scene->width * (size_t)scene->height, 4 * sizeof *rgba);
    if (!rgba || !renderer_set_scene(renderer, scene) || !renderer_frame(renderer) ||
        !renderer_read(renderer, rgba))
        end(pair);
    return rgba;
}

float *shadow_pair_shares(const ShadowPair *pair, const Scene *scene)
{
    float *with = shadow_pair_draw(pair, 0, scene), *without = shadow_pair_draw(pair, 1, scene);
    for (int i = 0; i < scene->width * scene->height; i++)
        with[i] = without[4 * i] > 1e-7f ? with[4 * i] / without[4 * i] : -1;
    free(without);
    return with;
}
