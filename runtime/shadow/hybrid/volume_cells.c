/* Shadow volumes cut at silhouettes (volume_cells.glsl), whose vertices have no attributes.
 * After the maps are drawn, a compute program lists the cells of each view that have a surface,
 * those that silhouettes cross separately (volume_list.glsl), and counts their vertices for two
 * indirect draws. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/shadow/silhouette/silhouette.h"
#include "runtime/shadow/hybrid/volume.h"
#include <stdint.h>

enum {
    LIST,
    COMMANDS /* LIST, COMMANDS: binding points */,
    GROUP = 8,
    PARTS = 2 /* kinds of cells: without and with crossings */,
    CROSSINGS_UNIT = 1
};

/* An indirect draw command of GL. */
typedef struct {
    GLuint count, instances, first, base;
} Command;

static const char maps_text[] =
    "uniform sampler2DArray volume_depths, volume_crossings;\n"
    "#define VOLUME_DEPTHS volume_depths\n#define VOLUME_CROSSINGS volume_crossings\n";

bool volume_cells_are(const Renderer *renderer)
{
    return renderer->scene->shadow_volume == KEYWORD_Volume_silhouette;
}

static int views_of(const Renderer *renderer)
{
    int count = 0;
    for (int i = 0; i < renderer->shadows->views.count; i++)
        count += volume_has_view(renderer, i);
    return count;
}

static size_t cells_of(const Renderer *renderer)
{
    const size_t row = (size_t)renderer->scene->shadow_size - 1;
    return row * row;
}

size_t volume_cells_bytes(const Renderer *renderer)
{
    return (size_t)views_of(renderer) *
           (cells_of(renderer) * sizeof(GLuint) + PARTS * sizeof(Command));
}

/* -- making */

static bool check(const Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    const size_t bytes = volume_cells_bytes(renderer), most = transparency_most_bytes(renderer);
    GLint blocks = 0;
    if (volume_state(renderer)->path != KEYWORD_Path_compute)
        return gl_fail(gl, "shadow volumes that silhouettes cut come by the path compute, or auto");
    if (!gl->DrawArraysIndirect || !gl->DispatchCompute)
        return gl_fail(gl, "shadow volumes that silhouettes cut take OpenGL 4.5");
    gl->GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &blocks);
    if (blocks < 1)
        return gl_fail(gl, "shadow volumes that silhouettes cut take vertices that read buffers, "
                           "which the driver lacks");
    return bytes <= most ||
           gl_fail(gl, "cells of shadow volumes take %lu bytes in a buffer, and there may be %lu",
                   (unsigned long)bytes, (unsigned long)most);
}

static GLuint make_buffer(const GlContext *gl, size_t bytes)
{
    GLuint buffer = 0;
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return buffer;
}

bool volume_cells_make(Renderer *renderer)
{
    FrameVolumes *volumes = volume_state(renderer);
    const ProgramText list = {.compute = {"#version 450 core\n", maps_text,
                                          render_text_shadow_volume, render_text_volume_cells,
                                          render_text_volume_list}};
    if (!check(renderer))
        return false;
    volumes->cells =
        make_buffer(renderer->gl, (size_t)views_of(renderer) * cells_of(renderer) * sizeof(GLuint));
    volumes->commands =
        make_buffer(renderer->gl, (size_t)views_of(renderer) * PARTS * sizeof(Command));
    return material_make(renderer->store, NULL, &list, &volumes->writer) &&
           gl_check(renderer->gl, "making cells of shadow volumes");
}

const char *volume_cells_head(bool listed)
{
    return listed ? "#define CELLS\n#define LISTED\n" : "#define CELLS\n";
}

const char *volume_cells_maps(void) { return maps_text; }

void volume_cells_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    /* GL ignores the name 0 */
    gl->DeleteBuffers(2,
                      (GLuint[]){volume_state(renderer)->cells, volume_state(renderer)->commands});
}

/* -- lists */

static void bind(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const FrameVolumes *volumes = volume_state(renderer);
    gl->ActiveTexture(GL_TEXTURE0 + CROSSINGS_UNIT);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, silhouette_state(renderer)->crossings);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->shadows->maps);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LIST, volumes->cells);
}

static void list_view(Renderer *renderer, int view, int number)
{
    const GlContext *gl = renderer->gl;
    Material *list = &volume_state(renderer)->writer;
    const bool parallel = renderer->shadows->views.views[view].near <= 0;
    const float listed[4] = {(float)view, (float)silhouette_layer(renderer, view), (float)number,
                             parallel};
    const GLuint groups = ((GLuint)renderer->scene->shadow_size + GROUP - 2) / GROUP;
    material_set(list, &(MaterialValue){"volume_listed", 4, listed});
    material_set_number(list, "volume_crossings", CROSSINGS_UNIT);
    material_use(list);
    gl->DispatchCompute(groups, groups, 1);
}

void volume_cells_write(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    bind(renderer);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, COMMANDS, volume_state(renderer)->commands);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_RGBA32UI, 0,
                           (GLsizeiptr)((size_t)views_of(renderer) * PARTS * sizeof(Command)),
                           GL_RGBA_INTEGER, GL_UNSIGNED_INT, (GLuint[]){0, 1, 0, 0});
    for (int view = 0, number = 0; view < renderer->shadows->views.count; view++)
        if (volume_has_view(renderer, view))
            list_view(renderer, view, number++);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

/* -- drawing */

static void set_cells(const Renderer *renderer, int view, Material *material, const int part[2])
{
    const float cells[4] = {(float)silhouette_layer(renderer, view), (float)part[0], (float)part[1],
                            0};
    material_set(material, &(MaterialValue){"volume_cells", 4, cells});
    material_set_number(material, "volume_crossings", CROSSINGS_UNIT);
    material_use(material);
}

void volume_cells_draw(const Renderer *renderer, int view, int number)
{
    const GlContext *gl = renderer->gl;
    bind(renderer);
    gl->BindVertexArray(volume_state(renderer)->array);
    gl->BindBuffer(GL_DRAW_INDIRECT_BUFFER, volume_state(renderer)->commands);
    for (int part = 0; part < PARTS; part++) {
        set_cells(renderer, view, &volume_state(renderer)->sheets[view], (int[]){number, part});
        gl->DrawArraysIndirect(
            GL_TRIANGLES,
            (const void *)(uintptr_t)((size_t)(PARTS * number + part) * sizeof(Command)));
    }
    gl->BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void volume_cells_draw_all(const Renderer *renderer, int view, int number)
{
    enum { VERTICES = 30 /* VERTICES: vertices of a cell's VOLUME_MAX triangles */ };
    bind(renderer);
    renderer->gl->BindVertexArray(volume_state(renderer)->array);
    set_cells(renderer, view, &volume_state(renderer)->shown[view], (int[]){number, 0});
    renderer->gl->DrawArrays(GL_TRIANGLES, 0, (GLsizei)(VERTICES * cells_of(renderer)));
}
