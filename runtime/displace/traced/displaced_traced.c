/* Ray-marched displacement: a grid of displaced triangles, and over it the acceleration
 * structure for rays: nodes of a pyramid, and hulls of patches; for parallax, base triangles. */
#include "runtime/displace/traced/displaced_traced.h"
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include <stdlib.h>

/* Binding points of buffers, as in the GLSL. */
enum {
    HULLS_BINDING = 3,
    GRID_BINDING = 4,
    NODES_BINDING = 5,
    ROWS_BINDING = DISPLACED_BINDINGS - DISPLACED_BUFFERS
};
enum { GROUP = 64, HULL_POINTS = 6, HULL_TRIANGLES = 8, NODE_FLOATS = 8, CORNERS = 3 };

static bool there(const GlContext *gl)
{
    GLint fragment = 0, compute = 0;
    if (!gl->DispatchCompute || !gl->MemoryBarrier)
        return false;
    gl->GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &fragment);
    gl->GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &compute);
    return fragment >= DISPLACED_BINDINGS && compute >= DISPLACED_BINDINGS;
}

static bool make_programs(const DisplacedMaking *making, DisplacedTrace *trace)
{
    static const char point[] = "#define DISPLACE_POINT\n#define DISPLACE_OUT\n";
    const ProgramText text = {
        .vertex = {displaced_version, render_text_trace_vertex},
        .fragment = {displaced_version, point, making->displace, render_text_displace_point,
                     render_text_trace_patch, render_text_trace_given,
                     trace->parallax ? render_text_parallax_fragment : render_text_trace_fragment}};
    const ProgramText levels = {.compute = {displaced_version, render_text_trace_patch,
                                            render_text_trace_nodes}},
                      hull = {.compute = {displaced_version, render_text_trace_patch,
                                          render_text_trace_hull}};
    ProgramText own = text;
    return displaced_program(making, &own, &trace->trace) &&
           material_make(making->store, NULL, &levels, &trace->levels) &&
           material_make(making->store, NULL, &hull, &trace->hull);
}

static void set_numbers(DisplacedTrace *trace, const char *name, int number)
{
    Material *const materials[] = {&trace->trace, &trace->levels, &trace->hull};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++)
        material_set_number(materials[i], name, (float)number);
}

/* Makes the index buffer of the hulls: per patch both ends and three sides of a prism; for
 * parallax the base triangle. */
static bool make_hulls(GlContext *gl, DisplacedTrace *trace, int patches)
{
    static const uint32_t prism[CORNERS * HULL_TRIANGLES] = {0, 2, 1, 3, 4, 5, 0, 1, 4, 0, 4, 3,
                                                             1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5};
    static const uint32_t triangle[CORNERS] = {0, 1, 2};
    const uint32_t *hull = trace->parallax ? triangle : prism;
    const int each = CORNERS * trace->triangles, points = trace->parallax ? CORNERS : HULL_POINTS;
    if (!mesh_make_captured(gl, &trace->hulls))
        return false;
    uint32_t *indices = malloc(((size_t)patches * (size_t)each + 1) * sizeof *indices);
    if (!indices)
        return gl_fail(gl, "out of memory");
    for (int i = 0; i < patches * each; i++)
        indices[i] = hull[i % each] + (uint32_t)(i / each * points);
    gl->BindBuffer(GL_ARRAY_BUFFER, trace->hulls.buffers[1]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)(patches * each) * sizeof *indices),
                   indices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, trace->hulls.buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)(patches * points) * sizeof(MeshCaptured)),
                   NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    trace->hulls.index_count = patches * each;
    free(indices);
    return gl_check(gl, "making hulls");
}

static bool make(const DisplacedMaking *making, Displaced *made)
{
    GlContext *gl = store_context(making->store);
    const ScenePatches *patches = making->patches;
    const size_t nodes = ((size_t)patches->level * (size_t)patches->level - 1) / 3;
    DisplacedTrace *trace = made->own = calloc(1, sizeof *trace);
    if (!trace)
        return gl_fail(gl, "out of memory");
    trace->parts = patches->level;
    trace->parallax = patches->method == KEYWORD_Displacing_parallax;
    trace->triangles = trace->parallax ? 1 : HULL_TRIANGLES;
    if (!displaced_grid.make(making, made) || !make_programs(making, trace) ||
        !make_hulls(gl, trace, patches->count))
        return false;
    set_numbers(trace, "trace_parts", trace->parts);
    set_numbers(trace, "trace_patches", patches->count);
    set_numbers(trace, "trace_hull", trace->triangles);
    gl->GenBuffers(1, &trace->nodes);
    return displaced_fill(gl, trace->nodes, NULL,
                          (size_t)patches->count * nodes * NODE_FLOATS * sizeof(float));
}

void displaced_traced_bind(const Displaced *d, const Mesh *mesh)
{
    const DisplacedTrace *trace = d->own;
    const GlContext *gl = displaced_context(d);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, GRID_BINDING, mesh->buffers[0]);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, NODES_BINDING, trace->nodes);
    for (GLuint i = 0; i < DISPLACED_BUFFERS; i++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, ROWS_BINDING + i, d->buffers[i]);
}

static void run(const GlContext *gl, Material *stage, int count)
{
    material_use(stage);
    gl->DispatchCompute((GLuint)((count + GROUP - 1) / GROUP), 1, 1);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

/* Computes the pyramid, from the finest level on, and the hulls. */
static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    DisplacedTrace *trace = d->own;
    const GlContext *gl = displaced_context(d);
    int level = 0;
    if (!displaced_grid.write(d, view, mesh))
        return false;
    if (!d->anew)
        return true;
    while (2 << level < trace->parts)
        level++;
    displaced_traced_bind(d, mesh);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, HULLS_BINDING, trace->hulls.buffers[0]);
    for (; level >= 0; level--) {
        material_set_number(&trace->levels, "trace_level", (float)level);
        run(gl, &trace->levels, d->patches->count << 2 * level);
    }
    run(gl, &trace->hull, d->patches->count);
    return gl_check(displaced_context(d), "making what is traced");
}

static void forget(Displaced *d)
{
    DisplacedTrace *trace = d->own;
    if (!trace)
        return;
    const GlContext *gl = displaced_context(d);
    Material *const materials[] = {&trace->trace, &trace->levels, &trace->hull};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++)
        if (materials[i]->store)
            material_delete(materials[i]);
    mesh_delete(gl, &trace->hulls);
    gl->DeleteBuffers(1, &trace->nodes);
    free(trace);
    d->own = NULL;
}

DisplacedTrace *displaced_traced(const Displaced *d)
{
    const bool traced = d->method == &displaced_by_tracing || d->method == &displaced_by_parallax;
    return d->material.store && traced ? d->own : NULL;
}

const DisplacedMethod displaced_by_tracing = {
    KEYWORD_Displacing_traced, false, there, make, write, forget};
const DisplacedMethod displaced_by_parallax = {
    KEYWORD_Displacing_parallax, false, there, make, write, forget};
