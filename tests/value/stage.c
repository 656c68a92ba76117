/* Targets, draws, and the reading program. */
#include "stage.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
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
    FramebufferSpec unpacked = {STAGE_SIDE, STAGE_SIDE, READ_COUNT, GL_RGBA32F, false};
    half.color_format = GL_RGBA16F;
    depth.color_count = 0;
    if (!mesh_make_empty(s->gl, &s->none) || !mesh_make(s->gl, SHAPE_plane, &s->plane) ||
        !framebuffer_make(s->gl, &full, &s->full) || !framebuffer_make(s->gl, &half, &s->half) ||
        !framebuffer_make(s->gl, &depth, &s->depth) || !framebuffer_make(s->gl, &unpacked, &s->unpacked))
        snprintf(s->error, sizeof s->error, "%s", s->gl->error);
    return s;
}

void stage_free(Stage *s)
{
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

bool stage_draw(Stage *s, const Scene *scene, const Space *space, const Mesh *mesh, const Framebuffer *target)
{
    if (!stage_begin(s, target))
        return false;
    scene_use(scene, s->gl, space);
    if (mesh)
        mesh_draw(s->gl, mesh);
    else
        mesh_draw_screen(s->gl, &s->none);
    return stage_finish(s, target);
}

static const char vertex[] =
    "#version 330 core\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }";
static const char fragment[] = "layout(location = 0) out vec4 a; layout(location = 1) out vec4 b;\n"
                               "layout(location = 2) out vec4 c; layout(location = 3) out vec4 d;\n"
                               "layout(location = 4) out vec4 e; layout(location = 5) out vec4 f;\n"
                               "void main() { Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
                               "a = vec4(s.normal, s.shininess); b = vec4(s.diffuse, s.transparencyShininess);\n"
                               "c = vec4(s.specular, 0.); d = vec4(s.transparency, 0.); e = vec4(s.emissive, 0.);\n"
                               "f = vec4(s.diffuseTransparency, 0.); }";

bool stage_unpack(Stage *s, const Scene *scene, const Framebuffer *source)
{
    const char *library = matc_output(scene->program, MATC_UNPACK, NULL);
    ProgramText text = {.vertex = {vertex}, .fragment = {"#version 330 core\n", library, fragment}};
    GLuint program = stage_begin(s, &s->unpacked) ? program_make(s->gl, &text) : 0;
    bool fine = program != 0;
    for (int i = 0; fine && i < STAGE_TARGETS; i++) {
        char name[32];
        snprintf(name, sizeof name, "matc_gbuffer%d", i);
        texture_bind(s->gl, source->colors[i], i);
        program_set(s->gl, program, &(ProgramValue){name, 1, &(float){(float)i}});
    }
    if (fine)
        mesh_draw_screen(s->gl, &s->none);
    for (int i = 0; i < READ_COUNT; i++)
        fine = fine && framebuffer_read(s->gl, &s->unpacked, i, &s->slot[i][0][0]);
    s->gl->DeleteProgram(program);
    return fine && gl_check(s->gl, "reading a G-buffer");
}
