/* Settings of indirect light, resolved from the scene. */
#include "runtime/indirect/settings/indirect.h"
#include <string.h>

const IndirectMethod *indirect_method(const Renderer *renderer)
{
    return renderer->indirect->method;
}

static bool is_reported(const Renderer *renderer)
{
    return renderer->scene && scene_indirect_is(renderer->scene);
}

/* Reports whether indirect light is on. A scene without objects has none. */
bool indirect_is(const Renderer *renderer)
{
    return is_reported(renderer) && renderer->scene->object_count > 0;
}

bool indirect_shows(const Renderer *renderer, const char *view)
{
    return renderer->options.view && !strcmp(renderer->options.view, view);
}

/* Reports whether bounces are repeated. The radiance cache already includes further bounces. */
bool indirect_is_repeated(const Renderer *renderer)
{
    return indirect_is(renderer) && !indirect_reads_radiance(renderer) &&
           renderer->scene->indirect.bounces > 1 && !indirect_shows(renderer, "visibility");
}

bool indirect_is_smoothed(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const bool filtered = in->filter != KEYWORD_Filter_none;
    return indirect_is(renderer) && !indirect_shows(renderer, "visibility") &&
           (in->coarse > 1 || indirect_is_repeated(renderer) || filtered ||
            indirect_keeps(renderer) || indirect_moving(renderer));
}

bool indirect_reads_radiance(const Renderer *renderer)
{
    return indirect_is(renderer) && indirect_method(renderer)->reads & INDIRECT_READS_radiance;
}

bool indirect_reads_voxels(const Renderer *renderer)
{
    const unsigned reads = indirect_is(renderer) ? indirect_method(renderer)->reads : 0;
    return reads & INDIRECT_READS_voxels ||
           (reads & INDIRECT_READS_voxels_by_march &&
            renderer->scene->indirect.march == KEYWORD_March_voxels);
}

int indirect_coarse(const Renderer *renderer)
{
    return indirect_is(renderer) && !indirect_shows(renderer, "visibility")
               ? renderer->scene->indirect.coarse
               : 1;
}

int indirect_moving(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const bool fewer = indirect_is(renderer) && in->moving > in->coarse;
    return fewer && !in->history && !indirect_shows(renderer, "visibility") ? in->moving : 0;
}

bool indirect_moves(const Renderer *renderer)
{
    return renderer->indirect->moving.on && indirect_moving(renderer);
}

int indirect_view_components(const char *view)
{
    static const struct {
        const char *name;
        int components;
    } views[] = {{"ao", 1}, {"indirect", 3}, {"bent", 3}, {"visibility", 3}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++)
        if (!strcmp(view, views[i].name))
            return views[i].components;
    return 0;
}

const char *indirect_missing_view(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    if (!view || !indirect_view_components(view) || indirect_is(renderer))
        return NULL;
    return is_reported(renderer) ? "the scene has no objects"
                                 : "the scene has no `indirect:`, which --indirect=METHOD gives it";
}

bool indirect_keeps(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    return indirect_is(renderer) && !indirect_is_repeated(renderer) &&
           !indirect_shows(renderer, "visibility") && (in->samples > 1 || in->history > 0);
}

int indirect_most_sets(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    return in->samples > in->history ? in->samples : in->history;
}

bool indirect_is_done(const Renderer *renderer)
{
    const IndirectHistory *history = &renderer->indirect->history;
    return indirect_keeps(renderer) && history->still &&
           (history->exact || history->sets >= indirect_most_sets(renderer));
}

GLuint indirect_kept(const Renderer *renderer)
{
    const IndirectHistory *history = &renderer->indirect->history;
    return history->values[history->last].colors[0];
}

void indirect_forget(Renderer *renderer)
{
    IndirectHistory *history = &renderer->indirect->history;
    history->still = history->exact = false;
    history->there = history->there && renderer->scene->indirect.history > 0;
    history->sets = 0;
}

void indirect_invalidate(Renderer *renderer, unsigned dirty)
{
    renderer->indirect->history.dirty |= dirty;
    renderer->indirect->moving.on = true;
}

static void delete_history(Renderer *renderer)
{
    IndirectHistory *history = &renderer->indirect->history;
    screen_pass_delete(&history->blend);
    screen_pass_delete(&history->place);
    for (int i = 0; i < 2; i++) {
        framebuffer_delete(renderer->gl, &history->values[i]);
        framebuffer_delete(renderer->gl, &history->places[i]);
    }
    *history = (IndirectHistory){.last = 0};
}

static void delete_moving(Renderer *renderer)
{
    IndirectMoving *moving = &renderer->indirect->moving;
    ScreenPass *const passes[] = {&moving->rays, &moving->again, &moving->smooth, &moving->spread};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        screen_pass_delete(passes[i]);
    framebuffer_delete(renderer->gl, &moving->found);
    framebuffer_delete(renderer->gl, &moving->smoothed);
    *moving = (IndirectMoving){.on = false};
}

void indirect_delete(Renderer *renderer)
{
    delete_history(renderer);
    delete_moving(renderer);
    screen_pass_delete(&renderer->indirect->rays);
    screen_pass_delete(&renderer->indirect->again);
    screen_pass_delete(&renderer->indirect->smooth);
    screen_pass_delete(&renderer->indirect->spread);
    screen_pass_delete(&renderer->indirect->combine);
    framebuffer_delete(renderer->gl, &renderer->indirect->between);
}
