/* Which lights cast hybrid shadows. */
#include "runtime/frame/frame.h"
#include "runtime/shadow/hybrid/volume.h"

bool volume_lights_has(const Render *render, int light)
{
    return render->scene->lights[light].shadows == WORD_Shadows_hybrid &&
           !render->options.no_shadows;
}

int volume_lights_count(const Render *render)
{
    int count = 0;
    for (int i = 0; i < render->scene->light_count; i++)
        count += volume_lights_has(render, i);
    return count;
}

bool volume_lights_cast(const Render *render)
{
    return render->shadows->views.count > 0 && volume_lights_count(render) > 0;
}
