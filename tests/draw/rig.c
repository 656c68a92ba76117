/* Targets, draws, and the reading program. */
#include "rig.h"
#include <stdio.h>
#include <stdlib.h>

const float rig_cleared = -7, rig_cleared_depth = 0.3125f;

Rig *rig_new(bool core)
{
    Rig *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    s->gl = gl_open(GL_KIND_osmesa, core, s->error, sizeof s->error);
    if (!s->gl)
        return s;
    FramebufferSpec full = {RIG_SIDE, RIG_SIDE, STAGE_TARGETS, GL_RGBA32F, true}, half = full,
                    depth = full;
    half.color_format = GL_RGBA16F;
    depth.color_count = 0;
    s->store = store_new(s->gl);
    if (!s->store || !screen_make(s->gl, &s->screen) || !mesh_make(s->gl, SHAPE_plane, &s->plane) ||
        !framebuffer_make(s->gl, &full, &s->full) || !framebuffer_make(s->gl, &half, &s->half) ||
        !framebuffer_make(s->gl, &depth, &s->depth))
        snprintf(s->error, sizeof s->error, "%s", s->gl->error);
    return s;
}

void rig_free(Rig *s)
{
    if (s->gl && gl_use(s->gl))
        store_free(s->store);
    gl_close(s->gl);
    free(s);
}

/* GL writes no depth while the depth test is disabled */
bool rig_begin(Rig *s, const Framebuffer *target)
{
    if (!gl_use(s->gl))
        return false;
    framebuffer_use(s->gl, target);
    s->gl->Enable(GL_DEPTH_TEST);
    s->gl->DepthFunc(GL_ALWAYS);
    s->gl->ClearColor(rig_cleared, rig_cleared, rig_cleared, rig_cleared);
    s->gl->ClearDepth(rig_cleared_depth);
    s->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return true;
}

bool rig_finish(Rig *s, const Framebuffer *target)
{
    bool fine = true;
    for (int i = 0; i < target->spec.color_count; i++)
        fine = fine && framebuffer_read(s->gl, target, i, &s->color[i][0][0]);
    s->gl->BindFramebuffer(GL_FRAMEBUFFER, target->name);
    s->gl->ReadPixels(0, 0, RIG_SIDE, RIG_SIDE, GL_DEPTH_COMPONENT, GL_FLOAT, s->z);
    return fine && gl_check(s->gl, "drawing");
}

bool rig_draw(Rig *s, Scene *scene, const Space *space, const Mesh *mesh, const Framebuffer *target)
{
    if (!rig_begin(s, target))
        return false;
    scene_use(scene, space);
    if (mesh)
        mesh_draw(s->gl, mesh);
    else
        screen_draw(s->gl, &s->screen);
    return rig_finish(s, target);
}

/* Scenes have the layout "thesis". */
bool rig_unpack(Rig *s, const Scene *scene, const Framebuffer *source)
{
    Reader reader;
    const ReaderSource what = {matc_output(scene->program, MATC_UNPACK, NULL), TARGET_glsl330,
                               &layout_table[LAYOUT_thesis], RIG_SIDE, RIG_SIDE};
    bool fine = gl_use(s->gl) && reader_make(s->store, &what, &reader);
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++)
        fine =
            !reader.holds[slot] || reader_read(&reader, source, (Slot)slot, &s->slot[slot][0][0]);
    if (fine)
        reader_delete(&reader);
    return fine && gl_check(s->gl, "reading a G-buffer");
}
