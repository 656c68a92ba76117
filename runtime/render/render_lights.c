/* Properties of lights that programs, maps and targets depend on: a change rebuilds them. */
#include "runtime/render/passes.h"
#include <stdlib.h>
#include <string.h>

static RenderLight light_of(const SceneLight *light)
{
    return (RenderLight){light->kind, light->shadows, light->both_sides};
}

bool render_lights_keep(Render *render)
{
    const Scene *scene = render->scene;
    RenderLight *kept = malloc(((size_t)scene->light_count + 1) * sizeof *kept);
    free(render->kept_lights);
    render->kept_lights = kept;
    for (int i = 0; kept && i < scene->light_count; i++)
        kept[i] = light_of(&scene->lights[i]);
    render->kept_light_count = scene->light_count;
    return kept || gl_fail(render->gl, "out of memory");
}

bool render_lights_kept(const Render *render)
{
    const Scene *scene = render->scene;
    bool same = scene->light_count == render->kept_light_count;
    for (int i = 0; same && i < scene->light_count; i++) {
        const RenderLight now = light_of(&scene->lights[i]), kept = render->kept_lights[i];
        same = now.kind == kept.kind && now.shadows == kept.shadows &&
               now.both_sides == kept.both_sides;
    }
    return same;
}
