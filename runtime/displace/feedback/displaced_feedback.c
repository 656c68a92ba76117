/* Displacement by transform feedback, with two programs: one divides triangles, pass after pass,
 * from one of two buffers into the other; the other displaces the result. displace_divide.glsl
 * selects the triangles to divide. Buffers grow as needed: a pass whose output did not fit is
 * repeated.
 *
 *     Two triangles of a square, three passes, all near: 2, 8, 32, 128. */
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include <stdlib.h>
#include <string.h>

enum {
    TRIANGLES = 1 << 24, /* max triangles of a buffer */
    /* limit per draw, each triangle becoming at most 16: displaced_tessellation.c */
    SOFTWARE_TRIANGLES = (1 << 15) / 48,
    FINAL = 1,
    LOWER = 2 /* flags of vertices, as in displace_divide.glsl */
};

/* A vertex in a transform feedback buffer. */
typedef struct {
    uint32_t patch, flags;
    float weights[2];
} Divided;

typedef struct {
    Material divide;
    GLuint buffers[2], arrays[2];
    size_t capacity[2]; /* capacity of the buffers in triangles */
    int from;           /* index of the buffer that was written last */
    double eye[3];      /* eye for which triangles were divided */
} Feedback;

static bool there(const GlContext *gl)
{
    return displaced_geometry_supported(gl) && gl->VertexAttribIPointer;
}

/* -- programs and buffers */

static int skirts_of(const ScenePatches *patches)
{
    switch (patches->dividing.skirts) {
    case KEYWORD_Skirts_all:
        return 1;
    case KEYWORD_Skirts_borders:
        return 2;
    case KEYWORD_Skirts_none:
    case KEYWORD_Skirts_copy:
        return 0;
    default:
        return 3;
    }
}

static double area_of(const ScenePatches *patches, int patch)
{
    const double *m = patches->world_from_local.m;
    double way[2][3], square = 0;
    for (int k = 0; k < 2; k++) {
        const float *a = patches->rows[patches->at[patch].own[0]].position,
                    *b = patches->rows[patches->at[patch].own[k + 1]].position;
        for (int i = 0; i < 3; i++)
            way[k][i] = m[i] * ((double)b[0] - (double)a[0]) +
                        m[4 + i] * ((double)b[1] - (double)a[1]) +
                        m[8 + i] * ((double)b[2] - (double)a[2]);
    }
    for (int i = 0; i < 3; i++) {
        const double component =
            way[0][(i + 1) % 3] * way[1][(i + 2) % 3] - way[0][(i + 2) % 3] * way[1][(i + 1) % 3];
        square += component * component;
    }
    return square / 4; /* squared area */
}

/* Returns true if areas differ by more than 1 %, the squares by 2 %: then neighbors are divided
 * at different distances, even if both are final. */
static bool uneven(const ScenePatches *patches)
{
    const double first = area_of(patches, 0), part = .02;
    bool differs = false;
    for (int i = 1; i < patches->count && !differs; i++) {
        const double other = area_of(patches, i) / first;
        differs = other < 1 - part || other > 1 + part;
    }
    return differs;
}

static void set_uniforms(const ScenePatches *patches, Material *divide)
{
    float world[16];
    for (int i = 0; i < 16; i++)
        world[i] = (float)patches->world_from_local.m[i];
    material_set(divide, &(MaterialValue){"matc_worldFromLocal", 16, world});
    material_set_number(divide, "displace_near", (float)patches->dividing.near);
    material_set_number(divide, "displace_detail", (float)patches->dividing.detail);
    material_set_number(divide, "displace_skirts", (float)skirts_of(patches));
    material_set_number(divide, "displace_uneven", (float)uneven(patches));
}

static void make_arrays(const GlContext *gl, Feedback *own)
{
    gl->GenBuffers(2, own->buffers);
    gl->GenVertexArrays(2, own->arrays);
    for (int i = 0; i < 2; i++) {
        gl->BindVertexArray(own->arrays[i]);
        gl->BindBuffer(GL_ARRAY_BUFFER, own->buffers[i]);
        gl->EnableVertexAttribArray(0);
        gl->EnableVertexAttribArray(1);
        gl->VertexAttribIPointer(0, 2, GL_UNSIGNED_INT, sizeof(Divided), NULL);
        gl->VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Divided),
                                (const void *)offsetof(Divided, weights));
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

static bool make(const DisplacedMaking *making, Displaced *made)
{
    static const char *const captured[] = {"feedback_state", "feedback_weights"};
    ProgramText move = {.vertex = {displaced_version, "#define DISPLACE_POINT\n", making->displace,
                                   render_text_displace_point, render_text_displace_move}};
    const ProgramText divide = {
        .vertex = {displaced_version, render_text_displace_divide_vertex},
        .geometry = {displaced_version, render_text_displace_point, render_text_displace_divide},
        .fragment = {displaced_version, "void main() {}\n"},
        .captured = captured,
        .captured_count = 2};
    Feedback *own = calloc(1, sizeof *own);
    made->own = own;
    if (!own)
        return gl_fail(store_context(making->store), "out of memory");
    if (!displaced_program(making, &move, &made->material)) {
        free(own);
        return false;
    }
    if (!material_make(making->store, NULL, &divide, &own->divide))
        return false;
    set_uniforms(making->patches, &own->divide);
    make_arrays(store_context(making->store), own);
    return true;
}

static void forget(Displaced *d)
{
    const GlContext *gl = displaced_context(d);
    Feedback *own = d->own;
    gl->DeleteBuffers(2, own->buffers);
    gl->DeleteVertexArrays(2, own->arrays);
    if (own->divide.store)
        material_delete(&own->divide);
    free(own);
}

/* -- passes */

static void reserve(const GlContext *gl, Feedback *own, int buffer, size_t triangles)
{
    own->capacity[buffer] = triangles;
    gl->BindBuffer(GL_ARRAY_BUFFER, own->buffers[buffer]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(3 * triangles * sizeof(Divided)), NULL,
                   GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

/* Writes the patches to the first buffer; with skirts `copy` also a final, lowered copy of each.
 * Returns the number of triangles; -1: out of memory. */
static int begin_with_patches(const Displaced *d, Feedback *own)
{
    static const float corner[3][2] = {{1, 0}, {0, 1}, {0, 0}};
    const GlContext *gl = displaced_context(d);
    const int patches = d->patches->count,
              count = patches * (d->patches->dividing.skirts == KEYWORD_Skirts_copy ? 2 : 1);
    Divided *vertices = calloc(3 * (size_t)count + 1, sizeof *vertices);
    for (int i = 0; vertices && i < 3 * count; i++)
        vertices[i] = (Divided){(uint32_t)(i / 3 % patches),
                                i / 3 < patches ? 0 : FINAL | LOWER,
                                {corner[i % 3][0], corner[i % 3][1]}};
    if (!vertices)
        return -1;
    own->from = 0;
    if (own->capacity[0] < (size_t)count)
        reserve(gl, own, 0, (size_t)count);
    gl->BindBuffer(GL_ARRAY_BUFFER, own->buffers[0]);
    gl->BufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(3 * (size_t)count * sizeof *vertices),
                      vertices);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(vertices);
    return count;
}

/* Draws few triangles at a time on Mesa's software renderers. */
static void draw_triangles(const GlContext *gl, int count)
{
    const int most = gl->hardware ? count : SOFTWARE_TRIANGLES;
    for (int first = 0; first < count; first += most)
        gl->DrawArrays(GL_TRIANGLES, 3 * first, 3 * (count - first < most ? count - first : most));
}

/* Divides from one buffer into the other, up to its capacity; returns the number of triangles
 * that the pass would write. */
static int divide_once(const GlContext *gl, Feedback *own, int count)
{
    GLuint query, made = 0;
    gl->GenQueries(1, &query);
    material_use(&own->divide);
    gl->BindVertexArray(own->arrays[own->from]);
    gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, own->buffers[!own->from], 0,
                        (GLsizeiptr)(3 * own->capacity[!own->from] * sizeof(Divided)));
    gl->BeginQuery(GL_PRIMITIVES_GENERATED, query);
    gl->BeginTransformFeedback(GL_TRIANGLES);
    draw_triangles(gl, count);
    gl->EndTransformFeedback();
    gl->EndQuery(GL_PRIMITIVES_GENERATED);
    gl->GetQueryObjectuiv(query, GL_QUERY_RESULT, &made);
    gl->DeleteQueries(1, &query);
    return (int)made;
}

/* Runs all passes; returns the number of triangles, -1 if too many. */
static int divide_all(Displaced *d, Feedback *own, int count)
{
    const GlContext *gl = displaced_context(d);
    const int steps = d->patches->dividing.steps;
    for (int step = 0, made; step < steps; step++) {
        material_set_number(&own->divide, "displace_last", step == steps - 1);
        const size_t four = 4 * (size_t)count < TRIANGLES ? 4 * (size_t)count : TRIANGLES;
        if (own->capacity[!own->from] < four)
            reserve(gl, own, !own->from, four);
        while ((made = divide_once(gl, own, count)) > TRIANGLES ||
               (size_t)made > own->capacity[!own->from]) {
            if (made > TRIANGLES)
                return -1;
            reserve(gl, own, !own->from, (size_t)made);
        }
        own->from = !own->from;
        if (made == count)
            break; /* all triangles are final: stop */
        count = made;
    }
    return count;
}

static bool move(Displaced *d, const Feedback *own, int count, Mesh *mesh)
{
    const GlContext *gl = displaced_context(d);
    const size_t bytes = 3 * (size_t)count * sizeof(MeshCaptured);
    displaced_reserve(d, mesh, 0, 3 * (size_t)count * sizeof(MeshCaptured));
    material_use(&d->material);
    gl->BindVertexArray(own->arrays[own->from]);
    gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, mesh->buffers[0], 0, (GLsizeiptr)bytes);
    gl->BeginTransformFeedback(GL_POINTS);
    gl->DrawArrays(GL_POINTS, 0, 3 * count);
    gl->EndTransformFeedback();
    return displaced_end(d) && displaced_unshared(d, mesh, count);
}

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    Feedback *own = d->own;
    d->anew = !d->written || memcmp(own->eye, view->scene->camera.position, sizeof own->eye) != 0;
    if (!d->anew)
        return true;
    memcpy(own->eye, view->scene->camera.position, sizeof own->eye);
    const float eye[3] = {(float)own->eye[0], (float)own->eye[1], (float)own->eye[2]};
    material_set(&own->divide, &(MaterialValue){"displace_eye", 3, eye});
    int count = begin_with_patches(d, own);
    if (count < 0)
        return gl_fail(displaced_context(d), "out of memory");
    displaced_begin(d);
    count = divide_all(d, own, count);
    if (count >= 0)
        return move(d, own, count, mesh);
    displaced_end(d);
    return gl_fail(displaced_context(d),
                   "displacement by feedback makes more than %d triangles: fewer `steps`, or less "
                   "`detail`, makes fewer",
                   TRIANGLES);
}

const DisplacedMethod displaced_feedback = {
    KEYWORD_Displacing_feedback, true, there, make, write, forget};
