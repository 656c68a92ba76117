/* Programs and buffers of bisection, and the buffers' sizes. */
#include "gen/render_text.h"
#include "runtime/displace/bisection/bisection.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    CORNER_BYTES = 3 * sizeof(MeshCaptured),
    ID_BITS = 40,
    DEEPEST = 28,
    /* Deviations are evaluated on parts of a size at which a base has as many as it has
     * final triangles, divided by this number. */
    SAMPLES_SHARE = 8,
    /* at most 2^6 parts per triangle: leaves coarser than that are always bisected */
    PARTS_MAX = 6,
    PLACE_BITS = 24, /* bits of a leaf's slot in the table */
    RANGE_PARTS = 4  /* ranges are stored down to triangles of 2^4 parts */
};

_Static_assert(sizeof(MeshCaptured) == BISECTION_ROW * sizeof(float),
               "a row of the layout is a corner of the mesh");

bool bisection_supported(const GlContext *gl)
{
    GLint blocks = 0;
    if (!gl->DispatchCompute || !gl->DispatchComputeIndirect || !gl->MemoryBarrier ||
        !gl->ClearBufferSubData || !gl->CopyBufferSubData)
        return false;
    gl->GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    return blocks >= BISECTION_BUFFERS + DISPLACED_BUFFERS;
}

/* -- programs */

bool bisection_casts(const SceneLight *light)
{
    return scene_light_casts(light) && light_from(light) < LIGHT_FROM_around;
}

static const char with_lights[] = "#define BISECT_LIGHTS\n";

/* Defines the lights' macro. Programs for a scene without shadow-casting lights omit the loop
 * over lights: llvmpipe pays even for loops that are not entered. */
static const char *lights_of(const Scene *scene)
{
    bool casts = false;
    for (int i = 0; i < scene->light_count; i++)
        casts |= bisection_casts(&scene->lights[i]);
    return casts ? with_lights : "\n";
}

/* The stages: their defines and texts. */
typedef struct {
    const char *define, *text[2];
    bool alone; /* the pass is not followed by bisect_next.glsl */
} Stage;

static bool make_moving(const DisplacedMaking *making, const char *define, const ProgramText *rest,
                        Material *made)
{
    static const char point[] = "#define DISPLACE_POINT\n#define DISPLACE_OUT\n";
    ProgramText text = {.compute = {displaced_version, define, point, making->displace,
                                    render_text_displace_point}};
    int at = 0, from = 0;
    while (text.compute[at])
        at++;
    while (rest->compute[from])
        text.compute[at++] = rest->compute[from++];
    return displaced_program(making, &text, made);
}

/* NVIDIA's compiler takes 13 s for the program of all rounds with lights, and 4 s if its loops
 * are not unrolled, which makes views slower by up to a ninth of a millisecond. Without lights
 * it takes 4 s anyway, and loops are unrolled. Other compilers ignore the unknown pragma. */
static const char with_loops[] = "#pragma optionNV(unroll none)\n";
enum { DEFINES = 64, FEW_DEFINES = DEFINES + sizeof with_loops };

/* Makes the stages that displace points. */
static bool make_moving_stages(const DisplacedMaking *making, const char *defines, Displaced *made)
{
    Bisection *b = made->own;
    const bool wide = store_context(making->store)->hardware;
    char few_defines[FEW_DEFINES];
    snprintf(few_defines, sizeof few_defines, "%s%s", defines,
             strstr(defines, with_lights) ? with_loops : "");
    static const char step[] = "#define BISECT_STEP 4\n#define BISECT_STAGE bisectSplit\n";
    const ProgramText split = {.compute = {step, render_text_bisect, render_text_bisect_see,
                                           render_text_bisect_split, render_text_bisect_next}},
                      few = {.compute = {"#define BISECT_FEW\n", render_text_bisect,
                                         render_text_bisect_see, render_text_bisect_merge,
                                         render_text_bisect_choose, render_text_bisect_split,
                                         render_text_bisect_next,
                                         render_text_bisect_single_workgroup}},
                      begin = {.compute = {render_text_bisect, render_text_bisect_see,
                                           render_text_bisect_split}};
    return make_moving(making, defines, &split, &made->material) &&
           (!wide || make_moving(making, few_defines, &few, &b->stages[BISECTION_FEW])) &&
           make_moving(making, "#define BISECT_BEGIN\n", &begin, &b->stages[BISECTION_BEGIN]);
}

static bool make_stages(const DisplacedMaking *making, Displaced *made, Bisection *b)
{
    static const Stage stages[] = {
        [BISECTION_SCAN] =
            {"#define BISECT_STEP 5\n#define BISECT_STAGE bisectStage\n#define BISECT_SCAN\n",
             {render_text_bisect_scan, ""},
             false},
        [BISECTION_LOOK] = {"#define BISECT_STEP 0\n#define BISECT_STAGE bisectStage\n",
                            {render_text_bisect_scan, render_text_bisect_evaluate},
                            false},
        [BISECTION_MERGE_CHOOSE] =
            {"#define BISECT_STEP 1\n#define BISECT_STAGE bisectMergeChoose\n",
             {render_text_bisect_merge, ""},
             false},
        [BISECTION_MERGE] = {"#define BISECT_STEP 2\n#define BISECT_STAGE bisectMerge\n",
                             {render_text_bisect_merge, ""},
                             false},
        [BISECTION_CHOOSE] = {"#define BISECT_STEP 3\n#define BISECT_STAGE bisectChoose\n",
                              {render_text_bisect_choose, ""},
                              false},
        [BISECTION_PACK_CHOOSE] = {"#define BISECT_CHOOSE\n", {render_text_bisect_pack, ""}, true},
        [BISECTION_PACK] = {"\n", {render_text_bisect_pack, ""}, true},
    };
    const char *lights = lights_of(making->scene),
               *wide = store_context(making->store)->hardware ? "#define BISECT_WIDE\n" : "\n";
    char defines[DEFINES];
    snprintf(defines, sizeof defines, "%s%s", lights, wide);
    bool fine = make_moving_stages(making, defines, made);
    for (int i = 0; fine && i < BISECTION_BEGIN; i++) {
        const ProgramText text = {.compute = {displaced_version, defines, stages[i].define,
                                              render_text_bisect, render_text_bisect_see,
                                              stages[i].text[0], stages[i].text[1],
                                              stages[i].alone ? NULL : render_text_bisect_next}};
        fine = material_make(making->store, NULL, &text, &b->stages[i]);
    }
    return fine;
}

static int bits_of(size_t count)
{
    int bits = 0;
    while ((size_t)1 << bits < count)
        bits++;
    return bits;
}

void bisection_set(Displaced *d, const char *name, int components, const float *values)
{
    Bisection *b = d->own;
    for (int i = 0; i < BISECTION_STAGES; i++)
        if (b->stages[i].store)
            material_set(&b->stages[i], &(MaterialValue){name, components, values});
    material_set(&d->material, &(MaterialValue){name, components, values});
}

void bisection_set_number(Displaced *d, const char *name, double number)
{
    const float value = (float)number;
    bisection_set(d, name, 1, &value);
}

/* -- buffers */

static void new_buffer(const GlContext *gl, GLuint buffer, size_t bytes, const void *from)
{
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, from, GL_DYNAMIC_COPY);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

/* Enlarges a buffer and keeps its contents. */
static void grow_buffer(const GlContext *gl, GLuint buffer, size_t had, size_t bytes)
{
    GLuint kept;
    gl->GenBuffers(1, &kept);
    new_buffer(gl, kept, had + 1, NULL);
    for (int back = 0; back < 2; back++) {
        gl->BindBuffer(GL_COPY_READ_BUFFER, back ? kept : buffer);
        gl->BindBuffer(GL_COPY_WRITE_BUFFER, back ? buffer : kept);
        if (back)
            gl->BufferData(GL_COPY_WRITE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_COPY);
        if (had)
            gl->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, (GLsizeiptr)had);
    }
    gl->BindBuffer(GL_COPY_READ_BUFFER, 0);
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, 0);
    gl->DeleteBuffers(1, &kept);
}

size_t bisection_work_bytes(const Bisection *b, size_t places)
{
    return sizeof(GLuint) *
           (BISECTION_STATE_WORDS + BISECTION_LIST_DUE * places + places / (size_t)b->tile + 1);
}

size_t bisection_leaf_bytes(size_t places)
{
    return sizeof(GLuint) * BISECTION_BLOCK_WORDS *
           ((places + BISECTION_BLOCK - 1) / BISECTION_BLOCK);
}

/* Resizes the buffers to `capacity` leaves. A fresh evaluation adds one table entry per slot, and a
 * view's rounds add one per merge and two per bisection: update() starts a new table when not
 * enough entries are free. */
bool bisection_capacity(Displaced *d, Mesh *mesh, int capacity)
{
    Bisection *b = d->own;
    const GlContext *gl = displaced_context(d);
    const size_t had = (size_t)b->capacity, places = (size_t)capacity;
    b->capacity = capacity;
    b->table_bits = bits_of(5 * places);
    b->stamp = 0;
    b->pixels = 0;
    grow_buffer(gl, b->buffers[BISECTION_LEAVES], bisection_leaf_bytes(had),
                bisection_leaf_bytes(places));
    grow_buffer(gl, mesh->buffers[0], had * CORNER_BYTES, places * CORNER_BYTES);
    new_buffer(gl, b->buffers[BISECTION_TABLE], ((size_t)1 << b->table_bits) * sizeof(GLuint),
               NULL);
    new_buffer(gl, b->buffers[BISECTION_WORK], bisection_work_bytes(b, places), NULL);
    bisection_set_number(d, "bisect_capacity", capacity);
    bisection_set_number(d, "bisect_tableBits", b->table_bits);
    return displaced_unshared(d, mesh, capacity);
}

static int most_of(const GlContext *gl, const ScenePatches *patches)
{
    GLint bytes = 0;
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    const int most = patches->triangles > patches->count ? patches->triangles : patches->count,
              held = bytes / (int)CORNER_BYTES;
    const int least = most < held ? most : held;
    return least < 1 << PLACE_BITS ? least : (1 << PLACE_BITS) - 1;
}

int bisection_base_bits(const ScenePatches *patches)
{
    /* min bits of a base's number, so that 32 bits hold a triangle's number */
    enum { LEAST = 8 };
    /* the highest number belongs to no base */
    const int bits = bits_of((size_t)patches->count + 1);
    return bits > LEAST ? bits : LEAST;
}

static void find_box(const ScenePatches *patches, const float reach[3], double box[2][3])
{
    for (int i = 0; i < 3; i++) {
        box[0][i] = INFINITY;
        box[1][i] = -INFINITY;
        for (int row = 0; row < patches->row_count; row++) {
            double at = patches->world_from_local.m[12 + i];
            for (int component = 0; component < 3; component++)
                at += patches->world_from_local.m[4 * component + i] *
                      (double)patches->rows[row].position[component];
            box[0][i] = fmin(box[0][i], at - (double)reach[i]);
            box[1][i] = fmax(box[1][i], at + (double)reach[i]);
        }
    }
}

static void set_constants(Displaced *d)
{
    const ScenePatches *patches = d->patches;
    const int base_bits = bisection_base_bits(patches);
    const int deepest = ID_BITS - base_bits - 4 < DEEPEST ? ID_BITS - base_bits - 4 : DEEPEST;
    const int wanted =
        bits_of((size_t)patches->triangles / SAMPLES_SHARE) - bits_of((size_t)patches->count);
    const int even = wanted < 0 ? 0 : wanted < deepest ? wanted : deepest;
    float reach[3] = {0};
    for (int i = 0; i < 9; i++)
        reach[i % 3] +=
            (float)(fabs(patches->world_from_local.m[4 * (i / 3) + i % 3]) * patches->reach[i / 3]);
    bisection_set_number(d, "bisect_baseBits", base_bits);
    bisection_set_number(d, "bisect_deepest", deepest);
    const double reached =
        sqrt((double)(reach[0] * reach[0] + reach[1] * reach[1] + reach[2] * reach[2]));
    bisection_set_number(d, "bisect_worst", reached > 0 ? exp2(ceil(log2(2 * reached))) : 1);
    bisection_set_number(d, "bisect_even", even);
    bisection_set_number(d, "bisect_coarse", even > PARTS_MAX ? even - PARTS_MAX : 0);
    bisection_set(d, "bisect_reach", 3, reach);
    Bisection *b = d->own;
    find_box(patches, reach, b->box);
    b->ranged = even > RANGE_PARTS ? even - RANGE_PARTS : 0;
    bisection_set_number(d, "bisect_ranged", b->ranged);
    new_buffer(displaced_context(d), b->buffers[BISECTION_RANGES],
               2 * sizeof(GLuint) * ((size_t)patches->count << (b->ranged + 1)), NULL);
}

bool bisection_make(const DisplacedMaking *making, Displaced *made)
{
    GlContext *gl = store_context(making->store);
    Bisection *b = made->own = calloc(1, sizeof *b);
    size_t words = 0;
    if (!b)
        return gl_fail(gl, "out of memory");
    b->tile = gl->hardware ? BISECTION_TILE_MANY : BISECTION_TILE_FEW;
    if (!make_stages(making, made, b))
        return false;
    uint32_t *bases = displaced_bisection_bases(making->patches, &words);
    if (!bases)
        return gl_fail(gl, "out of memory");
    gl->GenBuffers(BISECTION_BUFFERS, b->buffers);
    gl->GenBuffers(1, &b->head_copy);
    new_buffer(gl, b->buffers[BISECTION_BASES], words * sizeof *bases, bases);
    free(bases);
    b->most = most_of(gl, making->patches);
    set_constants(made);
    return making->patches->count <= b->most ||
           gl_fail(gl, "a mesh of %d triangles is too large to be bisected here",
                   making->patches->count);
}

void bisection_forget(Displaced *d)
{
    Bisection *b = d->own;
    if (!b)
        return;
    for (int i = 0; i < BISECTION_STAGES; i++)
        if (b->stages[i].store)
            material_delete(&b->stages[i]);
    displaced_context(d)->DeleteBuffers(BISECTION_BUFFERS, b->buffers);
    displaced_context(d)->DeleteBuffers(1, &b->head_copy);
    free(b);
    d->own = NULL;
}
