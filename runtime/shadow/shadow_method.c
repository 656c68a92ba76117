/* The rows of shadow techniques in a renderer: their states, and their combined needs. */
#include "runtime/shadow/shadow_method.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/soft_views.h"
#include <stdlib.h>
#include <string.h>

bool shadow_methods_open(Renderer *renderer, const ShadowMethod *const *methods)
{
    bool fine = true;
    renderer->shadows->methods.rows = methods;
    for (int i = 0; fine && methods[i]; i++) {
        renderer->shadows->methods.states[i] = calloc(1, methods[i]->state + 1);
        fine = renderer->shadows->methods.states[i] || gl_fail(renderer->gl, "out of memory");
    }
    return fine;
}

void shadow_methods_close(Renderer *renderer)
{
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if (renderer->store && (*row)->close)
            (*row)->close(renderer);
    for (int i = 0; i < SHADOW_METHODS_MAX; i++)
        free(renderer->shadows->methods.states[i]);
}

int shadow_method_number(const Renderer *renderer, Keyword word)
{
    int i = 0;
    while (renderer->shadows->methods.rows[i]->word != word)
        i++;
    return i + 1;
}

void *shadow_method_state(const Renderer *renderer, Keyword word)
{
    return renderer->shadows->methods.states[shadow_method_number(renderer, word) - 1];
}

const ShadowMethod *shadow_method_of(const ShadowMethod *const *methods, const SceneLight *light)
{
    while (*methods && (*methods)->word != light->shadows)
        methods++;
    return scene_light_casts(light) ? *methods : NULL;
}

int shadow_method_lights(const Renderer *renderer, Keyword word)
{
    int count = 0;
    for (int i = 0; i < renderer->scene->light_count && !renderer->options.no_shadows; i++)
        count += renderer->scene->lights[i].shadows == word;
    return count;
}

/* Combines the needs of all lights. An area light also needs fine casters outside the view: rays
 * from its inside pass objects that are outside the views of its points. */
ShadowNeeds shadow_methods_need(const Renderer *renderer)
{
    ShadowNeeds needs = {.even = true};
    for (int i = 0; i < renderer->scene->light_count; i++) {
        const SceneLight *light = &renderer->scene->lights[i];
        const ShadowMethod *method = shadow_method_of(shadow_methods_of(renderer), light);
        needs.triangles |= method && method->triangles;
        needs.beside |= method && (method->beside || soft_views_wanted(light));
        needs.cuts |= method && !method->apart;
        needs.even &= !method || method->even;
    }
    return needs;
}

const ShadowMethod *shadow_method_seen(const Renderer *renderer)
{
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->seen && (*row)->seen_wanted(renderer))
            return *row;
    return NULL;
}

bool shadow_method_sees(const Renderer *renderer)
{
    const ShadowMethod *method = shadow_method_seen(renderer);
    return method && method->seen_needed(renderer);
}

bool shadow_shows_light(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    return !view || !strcmp(view, "final") || !strcmp(view, "light");
}

bool shadow_seen_fits(const Renderer *renderer)
{
    int targets = 0;
    while (material_set_format(&renderer->set, targets))
        targets++;
    return targets < renderer->gl->max_draw_buffers && targets < FRAMEBUFFER_COLORS;
}

void shadow_method_seen_bind(const Renderer *renderer)
{
    const ShadowMethod *method = shadow_method_seen(renderer);
    if (method && method->seen_bind)
        method->seen_bind(renderer);
}

const char *shadow_methods_target(const Renderer *renderer, FrameTarget target)
{
    const char *format = NULL;
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if (!format && (*row)->target)
            format = (*row)->target(renderer, target);
    return format;
}

bool shadow_methods_make(Renderer *renderer)
{
    bool fine = true;
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        fine = fine && (!(*row)->make || (*row)->make(renderer));
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

bool shadow_methods_look_make(Renderer *renderer)
{
    bool fine = true;
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        fine = fine && (!(*row)->look_make || (*row)->look_make(renderer));
    return fine;
}

void shadow_methods_look_place(Renderer *renderer)
{
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->look_place)
            (*row)->look_place(renderer);
}

void shadow_methods_look_draw(Renderer *renderer)
{
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->look_draw)
            (*row)->look_draw(renderer);
}
