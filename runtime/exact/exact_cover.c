/* Makes the lists of exact shadows. Buffers are sized by trying: first for headers and cells,
 * then for the counted blocks and entries. */
#include "runtime/exact/exact_cover.h"
#include "gen/exact_work_layout.h"
#include "gen/render_text.h"

enum {
    BLOCK_WORDS = 2,
    /* 16 MiB together with the header, a size that every driver supports */
    MANY_BLOCKS = (1 << 21) - 4,
    WORK_BINDING = 5,
    TRIANGLES_BINDING,
    LISTS_BINDING,
    GROUP = 64,
    CELL_GROUP = 256,
    GROUPS_MAX = 65535,
    ROW_GROUPS = 512,
    FIRST_BLOCKS = 1 << 12
};

typedef struct {
    ExactCover *cover;
    const GlContext *gl;
    const ExactTriangles *triangles;
    ExactLists heads;
    GLuint corners;
    GLuint counted[EXACT_WORK_HEAD];
} Maker;

typedef enum { DONE, AGAIN, COARSER, FAILED } Outcome;

static GlContext *context(const ExactCover *cover) { return store_context(cover->cover.store); }

static void fail_capacity(const ExactCover *cover, size_t words)
{
    gl_fail(context(cover), "shadows: exact takes %lu bytes in a buffer, and there may be %lu",
            (unsigned long)(words * sizeof(GLuint)), (unsigned long)(cover->most * sizeof(GLuint)));
}

/* Adds a quarter, within the limit, since moving objects need varying sizes. */
static size_t generous(size_t asked, size_t most)
{
    return asked + asked / 4 < most ? asked + asked / 4 : most;
}

static void make_buffer(const GlContext *gl, size_t words, GLuint *buffer)
{
    if (!*buffer)
        gl->GenBuffers(1, buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, *buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)(words * sizeof(GLuint)), NULL,
                   GL_DYNAMIC_COPY);
}

/* Enlarges the buffer of lists to `words` words. */
static bool grow_lists(ExactCover *cover, size_t words)
{
    if (cover->capacity >= words)
        return true;
    cover->capacity = generous(words, cover->most);
    make_buffer(context(cover), cover->capacity, &cover->lists);
    return gl_check(context(cover), "making room for exact shadows");
}

static bool grow_blocks(ExactCover *cover, size_t blocks)
{
    if (cover->blocks >= blocks)
        return true;
    cover->blocks = generous(blocks, MANY_BLOCKS);
    make_buffer(context(cover), EXACT_WORK_HEAD + BLOCK_WORDS * cover->blocks, &cover->work);
    return gl_check(context(cover), "making room for exact shadows");
}

/* -- programs */

static void bind(const Maker *m)
{
    m->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, WORK_BINDING, m->cover->work);
    m->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRIANGLES_BINDING, m->corners);
    m->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LISTS_BINDING, m->cover->lists);
}

/* Dispatches `groups` workgroups, or the maximum: each workgroup then loops over further ones. */
static void dispatch(const Maker *m, size_t groups, int lights)
{
    m->gl->DispatchCompute(groups < GROUPS_MAX ? (GLuint)groups : GROUPS_MAX, (GLuint)lights, 1);
    m->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

static size_t groups_of(size_t count, size_t group) { return (count + group - 1) / group; }

/* Counts entries, or lists them. */
static void cover_cells(const Maker *m, bool lists)
{
    Material *program = &m->cover->cover;
    material_set_number(program, "exact_lists", lists);
    for (int rows = 0; rows < 2; rows++) {
        material_set_number(program, "exact_rows", (float)rows);
        material_use(program);
        if (rows)
            dispatch(m, ROW_GROUPS, 1);
        else
            dispatch(m, groups_of((size_t)m->triangles->count, GROUP), m->heads.light_count);
    }
}

static size_t first_list(const Maker *m)
{
    return (size_t)m->heads.light_count * EXACT_LISTS_HEAD + EXACT_LISTS_PAIR * m->heads.cells;
}

static void begin(Maker *m)
{
    const GlContext *gl = m->gl;
    const size_t heads = (size_t)m->heads.light_count * EXACT_LISTS_HEAD * sizeof(GLuint);
    const GLuint words[EXACT_WORK_HEAD] = {[EXACT_WORK_TRIANGLES] = (GLuint)m->triangles->count,
                                           [EXACT_WORK_CELLS] = (GLuint)m->heads.cells,
                                           [EXACT_WORK_MOST] =
                                               (GLuint)(m->cover->most - first_list(m)),
                                           [EXACT_WORK_CAPACITY] = (GLuint)m->cover->blocks,
                                           [EXACT_WORK_NEXT] = (GLuint)first_list(m)};
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, m->cover->work);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof words, words);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, m->cover->lists);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)heads, m->heads.heads);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, (GLintptr)heads,
                           (GLsizeiptr)(first_list(m) * sizeof(GLuint) - heads), GL_RED_INTEGER,
                           GL_UNSIGNED_INT, NULL);
}

static bool read_counts(Maker *m)
{
    m->gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, m->cover->work);
    m->gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof m->counted, m->counted);
    return gl_check(context(m->cover), "counting triangles for exact shadows");
}

/* -- buffer sizes */

/* Enlarges the buffers if the counted entries and blocks do not fit. */
static Outcome find_capacity(Maker *m)
{
    const size_t words = first_list(m) + m->counted[EXACT_WORK_ENTRIES],
                 blocks = m->counted[EXACT_WORK_BLOCKS];
    if (words > m->cover->most || blocks > MANY_BLOCKS)
        return COARSER;
    if (words <= m->cover->capacity && blocks <= m->cover->blocks)
        return DONE;
    return grow_lists(m->cover, words) && grow_blocks(m->cover, blocks) ? AGAIN : FAILED;
}

static Outcome count(Maker *m)
{
    if (first_list(m) > m->cover->most) {
        m->counted[EXACT_WORK_ENTRIES] = 0;
        return COARSER;
    }
    if (!grow_lists(m->cover, first_list(m)) || !grow_blocks(m->cover, FIRST_BLOCKS))
        return FAILED;
    begin(m);
    bind(m);
    cover_cells(m, false);
    return read_counts(m) ? find_capacity(m) : FAILED;
}

static bool list(const Maker *m)
{
    ExactCover *cover = m->cover;
    material_use(&cover->begins);
    dispatch(m, groups_of(m->heads.cells, CELL_GROUP), 1);
    cover_cells(m, true);
    cover->words = first_list(m) + m->counted[EXACT_WORK_ENTRIES];
    cover->light_count = m->heads.light_count;
    return gl_check(context(cover), "listing triangles for exact shadows");
}

/* Counts with cells widened by 2^coarser. */
static Outcome try(Maker *m, const Scene *scene, int coarser)
{
    Outcome outcome = AGAIN;
    m->cover->coarsened = coarser;
    exact_lists_free(&m->heads);
    if (!exact_lists_make(scene, m->triangles, coarser, &m->heads))
        return gl_fail(context(m->cover), "out of memory"), FAILED;
    if (m->heads.light_count > EXACT_LISTS_LIGHTS_MAX)
        return gl_fail(context(m->cover), "%d lights have exact shadows, and %d may",
                       m->heads.light_count, EXACT_LISTS_LIGHTS_MAX),
               FAILED;
    while (outcome == AGAIN)
        outcome = count(m);
    return outcome;
}

bool exact_cover_make(ExactCover *cover, const Scene *scene, const ExactTriangles *triangles,
                      GLuint corners)
{
    Maker m = {.cover = cover, .gl = context(cover), .triangles = triangles, .corners = corners};
    Outcome outcome = COARSER;
    for (int coarser = 0; outcome == COARSER && coarser <= EXACT_LISTS_COARSEST; coarser++)
        outcome = try(&m, scene, coarser);
    if (outcome == COARSER)
        fail_capacity(cover, first_list(&m) + m.counted[EXACT_WORK_ENTRIES]);
    const bool done = outcome == DONE && list(&m);
    exact_lists_free(&m.heads);
    return done;
}

int exact_cover_longest(const ExactCover *cover)
{
    GLuint longest = 0;
    const GlContext *gl = context(cover);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, cover->work);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, EXACT_WORK_LONGEST * sizeof longest,
                         sizeof longest, &longest);
    return (int)longest;
}

bool exact_cover_open(Store *store, size_t most, ExactCover *made)
{
    const GlContext *gl = store_context(store);
    const char *head =
        gl->major * 10 + gl->minor >= 45 ? "#version 450 core\n" : "#version 430 core\n";
    *made = (ExactCover){.most = most};
    const bool done =
        material_make(store, NULL, &(ProgramText){.compute = {head, render_text_exact_cover}},
                      &made->cover) &&
        material_make(store, NULL, &(ProgramText){.compute = {head, render_text_exact_begins}},
                      &made->begins);
    if (!done)
        exact_cover_close(made);
    return done;
}

void exact_cover_empty(ExactCover *cover)
{
    const ExactCover kept = {.cover = cover->cover, .begins = cover->begins, .most = cover->most};
    if (cover->cover.store) {
        context(cover)->DeleteBuffers(1, &cover->lists); /* GL ignores the name 0 */
        context(cover)->DeleteBuffers(1, &cover->work);
    }
    *cover = kept;
}

void exact_cover_close(ExactCover *cover)
{
    exact_cover_empty(cover);
    material_delete(&cover->cover);
    material_delete(&cover->begins);
    *cover = (ExactCover){.capacity = 0};
}
