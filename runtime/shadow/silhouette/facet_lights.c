/* Whether facets are kept for lights whose shadows silhouettes find, for the plan. */
#include "runtime/frame/frame.h"
#include "runtime/exact/exact.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/silhouette/silhouette.h"
#include <string.h>

static bool has_light(const Render *render)
{
    bool has = false;
    for (int i = 0; i < render->scene->light_count; i++)
        has |= render->scene->lights[i].shadows == WORD_Shadows_silhouette;
    return has && !render->options.no_shadows;
}

/* A target more than the G-buffer's. */
static bool has_target(const Render *render)
{
    int targets = 0;
    while (set_format(&render->set, targets))
        targets++;
    return targets < render->gl->max_draw_buffers && targets < FRAMEBUFFER_COLORS;
}

/* Where numbers of triangles are kept for exact shadows, the target is theirs. */
bool facet_lights_write(const Render *render)
{
    const char *view = render->options.view;
    return has_light(render) && has_target(render) && !exact_lights_number(render) &&
           render->gl->major * 10 + render->gl->minor >= 45 &&
           (!view || !strcmp(view, "shown") || !strcmp(view, "light"));
}

bool facet_lights_cast(const Render *render)
{
    return silhouette_layers(render) > 0 && facet_lights_write(render);
}

bool facet_lights_seen(const Render *render)
{
    return exact_lights_cast(render) || facet_lights_cast(render);
}
