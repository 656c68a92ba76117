/* Settings of indirect light, resolved from the scene. */
#include "runtime/indirect/settings/indirect.h"
#include <string.h>

const IndirectMethod *indirect_method(const Render *render) { return render->indirect->method; }

static bool is_said(const Render *render)
{
    return render->scene && scene_indirect_is(render->scene);
}

/* A scene without objects has no indirect light. */
bool indirect_is(const Render *render)
{
    return is_said(render) && render->scene->object_count > 0;
}

bool indirect_shows(const Render *render, const char *view)
{
    return render->options.view && !strcmp(render->options.view, view);
}

/* The radiance cache already includes further bounces. */
bool indirect_is_repeated(const Render *render)
{
    return indirect_is(render) && !indirect_reads_radiance(render) &&
           render->scene->indirect.bounces > 1 && !indirect_shows(render, "visibility");
}

bool indirect_is_smoothed(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const bool filtered = in->filter != WORD_Filter_none;
    return indirect_is(render) && !indirect_shows(render, "visibility") &&
           (in->coarse > 1 || indirect_is_repeated(render) || filtered || indirect_keeps(render) ||
            indirect_moving(render));
}

bool indirect_reads_radiance(const Render *render)
{
    return indirect_is(render) && indirect_method(render)->reads & INDIRECT_READS_radiance;
}

bool indirect_reads_voxels(const Render *render)
{
    const unsigned reads = indirect_is(render) ? indirect_method(render)->reads : 0;
    return reads & INDIRECT_READS_voxels || (reads & INDIRECT_READS_voxels_by_march &&
                                             render->scene->indirect.march == WORD_March_voxels);
}

int indirect_coarse(const Render *render)
{
    return indirect_is(render) && !indirect_shows(render, "visibility")
               ? render->scene->indirect.coarse
               : 1;
}

int indirect_moving(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const bool fewer = indirect_is(render) && in->moving > in->coarse;
    return fewer && !in->history && !indirect_shows(render, "visibility") ? in->moving : 0;
}

bool indirect_moves(const Render *render)
{
    return render->indirect->moving.on && indirect_moving(render);
}

int indirect_view_lanes(const char *view)
{
    static const struct {
        const char *name;
        int lanes;
    } views[] = {{"open", 1}, {"indirect", 3}, {"bent", 3}, {"visibility", 3}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++)
        if (!strcmp(view, views[i].name))
            return views[i].lanes;
    return 0;
}

const char *indirect_lacks_view(const Render *render)
{
    const char *view = render->options.view;
    if (!view || !indirect_view_lanes(view) || indirect_is(render))
        return NULL;
    return is_said(render) ? "the scene has no objects"
                           : "the scene has no `indirect:`, which --indirect=METHOD gives it";
}

bool indirect_keeps(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    return indirect_is(render) && !indirect_is_repeated(render) &&
           !indirect_shows(render, "visibility") && (in->samples > 1 || in->history > 0);
}

int indirect_most_sets(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    return in->samples > in->history ? in->samples : in->history;
}

bool indirect_is_done(const Render *render)
{
    const IndirectHistory *history = &render->indirect->history;
    return indirect_keeps(render) && history->still &&
           (history->exact || history->sets >= indirect_most_sets(render));
}

GLuint indirect_kept(const Render *render)
{
    const IndirectHistory *history = &render->indirect->history;
    return history->values[history->last].colors[0];
}

void indirect_forget(Render *render)
{
    IndirectHistory *history = &render->indirect->history;
    history->still = history->exact = false;
    history->there = history->there && render->scene->indirect.history > 0;
    history->sets = 0;
}

void indirect_doubt(Render *render, unsigned doubts)
{
    render->indirect->history.doubts |= doubts;
    render->indirect->moving.on = true;
}

static void delete_history(Render *render)
{
    IndirectHistory *history = &render->indirect->history;
    screen_pass_delete(&history->blend);
    screen_pass_delete(&history->place);
    for (int i = 0; i < 2; i++) {
        framebuffer_delete(render->gl, &history->values[i]);
        framebuffer_delete(render->gl, &history->places[i]);
    }
    *history = (IndirectHistory){.last = 0};
}

static void delete_moving(Render *render)
{
    IndirectMoving *moving = &render->indirect->moving;
    ScreenPass *const passes[] = {&moving->rays, &moving->again, &moving->smooth, &moving->spread};
    for (size_t i = 0; i < sizeof passes / sizeof *passes; i++)
        screen_pass_delete(passes[i]);
    framebuffer_delete(render->gl, &moving->found);
    framebuffer_delete(render->gl, &moving->smoothed);
    *moving = (IndirectMoving){.on = false};
}

void indirect_delete(Render *render)
{
    delete_history(render);
    delete_moving(render);
    screen_pass_delete(&render->indirect->rays);
    screen_pass_delete(&render->indirect->again);
    screen_pass_delete(&render->indirect->smooth);
    screen_pass_delete(&render->indirect->spread);
    screen_pass_delete(&render->indirect->combine);
    framebuffer_delete(render->gl, &render->indirect->between);
}
