/* Views of the picture with the volumes of hybrid shadows in it (volume_shown.c), or with objects
 * as lines. */
#include "runtime/frame/frame.h"
#include "runtime/shadow/hybrid/volume.h"
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

bool volume_view_has_volume(const Render *render)
{
    return render->look && render->look->volume != VOLUME_VIEW_none;
}
