/* Views of the picture with the volumes of hybrid shadows in it (volume_shown.c), or with objects as lines. */
#include "runtime/render/frame.h"
#include <string.h>

static const VolumeView views[] = {
    /* name                   scene              volume */
    {"wireframe", VOLUME_VIEW_lines, VOLUME_VIEW_none},
    {"volume", VOLUME_VIEW_faces, VOLUME_VIEW_faces},
    {"volumeWireframe", VOLUME_VIEW_faces, VOLUME_VIEW_lines},
    {"wireframes", VOLUME_VIEW_lines, VOLUME_VIEW_lines},
    {"volumeAlone", VOLUME_VIEW_none, VOLUME_VIEW_faces},
    {"volumeWireframeAlone", VOLUME_VIEW_none, VOLUME_VIEW_lines},
};

const VolumeView *volume_view_find(const char *name)
{
    for (size_t i = 0; name && i < sizeof views / sizeof *views; i++)
        if (!strcmp(name, views[i].name))
            return &views[i];
    return NULL;
}

bool volume_view_has_volume(const Render *render) { return render->look && render->look->volume != VOLUME_VIEW_none; }
bool volume_view_has_scene(const Render *render) { return !render->look || render->look->scene != VOLUME_VIEW_none; }

void volume_view_draw_surfaces(Render *render, bool transparent)
{
    const bool lines = render->look && render->look->scene == VOLUME_VIEW_lines;
    if (!volume_view_has_scene(render))
        return;
    if (lines)
        render->gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    cache_draw(render->gl, &render->cache, transparent);
    if (lines)
        render->gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}
