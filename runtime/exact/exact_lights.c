/* Lights whose shadows are exact, for the plan. */
#include "runtime/frame/frame.h"
#include "runtime/exact/exact.h"
#include <string.h>

static bool has_lights(const Render *render)
{
    bool has = false;
    for (int i = 0; i < render->scene->light_count; i++)
        has |= exact_lists_wanted(&render->scene->lights[i]);
    return has && !render->options.no_shadows;
}

bool exact_lights_number(const Render *render)
{
    const char *view = render->options.view;
    return has_lights(render) && (!view || !strcmp(view, "shown") || !strcmp(view, "light"));
}

bool exact_lights_cast(const Render *render)
{
    bool casts = false;
    for (int i = 0; !casts && i < render->cache.place_count; i++)
        casts = exact_triangles_have(&render->cache.places[i]);
    return casts && exact_lights_number(render);
}
