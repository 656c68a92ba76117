/* Lights whose shadows are exact, for the plan. */
#include "runtime/render/frame.h"
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

/* Opaque places come first. */
bool exact_lights_cast(const Render *render)
{
    return exact_lights_number(render) && render->cache.place_count > 0 && !render->cache.places[0].transparent;
}
