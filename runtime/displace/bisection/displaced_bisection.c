/* Bisection by compute stages, in place. From frame to frame 7 bytes are kept per triangle, its
 * number and two deviations (bisect.glsl), and its corners as they are drawn. A view evaluates
 * each leaf at most once. Leaves that are too fine merge with their siblings, until none can;
 * then leaves that are too coarse are bisected, until none is. The result depends on the view
 * alone, not on earlier views: a leaf to be bisected has only ancestors that are (bisectWants),
 * and all others exist only to keep the mesh conforming.
 *
 *     a view that comes nearer: of 1,000 leaves 5 are to be bisected; one waits for its
 *     neighbor, one for two: rounds bisect 4 edges, then 2, then 1, and add 14 triangles
 *
 * If the triangles do not suffice, the tolerated deviation is raised in steps of a fourth of an
 * octave, to the least value that suffices. */
#include "runtime/displace/bisection/bisection.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROWS_BINDING = DISPLACED_BINDINGS - DISPLACED_BUFFERS,
    GROUP = 64,
    WIDE_GROUPS = 256,
    MIN_CAPACITY = 1 << 12
};

/* -- stages */

static void bind(const Displaced *d, const Mesh *mesh)
{
    const GlContext *gl = displaced_context(d);
    const Bisection *b = d->own;
    for (GLuint i = 0; i < BISECTION_BUFFERS; i++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, i < BISECTION_CORNERS ? i : i + 1,
                           b->buffers[i]);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, BISECTION_CORNERS, mesh->buffers[0]);
    for (GLuint i = 0; i < DISPLACED_BUFFERS; i++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, ROWS_BINDING + i, d->buffers[i]);
    gl->BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, b->buffers[BISECTION_WORK]);
}

/* Issues a barrier between stages: the next stage reads what this one wrote, counts included. A
 * barrier for indirect commands takes a GPU longer than a stage, and is used on software
 * renderers only. */
static void finish(const GlContext *gl)
{
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | (gl->hardware ? 0 : GL_COMMAND_BARRIER_BIT));
}

static void dispatch(const Displaced *d, Material *stage, GLuint count)
{
    const GlContext *gl = displaced_context(d);
    material_use(stage);
    gl->DispatchCompute((count + GROUP - 1) / GROUP, 1, 1);
    finish(gl);
}

/* Dispatches the number of workgroups in the state block; on hardware a fixed number, as many as
 * run at once, which loop over the tasks. */
static void dispatch_counted(const Displaced *d, Material *stage, int groups)
{
    const GlContext *gl = displaced_context(d);
    material_use(stage);
    if (gl->hardware)
        gl->DispatchCompute(WIDE_GROUPS, 1, 1);
    else
        gl->DispatchComputeIndirect((GLintptr)((size_t)groups * sizeof(GLuint)));
    finish(gl);
}

/* Copies the state block through a separate buffer, since a driver may move a buffer that the
 * CPU reads or writes to CPU memory. */
static void copy_head(const Displaced *d, GLuint from, GLuint to)
{
    const GlContext *gl = displaced_context(d);
    gl->BindBuffer(GL_COPY_READ_BUFFER, from);
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, to);
    gl->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                          BISECTION_STATE_WORDS * sizeof(GLuint));
}

static void read_head(const Displaced *d)
{
    Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    gl->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    copy_head(d, b->buffers[BISECTION_WORK], b->head_copy);
    gl->GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof b->head, b->head);
}

static void write_head(const Displaced *d, GLuint high, GLuint free)
{
    Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    memset(b->head, 0, sizeof b->head);
    b->head[BISECTION_HIGH] = high;
    b->head[BISECTION_FREE] = free;
    b->head[BISECTION_LIGHTS] = (GLuint)b->lights.count;
    memcpy(&b->head[BISECTION_LIGHT], b->lights.each, sizeof b->lights.each);
    memcpy(&b->head[BISECTION_BOX], b->lights.box, sizeof b->lights.box);
    memcpy(&b->head[BISECTION_EXTENT], b->lights.extent, sizeof b->lights.extent);
    gl->BindBuffer(GL_COPY_READ_BUFFER, b->head_copy);
    gl->BufferData(GL_COPY_READ_BUFFER, sizeof b->head, b->head, GL_STREAM_READ);
    copy_head(d, b->head_copy, b->buffers[BISECTION_WORK]);
}

/* Runs all remaining rounds of few triangles in one workgroup, on hardware only. */
static void run_few(const Displaced *d)
{
    const GlContext *gl = displaced_context(d);
    Bisection *b = d->own;
    if (!gl->hardware)
        return;
    material_use(&b->stages[BISECTION_FEW]);
    gl->DispatchCompute(1, 1, 1);
    finish(gl);
}

/* Issues several rounds at once: if the work ends earlier, the rest have no tasks. */
static void run_rounds(Displaced *d, int merging, int splitting)
{
    Bisection *b = d->own;
    for (int i = 0; i < merging; i++) {
        dispatch_counted(d, &b->stages[BISECTION_MERGE_CHOOSE], BISECTION_GROUPS);
        dispatch_counted(d, &b->stages[BISECTION_MERGE], BISECTION_GROUPS_CHOSEN);
    }
    run_few(d);
    for (int i = 0; i < splitting; i++) {
        dispatch_counted(d, &b->stages[BISECTION_CHOOSE], BISECTION_GROUPS);
        dispatch_counted(d, &d->material, BISECTION_GROUPS_CHOSEN);
    }
    if (splitting)
        run_few(d);
}

/* Stamps a new evaluation: table entries of earlier ones are empty by their stamps. After 255
 * evaluations the table is cleared, which takes longer than all else of an evaluation. */
static void stamp_table(Displaced *d)
{
    enum { STAMPS = 255 };
    Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    const GLuint none = 0;
    if (!b->stamp) {
        gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, b->buffers[BISECTION_TABLE]);
        gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0,
                               (GLsizeiptr)(((size_t)1 << b->table_bits) * sizeof none),
                               GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    }
    bisection_set_number(d, "bisect_stamp", b->stamp + 1);
    b->stamp = (b->stamp + 1) % STAMPS;
}

/* Forgets earlier views: all leaves are entered into a new table, and evaluated. */
static void begin_anew(Displaced *d, double pixels)
{
    Bisection *b = d->own;
    stamp_table(d);
    b->pixels = pixels;
    b->gone = b->entries = 0;
}

/* Evaluates leaves. On hardware the stage's workgroups find the due tiles themselves; otherwise
 * the scan stage does. */
static void look(const Displaced *d, GLuint high)
{
    enum { LOOK_TILES = 16 /* tiles evaluated per workgroup */ };
    Bisection *b = d->own;
    const GLuint tiles = (high + (GLuint)b->tile - 1) / (GLuint)b->tile;
    if (displaced_context(d)->hardware) {
        dispatch(d, &b->stages[BISECTION_LOOK], (tiles + LOOK_TILES - 1) / LOOK_TILES * GROUP);
        return;
    }
    dispatch(d, &b->stages[BISECTION_SCAN], tiles);
    dispatch_counted(d, &b->stages[BISECTION_LOOK], BISECTION_GROUPS);
}

/* Moves leaves from the end into free slots, after merging has freed many slots. */
static void pack(Displaced *d)
{
    enum { SHARE = 32 }; /* maximum share of free slots: 1 / 32 */
    Bisection *b = d->own;
    const GLuint free = b->head[BISECTION_FREE], live = b->head[BISECTION_HIGH] - free;
    if (free <= live / SHARE)
        return;
    dispatch(d, &b->stages[BISECTION_PACK_CHOOSE], free);
    dispatch(d, &b->stages[BISECTION_PACK], free);
    b->entries += free;
    b->head[BISECTION_HIGH] = live;
    b->head[BISECTION_FREE] = 0;
}

/* Evaluates, merges and bisects leaves for the view. False: not enough slots. */
static bool update(Displaced *d)
{
    enum {
        MORE = 4,
        MOST = 16,
        ENTRIES = 4 /* table entries per slot that a view's rounds may add */
    };
    Bisection *b = d->own;
    const GLuint high = b->head[BISECTION_HIGH];
    const double pixels = d->patches->pixels * exp2(b->coarser / 4.);
    const bool fresh =
        b->pixels != pixels || b->entries > ldexp(1, b->table_bits) - (double)ENTRIES * b->capacity;
    if (fresh)
        begin_anew(d, pixels);
    write_head(d, high, fresh ? 0 : b->head[BISECTION_FREE]);
    bisection_set_number(d, "bisect_pixels", pixels);
    bisection_set_number(d, "bisect_fresh", fresh);
    bisection_set_number(d, "bisect_gone", b->gone);
    look(d, high);
    b->looks++;
    /* On hardware run_few() finishes the rounds that are left. */
    const int one_more = displaced_context(d)->hardware ? 0 : 1;
    int merging = b->rounds[0] + one_more, splitting = b->rounds[1] + one_more;
    do {
        run_rounds(d, merging, splitting);
        read_head(d);
        merging = b->head[BISECTION_MERGED_ALL] ? 0 : MORE;
        splitting = MORE;
    } while (!b->head[BISECTION_FULL] && !b->head[BISECTION_LOST] &&
             (!b->head[BISECTION_MERGED_ALL] || b->head[BISECTION_WANTED]));
    for (int i = 0; i < 2; i++)
        b->rounds[i] = (int)b->head[BISECTION_MERGE_ROUNDS + i] < MOST
                           ? (int)b->head[BISECTION_MERGE_ROUNDS + i]
                           : MOST;
    b->splits += (int)b->head[BISECTION_SPLITS];
    b->merges += (int)b->head[BISECTION_MERGES];
    b->looked += b->tile * (int)b->head[BISECTION_LOOKED];
    b->entries += (fresh ? high : 0) + b->head[BISECTION_MERGES] + 2. * b->head[BISECTION_SPLITS];
    if (b->head[BISECTION_FULL])
        b->pixels = 0;
    return !b->head[BISECTION_FULL];
}

static bool settle(Displaced *d, Mesh *mesh)
{
    Bisection *b = d->own;
    int enough = 0; /* known lower bound of `coarser` */
    for (;;) {
        const bool fits = update(d);
        if (b->head[BISECTION_LOST])
            return gl_fail(displaced_context(d), "bisection lost a neighbor");
        if (!fits && b->capacity < b->most) {
            if (!bisection_capacity(d, mesh, b->capacity < b->most / 2 ? 2 * b->capacity : b->most))
                return false;
            bind(d, mesh);
        } else if (!fits) {
            enough = ++b->coarser;
        } else if (b->coarser > enough) {
            b->coarser--;
        } else {
            pack(d);
            return true;
        }
    }
}

/* -- views */

static bool begin(Displaced *d, Mesh *mesh)
{
    Bisection *b = d->own;
    const int bases = d->patches->count,
              capacity = 2 * bases > MIN_CAPACITY ? 2 * bases : MIN_CAPACITY;
    if (!bisection_capacity(d, mesh, capacity < b->most ? capacity : b->most))
        return false;
    bind(d, mesh);
    write_head(d, (GLuint)bases, 0);
    for (int level = b->ranged; level >= -1; level--) {
        material_set_number(&b->stages[BISECTION_BEGIN], "bisect_level", (float)level);
        dispatch(d, &b->stages[BISECTION_BEGIN], (GLuint)bases << (level > 0 ? level : 0));
    }
    return gl_check(displaced_context(d), "bisecting a mesh");
}

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    const bool first = !b->capacity;
    const BisectionLights lights = bisection_view_lights(view);
    d->anew = false;
    if (!first && !memcmp(&b->camera, &view->scene->camera, sizeof b->camera) &&
        !memcmp(b->size, view->size, sizeof b->size) && !memcmp(&b->lights, &lights, sizeof lights))
        return true;
    if (first && !begin(d, mesh))
        return false;
    bisection_view_move(d, view, &lights);
    b->lights = lights;
    b->camera = view->scene->camera;
    memcpy(b->size, view->size, sizeof b->size);
    b->splits = b->merges = b->looks = b->looked = 0;
    bisection_view_set(d, view, mesh);
    bind(d, mesh);
    const bool fine = settle(d, mesh);
    gl->BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
    gl->MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
                      GL_BUFFER_UPDATE_BARRIER_BIT);
    d->anew = first || b->splits || b->merges;
    d->points = 3 * (int)b->head[BISECTION_HIGH];
    mesh->index_count = d->points;
    return fine && gl_check(displaced_context(d), "bisecting a mesh");
}

DisplacedBisectionCost displaced_bisection_cost(const Displaced *d)
{
    const Bisection *b = d->own;
    return (DisplacedBisectionCost){
        .leaves = (int)(b->head[BISECTION_HIGH] - b->head[BISECTION_FREE]),
        .splits = b->splits,
        .merges = b->merges,
        .kept = bisection_leaf_bytes(b->head[BISECTION_HIGH]) +
                2 * sizeof(GLuint) * ((size_t)d->patches->count << (b->ranged + 1)),
        .scratch = (sizeof(GLuint) << b->table_bits) + bisection_work_bytes(b, (size_t)b->capacity),
        .looks = b->looks,
        .looked = b->looked,
        .pixels = d->patches->pixels * exp2(b->coarser / 4.)};
}

uint64_t *displaced_bisection_leaves(const Displaced *d, int *count)
{
    const Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    const size_t places = b->head[BISECTION_HIGH];
    const int base_bits = bisection_base_bits(d->patches);
    const size_t bytes = bisection_leaf_bytes(places);
    uint32_t *words = malloc(bytes + sizeof *words);
    uint64_t *leaves = malloc((places + 1) * sizeof *leaves);
    *count = 0;
    if (words && leaves) {
        gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, b->buffers[BISECTION_LEAVES]);
        gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)bytes, words);
        gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
        for (size_t i = 0; i < places; i++) {
            const uint32_t *block = words + i / 4 * 7;
            const uint64_t id = block[i % 4] | (uint64_t)(block[4] >> 8 * (i % 4) & 255) << 32;
            if (id)
                leaves[(*count)++] =
                    (id & (((uint64_t)1 << base_bits) - 1)) << 32 | id >> base_bits;
        }
    } else {
        gl_fail(displaced_context(d), "out of memory");
        free(leaves);
        leaves = NULL;
    }
    free(words);
    return leaves;
}

const DisplacedMethod displaced_bisection = {KEYWORD_Displacing_bisection,
                                             true,
                                             bisection_supported,
                                             bisection_make,
                                             write,
                                             bisection_forget};
