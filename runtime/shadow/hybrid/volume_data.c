/* Sources of a shadow volume's vertices, selected by the scene's path. `fetch`: each vertex
 * reads the map. `copy`, as in the thesis: a map's depths are copied through a pixel buffer that
 * becomes a vertex buffer; for the perfect triangulation a texture with a texel for each corner
 * of each quad is drawn first. `compute`: a program writes depths, and for the perfect
 * triangulation the indices. Buffers are written after the maps are drawn. All three draw the
 * same triangles, corner by corner. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/hybrid/volume.h"
#include <stdint.h>
#include <stdlib.h>

enum {
    RESTART = -1,
    QUAD_CORNERS = 4,
    QUAD_INDICES = 6,
    GROUP = 8,
    DEPTHS = 0,
    INDICES = 1 /* DEPTHS, INDICES: binding points */
};

/* -- indices */

/* Writes the indices of rows of quads: one strip each, two vertices per column, from the upper
 * to the lower one, and a primitive restart. */
static GLsizei put_strips(GLuint *indices, GLuint size)
{
    GLsizei count = 0;
    for (GLuint y = 0; y + 1 < size; y++) {
        for (GLuint x = 0; x < size; x++) {
            indices[count++] = (y + 1) * size + x;
            indices[count++] = y * size + x;
        }
        indices[count++] = (GLuint)RESTART;
    }
    return count;
}

/* Two triangles per quad, whose corners are a, b, c, d. */
static const GLuint triangles[QUAD_INDICES] = {0, 1, 3, 1, 2, 3};

static GLsizei put_quads(GLuint *indices, GLuint size)
{
    GLsizei count = 0;
    for (GLuint quad = 0; quad < (size - 1) * (size - 1); quad++)
        for (int i = 0; i < QUAD_INDICES; i++)
            indices[count++] = quad * QUAD_CORNERS + triangles[i];
    return count;
}

/* Writes the indices for a texture with 2 x 2 texels per quad, around from the lower left
 * corner. */
static GLsizei put_corners(GLuint *indices, GLuint size)
{
    static const GLuint right[QUAD_CORNERS] = {0, 1, 1, 0}, up[QUAD_CORNERS] = {0, 0, 1, 1};
    GLsizei count = 0;
    for (GLuint y = 0; y + 1 < size; y++)
        for (GLuint x = 0; x + 1 < size; x++)
            for (int i = 0; i < QUAD_INDICES; i++)
                indices[count++] =
                    (2 * y + up[triangles[i]]) * 2 * (size - 1) + 2 * x + right[triangles[i]];
    return count;
}

/* -- paths */

static bool is_perfect(const Renderer *renderer)
{
    return renderer->scene->shadow_volume == KEYWORD_Volume_perfect;
}

static bool has_compute(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->DispatchCompute && gl->MemoryBarrier &&
           gl->BindBufferBase;
}

/* Returns true if each view has its own indices: the program that writes them has selected
 * diagonals. */
static bool writes_indices(const Renderer *renderer)
{
    return volume_state(renderer)->path == KEYWORD_Path_compute && is_perfect(renderer);
}

static size_t vertices_of(const Renderer *renderer)
{
    const size_t size = (size_t)renderer->scene->shadow_size;
    if (volume_state(renderer)->path == KEYWORD_Path_fetch)
        return 0;
    return is_perfect(renderer) && volume_state(renderer)->path == KEYWORD_Path_copy
               ? 4 * (size - 1) * (size - 1)
               : size * size;
}

static int hybrid_views(const Renderer *renderer)
{
    int count = 0;
    for (int i = 0; i < renderer->shadows->views.count; i++)
        count += volume_has_view(renderer, i);
    return count;
}

static size_t bytes_of(const Renderer *renderer)
{
    const size_t size = (size_t)renderer->scene->shadow_size, quads = (size - 1) * (size - 1);
    const size_t indices = writes_indices(renderer) ? QUAD_INDICES * quads : 0;
    return (size_t)hybrid_views(renderer) * (vertices_of(renderer) + indices) * sizeof(GLuint);
}

static bool choose(Renderer *renderer)
{
    const size_t most = (size_t)VOLUME_AUTO_MIB << 20;
    FrameVolumes *volumes = volume_state(renderer);
    volumes->path = renderer->scene->shadow_path;
    if (volumes->path == KEYWORD_Path_compute && !has_compute(renderer->gl))
        return gl_fail(renderer->gl, "shadow volumes by compute take OpenGL 4.3");
    if (volumes->path != KEYWORD_Path_auto)
        return true;
    volumes->path = KEYWORD_Path_compute;
    if (volume_cells_are(renderer))
        return true;
    if (!has_compute(renderer->gl) || bytes_of(renderer) > most)
        volumes->path = KEYWORD_Path_fetch;
    return true;
}

const char *volume_data_text(const Renderer *renderer, bool shown)
{
    const Keyword path = volume_state(renderer)->path;
    if (volume_cells_are(renderer))
        return volume_cells_head(!shown);
    if (path == KEYWORD_Path_copy)
        return is_perfect(renderer) ? "#define CORNERS\n" : "#define DEPTHS\n";
    return path == KEYWORD_Path_compute ? "#define DEPTHS\n"
           : is_perfect(renderer)       ? "#define QUADS\n"
                                        : "";
}

/* -- buffers */

/* Makes the indices, shared by all fetched or copied views; computed views have their own. */
static bool make_indices(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    const GLuint size = (GLuint)renderer->scene->shadow_size;
    const size_t most = (size_t)size * size * QUAD_INDICES;
    GLuint *indices = malloc(most * sizeof *indices);
    if (!indices)
        return gl_fail(gl, "out of memory");
    if (!is_perfect(renderer))
        volumes->index_count = put_strips(indices, size);
    else if (volumes->path == KEYWORD_Path_copy)
        volumes->index_count = put_corners(indices, size);
    else
        volumes->index_count = put_quads(indices, size);
    const size_t bytes = sizeof *indices * (size_t)volumes->index_count;
    const bool written = writes_indices(renderer);
    gl->GenBuffers(1, &volumes->indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, volumes->indices);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)(written ? bytes * (size_t)hybrid_views(renderer) : bytes),
                   written ? NULL : indices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(indices);
    return gl_check(gl, "making indices of shadow volumes");
}

static bool make_vertices(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    const size_t bytes = vertices_of(renderer) * (size_t)hybrid_views(renderer) * sizeof(float);
    if (!bytes)
        return true;
    gl->GenBuffers(1, &volume_state(renderer)->vertices);
    gl->BindBuffer(GL_ARRAY_BUFFER, volume_state(renderer)->vertices);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    return gl_check(gl, "making vertices of shadow volumes");
}

/* Returns an offset as a pointer, as GL expects. */
static const void *offset_of(size_t count)
{
    return (const void *)(uintptr_t)(count * sizeof(GLuint));
}

static void make_array(const Renderer *renderer, int number, GLuint array)
{
    const GlContext *gl = renderer->gl;
    gl->BindVertexArray(array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, volume_state(renderer)->indices);
    if (volume_state(renderer)->vertices) {
        gl->BindBuffer(GL_ARRAY_BUFFER, volume_state(renderer)->vertices);
        gl->EnableVertexAttribArray(0);
        gl->VertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0,
                                offset_of((size_t)number * vertices_of(renderer)));
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    gl->BindVertexArray(0);
}

static bool make_arrays(Renderer *renderer)
{
    FrameVolumes *volumes = volume_state(renderer);
    volumes->array_count = volumes->vertices ? hybrid_views(renderer) : 1;
    volumes->arrays = calloc((size_t)volumes->array_count, sizeof *volumes->arrays);
    if (!volumes->arrays)
        return gl_fail(renderer->gl, "out of memory");
    renderer->gl->GenVertexArrays(volumes->array_count, volumes->arrays);
    for (int i = 0; i < volumes->array_count; i++)
        make_array(renderer, i, volumes->arrays[i]);
    return gl_check(renderer->gl, "making shadow volumes");
}

/* Makes the program that selects diagonals, or writes everything. */
static bool make_writer(Renderer *renderer)
{
    FrameVolumes *volumes = volume_state(renderer);
    const char *const quads = is_perfect(renderer) ? "#define QUADS\n" : "";
    const ProgramText compute = {.compute = {"#version 430 core\n", quads,
                                             render_text_shadow_volume, render_text_volume_write}};
    const ProgramText corners = {
        .vertex = {"#version 330 core\n", screen_text},
        .fragment = {"#version 330 core\n", render_text_shadow_volume, render_text_volume_corners}};
    const int edge = 2 * (renderer->scene->shadow_size - 1);
    if (volumes->path == KEYWORD_Path_compute)
        return material_make(renderer->store, NULL, &compute, &volumes->writer);
    if (volumes->path == KEYWORD_Path_fetch || !is_perfect(renderer))
        return true;
    if (edge > renderer->gl->max_texture_size)
        return gl_fail(renderer->gl,
                       "corners of shadow volumes take a texture of %d x %d, the driver has %d",
                       edge, edge, renderer->gl->max_texture_size);
    return material_make(renderer->store, NULL, &corners, &volumes->writer) &&
           framebuffer_make(renderer->gl, &(FramebufferSpec){edge, edge, 1, GL_R32F, false},
                            &volumes->corners);
}

bool volume_data_make(Renderer *renderer)
{
    if (!volume_lights_cast(renderer))
        return true;
    if (volume_cells_are(renderer))
        return choose(renderer) && volume_cells_make(renderer);
    return choose(renderer) && make_indices(renderer) && make_vertices(renderer) &&
           make_arrays(renderer) && make_writer(renderer);
}

/* -- writing */

/* Copies the depths of a map. */
static void copy_depths(const Renderer *renderer, int view, size_t first)
{
    const GlContext *gl = renderer->gl;
    const int size = renderer->scene->shadow_size;
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->shadows->framebuffer);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, renderer->shadows->maps, 0,
                                view);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, volume_state(renderer)->vertices);
    gl->ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT,
                   (void *)(uintptr_t)offset_of(first));
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

static void copy_corners(Renderer *renderer, int view, size_t first)
{
    const GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    const int edge = volumes->corners.spec.width;
    framebuffer_use(gl, &volumes->corners);
    material_set_number(&volumes->writer, "volume_layer", (float)view);
    material_use(&volumes->writer);
    screen_draw(gl, &renderer->screen);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, volumes->vertices);
    gl->ReadPixels(0, 0, edge, edge, GL_RED, GL_FLOAT, (void *)(uintptr_t)offset_of(first));
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

static void compute(Renderer *renderer, int view, int number)
{
    const GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    const GLuint groups = (GLuint)(renderer->scene->shadow_size + GROUP - 1) / GROUP;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, DEPTHS, volumes->vertices);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INDICES, volumes->indices);
    material_set_number(&volumes->writer, "volume_layer", (float)view);
    material_set_number(&volumes->writer, "volume_number", (float)number);
    material_use(&volumes->writer);
    gl->DispatchCompute(groups, groups, 1);
}

void volume_data_write(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const Keyword path = volume_state(renderer)->path;
    int number = 0;
    if (volume_state(renderer)->cells)
        volume_cells_write(renderer);
    if (!volume_state(renderer)->vertices)
        return;
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->shadows->maps);
    for (int view = 0; view < renderer->shadows->views.count; view++) {
        if (!volume_has_view(renderer, view))
            continue;
        const size_t first = (size_t)number * vertices_of(renderer);
        if (path == KEYWORD_Path_compute)
            compute(renderer, view, number);
        else if (is_perfect(renderer))
            copy_corners(renderer, view, first);
        else
            copy_depths(renderer, view, first);
        number++;
    }
    if (path == KEYWORD_Path_compute)
        gl->MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
}

/* -- drawing */

/* Returns the index of a view among the hybrid views. */
static int number_of(const Renderer *renderer, int view)
{
    int number = 0;
    for (int i = 0; i < view; i++)
        number += volume_has_view(renderer, i);
    return number;
}

void volume_data_draw(const Renderer *renderer, int view, bool shown)
{
    const GlContext *gl = renderer->gl;
    const FrameVolumes *volumes = volume_state(renderer);
    const int number = number_of(renderer, view);
    if (volumes->cells) {
        (shown ? volume_cells_draw_all : volume_cells_draw)(renderer, view, number);
        return;
    }
    const size_t first =
        writes_indices(renderer) ? (size_t)number * (size_t)volumes->index_count : 0;
    material_use(shown ? &volumes->shown[view] : &volumes->sheets[view]);
    gl->BindVertexArray(volumes->arrays[volumes->vertices ? number : 0]);
    gl->DrawElements(is_perfect(renderer) ? GL_TRIANGLES : GL_TRIANGLE_STRIP, volumes->index_count,
                     GL_UNSIGNED_INT, offset_of(first));
}

void volume_data_put(Text *out, const Renderer *renderer)
{
    if (volume_state(renderer)->cells)
        text_format(out, "shadow    volumes cut by silhouettes: %lu bytes of cells\n",
                    (unsigned long)volume_cells_bytes(renderer));
    if (volume_state(renderer)->arrays)
        text_format(out, "shadow    volumes by the path %s: %lu bytes\n",
                    keyword_table[volume_state(renderer)->path].name,
                    (unsigned long)bytes_of(renderer));
}

void volume_data_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    if (volumes->arrays)
        gl->DeleteVertexArrays(volumes->array_count, volumes->arrays);
    free(volumes->arrays);
    volume_cells_delete(renderer);
    gl->DeleteBuffers(1, &volumes->indices); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &volumes->vertices);
    framebuffer_delete(gl, &volumes->corners);
    if (volumes->writer.store)
        material_delete(&volumes->writer);
}
