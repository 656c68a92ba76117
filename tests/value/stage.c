/* Targets, draws, and the reading program. */
#include "stage.h"
#include <stdio.h>
#include <stdlib.h>

const float stage_cleared = -7, stage_cleared_depth = 0.3125f;

Stage *stage_new(bool core)
{
    Stage *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    s->gl = gl_open(GL_KIND_osmesa, core, s->error, sizeof s->error);
    if (!s->gl)
        return s;
    FramebufferSpec full = {STAGE_SIDE, STAGE_SIDE, STAGE_TARGETS, GL_RGBA32F, true}, half = full, depth = full;
    half.color_format = GL_RGBA16F;
    depth.color_count = 0;
    s->store = store_new(s->gl);
    if (!s->store || !screen_make(s->gl, &s->screen) || !mesh_make(s->gl, SHAPE_plane, &s->plane) ||
        !framebuffer_make(s->gl, &full, &s->full) || !framebuffer_make(s->gl, &half, &s->half) ||
        !framebuffer_make(s->gl, &depth, &s->depth))
        snprintf(s->error, sizeof s->error, "%s", s->gl->error);
    return s;
}

void stage_free(Stage *s)
{
    if (s->gl && gl_use(s->gl))
        store_free(s->store);
    gl_close(s->gl);
    free(s);
}

/* Without the test no depth is written. */
bool stage_begin(Stage *s, const Framebuffer *target)
{
    if (!gl_use(s->gl))
        return false;
    framebuffer_use(s->gl, target);
    s->gl->Enable(GL_DEPTH_TEST);
    s->gl->DepthFunc(GL_ALWAYS);
    s->gl->ClearColor(stage_cleared, stage_cleared, stage_cleared, stage_cleared);
    s->gl->ClearDepth(stage_cleared_depth);
    s->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return true;
}

bool stage_finish(Stage *s, const Framebuffer *target)
{
    bool fine = true;
    for (int i = 0; i < target->spec.color_count; i++)
        fine = fine && framebuffer_read(s->gl, target, i, &s->color[i][0][0]);
    s->gl->BindFramebuffer(GL_FRAMEBUFFER, target->name);
    s->gl->ReadPixels(0, 0, STAGE_SIDE, STAGE_SIDE, GL_DEPTH_COMPONENT, GL_FLOAT, s->z);
    return fine && gl_check(s->gl, "drawing");
}

bool stage_draw(Stage *s, Scene *scene, const Space *space, const Mesh *mesh, const Framebuffer *target)
{
    if (!stage_begin(s, target))
        return false;
    scene_use(scene, space);
    if (mesh)
        mesh_draw(s->gl, mesh);
    else
        screen_draw(s->gl, &s->screen);
    return stage_finish(s, target);
}

/* Scenes are of the layout "thesis". */
bool stage_unpack(Stage *s, const Scene *scene, const Framebuffer *source)
{
    Reader reader;
    const ReaderSource what = {matc_output(scene->program, MATC_UNPACK, NULL), TARGET_glsl330,
                               &layout_table[LAYOUT_thesis], STAGE_SIDE, STAGE_SIDE};
    bool fine = gl_use(s->gl) && reader_make(s->store, &what, &reader);
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++)
        fine = !reader.holds[slot] || reader_read(&reader, source, (Slot)slot, &s->slot[slot][0][0]);
    if (fine)
        reader_delete(&reader);
    return fine && gl_check(s->gl, "reading a G-buffer");
}
