/* Properties of lights that programs, maps and targets depend on: a change rebuilds them. */
#include "runtime/renderer/passes.h"
#include <stdlib.h>
#include <string.h>

static RendererLight light_of(const SceneLight *light)
{
    return (RendererLight){light->kind, light->shadows, light->both_sides};
}

bool renderer_lights_keep(Renderer *renderer)
{
    const Scene *scene = renderer->scene;
    RendererLight *kept = malloc(((size_t)scene->light_count + 1) * sizeof *kept);
    free(renderer->kept_lights);
    renderer->kept_lights = kept;
    for (int i = 0; kept && i < scene->light_count; i++)
        kept[i] = light_of(&scene->lights[i]);
    renderer->kept_light_count = scene->light_count;
    return kept || gl_fail(renderer->gl, "out of memory");
}

bool renderer_lights_kept(const Renderer *renderer)
{
    const Scene *scene = renderer->scene;
    bool same = scene->light_count == renderer->kept_light_count;
    for (int i = 0; same && i < scene->light_count; i++) {
        const RendererLight now = light_of(&scene->lights[i]), kept = renderer->kept_lights[i];
        same = now.kind == kept.kind && now.shadows == kept.shadows &&
               now.both_sides == kept.both_sides;
    }
    return same;
}
