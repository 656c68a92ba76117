/* Sources of a shadow volume's vertices, selected by the scene's path. `fetch`: each vertex
 * reads the map. `copy`, as in the thesis: a map's depths are copied through a pixel buffer that
 * becomes a vertex buffer; for the perfect triangulation a texture with a texel for each corner
 * of each quad is drawn first. `compute`: a program writes depths, and for the perfect
 * triangulation the indices. Buffers are written after the maps are drawn. All three draw the
 * same triangles, corner by corner. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
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

/* Indices for a texture with 2 x 2 texels per quad, from its lower left corner around. */
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

static bool is_perfect(const Render *render)
{
    return render->scene->shadow_volume == WORD_Volume_perfect;
}

static bool has_compute(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->DispatchCompute && gl->MemoryBarrier &&
           gl->BindBufferBase;
}

/* Returns true if each view has its own indices: the program that writes them has selected
 * diagonals. */
static bool writes_indices(const Render *render)
{
    return volume_state(render)->path == WORD_Path_compute && is_perfect(render);
}

static size_t vertices_of(const Render *render)
{
    const size_t size = (size_t)render->scene->shadow_size;
    if (volume_state(render)->path == WORD_Path_fetch)
        return 0;
    return is_perfect(render) && volume_state(render)->path == WORD_Path_copy
               ? 4 * (size - 1) * (size - 1)
               : size * size;
}

static int hybrid_views(const Render *render)
{
    int count = 0;
    for (int i = 0; i < render->shadows->views.count; i++)
        count += volume_has_view(render, i);
    return count;
}

static size_t bytes_of(const Render *render)
{
    const size_t size = (size_t)render->scene->shadow_size, quads = (size - 1) * (size - 1);
    const size_t indices = writes_indices(render) ? QUAD_INDICES * quads : 0;
    return (size_t)hybrid_views(render) * (vertices_of(render) + indices) * sizeof(GLuint);
}

static bool choose(Render *render)
{
    const size_t most = (size_t)VOLUME_AUTO_MIB << 20;
    FrameVolumes *volumes = volume_state(render);
    volumes->path = render->scene->shadow_path;
    if (volumes->path == WORD_Path_compute && !has_compute(render->gl))
        return gl_fail(render->gl, "shadow volumes by compute take OpenGL 4.3");
    if (volumes->path != WORD_Path_auto)
        return true;
    volumes->path = WORD_Path_compute;
    if (volume_cells_are(render))
        return true;
    if (!has_compute(render->gl) || bytes_of(render) > most)
        volumes->path = WORD_Path_fetch;
    return true;
}

const char *volume_data_text(const Render *render, bool shown)
{
    const Word path = volume_state(render)->path;
    if (volume_cells_are(render))
        return volume_cells_head(!shown);
    if (path == WORD_Path_copy)
        return is_perfect(render) ? "#define CORNERS\n" : "#define DEPTHS\n";
    return path == WORD_Path_compute ? "#define DEPTHS\n"
           : is_perfect(render)      ? "#define QUADS\n"
                                     : "";
}

/* -- buffers */

/* Makes the indices, shared by all fetched or copied views; computed views have their own. */
static bool make_indices(Render *render)
{
    GlContext *gl = render->gl;
    FrameVolumes *volumes = volume_state(render);
    const GLuint size = (GLuint)render->scene->shadow_size;
    const size_t most = (size_t)size * size * QUAD_INDICES;
    GLuint *indices = malloc(most * sizeof *indices);
    if (!indices)
        return gl_fail(gl, "out of memory");
    if (!is_perfect(render))
        volumes->index_count = put_strips(indices, size);
    else if (volumes->path == WORD_Path_copy)
        volumes->index_count = put_corners(indices, size);
    else
        volumes->index_count = put_quads(indices, size);
    const size_t bytes = sizeof *indices * (size_t)volumes->index_count;
    const bool written = writes_indices(render);
    gl->GenBuffers(1, &volumes->indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, volumes->indices);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)(written ? bytes * (size_t)hybrid_views(render) : bytes),
                   written ? NULL : indices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(indices);
    return gl_check(gl, "making indices of shadow volumes");
}

static bool make_vertices(Render *render)
{
    GlContext *gl = render->gl;
    const size_t bytes = vertices_of(render) * (size_t)hybrid_views(render) * sizeof(float);
    if (!bytes)
        return true;
    gl->GenBuffers(1, &volume_state(render)->vertices);
    gl->BindBuffer(GL_ARRAY_BUFFER, volume_state(render)->vertices);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    return gl_check(gl, "making vertices of shadow volumes");
}

/* Returns an offset as a pointer, as GL expects. */
static const void *offset_of(size_t count)
{
    return (const void *)(uintptr_t)(count * sizeof(GLuint));
}

static void make_array(const Render *render, int number, GLuint array)
{
    const GlContext *gl = render->gl;
    gl->BindVertexArray(array);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, volume_state(render)->indices);
    if (volume_state(render)->vertices) {
        gl->BindBuffer(GL_ARRAY_BUFFER, volume_state(render)->vertices);
        gl->EnableVertexAttribArray(0);
        gl->VertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0,
                                offset_of((size_t)number * vertices_of(render)));
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    gl->BindVertexArray(0);
}

static bool make_arrays(Render *render)
{
    FrameVolumes *volumes = volume_state(render);
    volumes->array_count = volumes->vertices ? hybrid_views(render) : 1;
    volumes->arrays = calloc((size_t)volumes->array_count, sizeof *volumes->arrays);
    if (!volumes->arrays)
        return gl_fail(render->gl, "out of memory");
    render->gl->GenVertexArrays(volumes->array_count, volumes->arrays);
    for (int i = 0; i < volumes->array_count; i++)
        make_array(render, i, volumes->arrays[i]);
    return gl_check(render->gl, "making shadow volumes");
}

/* Makes the program that selects diagonals, or writes everything. */
static bool make_writer(Render *render)
{
    FrameVolumes *volumes = volume_state(render);
    const char *const quads = is_perfect(render) ? "#define QUADS\n" : "";
    const ProgramText compute = {.compute = {"#version 430 core\n", quads,
                                             render_text_shadow_volume, render_text_volume_write}};
    const ProgramText corners = {
        .vertex = {"#version 330 core\n", screen_text},
        .fragment = {"#version 330 core\n", render_text_shadow_volume, render_text_volume_corners}};
    const int edge = 2 * (render->scene->shadow_size - 1);
    if (volumes->path == WORD_Path_compute)
        return material_make(render->store, NULL, &compute, &volumes->writer);
    if (volumes->path == WORD_Path_fetch || !is_perfect(render))
        return true;
    if (edge > render->gl->max_texture_size)
        return gl_fail(render->gl,
                       "corners of shadow volumes take a texture of %d x %d, the driver has %d",
                       edge, edge, render->gl->max_texture_size);
    return material_make(render->store, NULL, &corners, &volumes->writer) &&
           framebuffer_make(render->gl, &(FramebufferSpec){edge, edge, 1, GL_R32F, false},
                            &volumes->corners);
}

bool volume_data_make(Render *render)
{
    if (!volume_lights_cast(render))
        return true;
    if (volume_cells_are(render))
        return choose(render) && volume_cells_make(render);
    return choose(render) && make_indices(render) && make_vertices(render) && make_arrays(render) &&
           make_writer(render);
}

/* -- writing */

/* Copies the depths of a map. */
static void copy_depths(const Render *render, int view, size_t first)
{
    const GlContext *gl = render->gl;
    const int size = render->scene->shadow_size;
    gl->BindFramebuffer(GL_FRAMEBUFFER, render->shadows->framebuffer);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, render->shadows->maps, 0,
                                view);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, volume_state(render)->vertices);
    gl->ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT,
                   (void *)(uintptr_t)offset_of(first));
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

static void copy_corners(Render *render, int view, size_t first)
{
    const GlContext *gl = render->gl;
    FrameVolumes *volumes = volume_state(render);
    const int edge = volumes->corners.spec.width;
    framebuffer_use(gl, &volumes->corners);
    material_set_number(&volumes->writer, "volume_layer", (float)view);
    material_use(&volumes->writer);
    screen_draw(gl, &render->screen);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, volumes->vertices);
    gl->ReadPixels(0, 0, edge, edge, GL_RED, GL_FLOAT, (void *)(uintptr_t)offset_of(first));
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

static void compute(Render *render, int view, int number)
{
    const GlContext *gl = render->gl;
    FrameVolumes *volumes = volume_state(render);
    const GLuint groups = (GLuint)(render->scene->shadow_size + GROUP - 1) / GROUP;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, DEPTHS, volumes->vertices);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INDICES, volumes->indices);
    material_set_number(&volumes->writer, "volume_layer", (float)view);
    material_set_number(&volumes->writer, "volume_number", (float)number);
    material_use(&volumes->writer);
    gl->DispatchCompute(groups, groups, 1);
}

void volume_data_write(Render *render)
{
    const GlContext *gl = render->gl;
    const Word path = volume_state(render)->path;
    int number = 0;
    if (volume_state(render)->cells)
        volume_cells_write(render);
    if (!volume_state(render)->vertices)
        return;
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, render->shadows->maps);
    for (int view = 0; view < render->shadows->views.count; view++) {
        if (!volume_has_view(render, view))
            continue;
        const size_t first = (size_t)number * vertices_of(render);
        if (path == WORD_Path_compute)
            compute(render, view, number);
        else if (is_perfect(render))
            copy_corners(render, view, first);
        else
            copy_depths(render, view, first);
        number++;
    }
    if (path == WORD_Path_compute)
        gl->MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
}

/* -- drawing */

/* Returns the index of a view among the hybrid views. */
static int number_of(const Render *render, int view)
{
    int number = 0;
    for (int i = 0; i < view; i++)
        number += volume_has_view(render, i);
    return number;
}

void volume_data_draw(const Render *render, int view, bool shown)
{
    const GlContext *gl = render->gl;
    const FrameVolumes *volumes = volume_state(render);
    const int number = number_of(render, view);
    if (volumes->cells) {
        (shown ? volume_cells_draw_all : volume_cells_draw)(render, view, number);
        return;
    }
    const size_t first = writes_indices(render) ? (size_t)number * (size_t)volumes->index_count : 0;
    material_use(shown ? &volumes->shown[view] : &volumes->sheets[view]);
    gl->BindVertexArray(volumes->arrays[volumes->vertices ? number : 0]);
    gl->DrawElements(is_perfect(render) ? GL_TRIANGLES : GL_TRIANGLE_STRIP, volumes->index_count,
                     GL_UNSIGNED_INT, offset_of(first));
}

void volume_data_put(Text *out, const Render *render)
{
    if (volume_state(render)->cells)
        text_format(out, "shadow    volumes cut by silhouettes: %lu bytes of cells\n",
                    (unsigned long)volume_cells_bytes(render));
    if (volume_state(render)->arrays)
        text_format(out, "shadow    volumes by the path %s: %lu bytes\n",
                    word_table[volume_state(render)->path].name, (unsigned long)bytes_of(render));
}

void volume_data_delete(Render *render)
{
    const GlContext *gl = render->gl;
    FrameVolumes *volumes = volume_state(render);
    if (volumes->arrays)
        gl->DeleteVertexArrays(volumes->array_count, volumes->arrays);
    free(volumes->arrays);
    volume_cells_delete(render);
    gl->DeleteBuffers(1, &volumes->indices); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &volumes->vertices);
    framebuffer_delete(gl, &volumes->corners);
    if (volumes->writer.store)
        material_delete(&volumes->writer);
}
