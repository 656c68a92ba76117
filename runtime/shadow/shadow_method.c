/* The rows of shadow techniques in a renderer: their states, and their combined needs. */
#include "runtime/shadow/shadow_method.h"
#include "runtime/frame/frame.h"
#include "runtime/shadow/soft_views.h"
#include <stdlib.h>
#include <string.h>

bool shadow_methods_open(Render *render, const ShadowMethod *const *methods)
{
    bool fine = true;
    render->shadows->methods.rows = methods;
    for (int i = 0; fine && methods[i]; i++) {
        render->shadows->methods.states[i] = calloc(1, methods[i]->state + 1);
        fine = render->shadows->methods.states[i] || gl_fail(render->gl, "out of memory");
    }
    return fine;
}

void shadow_methods_close(Render *render)
{
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if (render->store && (*row)->close)
            (*row)->close(render);
    for (int i = 0; i < SHADOW_METHODS_MAX; i++)
        free(render->shadows->methods.states[i]);
}

int shadow_method_number(const Render *render, Word word)
{
    int i = 0;
    while (render->shadows->methods.rows[i]->word != word)
        i++;
    return i + 1;
}

void *shadow_method_state(const Render *render, Word word)
{
    return render->shadows->methods.states[shadow_method_number(render, word) - 1];
}

const ShadowMethod *shadow_method_of(const ShadowMethod *const *methods, const SceneLight *light)
{
    while (*methods && (*methods)->word != light->shadows)
        methods++;
    return scene_light_casts(light) ? *methods : NULL;
}

int shadow_method_lights(const Render *render, Word word)
{
    int count = 0;
    for (int i = 0; i < render->scene->light_count && !render->options.no_shadows; i++)
        count += render->scene->lights[i].shadows == word;
    return count;
}

/* Rays from points of an area light pass outside the view's surroundings. */
ShadowNeeds shadow_methods_need(const Render *render)
{
    ShadowNeeds needs = {.even = true};
    for (int i = 0; i < render->scene->light_count; i++) {
        const SceneLight *light = &render->scene->lights[i];
        const ShadowMethod *method = shadow_method_of(shadow_methods_of(render), light);
        needs.triangles |= method && method->triangles;
        needs.beside |= method && (method->beside || soft_views_wanted(light));
        needs.cuts |= method && !method->apart;
        needs.even &= !method || method->even;
    }
    return needs;
}

const ShadowMethod *shadow_method_seen(const Render *render)
{
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if ((*row)->seen && (*row)->seen_wanted(render))
            return *row;
    return NULL;
}

bool shadow_method_sees(const Render *render)
{
    const ShadowMethod *method = shadow_method_seen(render);
    return method && method->seen_needed(render);
}

bool shadow_shows_light(const Render *render)
{
    const char *view = render->options.view;
    return !view || !strcmp(view, "shown") || !strcmp(view, "light");
}

bool shadow_seen_fits(const Render *render)
{
    int targets = 0;
    while (material_set_format(&render->set, targets))
        targets++;
    return targets < render->gl->max_draw_buffers && targets < FRAMEBUFFER_COLORS;
}

void shadow_method_seen_bind(const Render *render)
{
    const ShadowMethod *method = shadow_method_seen(render);
    if (method && method->seen_bind)
        method->seen_bind(render);
}

const char *shadow_methods_target(const Render *render, FrameTarget target)
{
    const char *format = NULL;
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if (!format && (*row)->target)
            format = (*row)->target(render, target);
    return format;
}

bool shadow_methods_make(Render *render)
{
    bool fine = true;
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        fine = fine && (!(*row)->make || (*row)->make(render));
    return fine;
}

/* -- debug views */

const FrameLook *shadow_methods_look(const ShadowMethod *const *methods, const char *name)
{
    const FrameLook *look = NULL;
    for (; name && !look && *methods; methods++)
        look = (*methods)->look ? (*methods)->look(name) : NULL;
    return look;
}

bool shadow_methods_look_make(Render *render)
{
    bool fine = true;
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        fine = fine && (!(*row)->look_make || (*row)->look_make(render));
    return fine;
}

void shadow_methods_look_place(Render *render)
{
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if ((*row)->look_place)
            (*row)->look_place(render);
}

void shadow_methods_look_draw(Render *render)
{
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if ((*row)->look_draw)
            (*row)->look_draw(render);
}
