/* Programs shared by materials: with the manifest's numbers for a material, the shared program
 * draws the same G-buffer as the material's own program, which has the numbers in its text. */
/* ctest: unsanitized seconds=38 */
#include "tests/test.h"
#include "compiler/tool/batch.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include "compiler/library/normal.h"
#include "tests/stress/generate.h"
#include "tests/stress/packed.h"
#include "tests/value/batch_set.h"
#include "tests/value/documents.h"
#include "tests/draw/draw.h"
#include "tests/draw/gbuffer.h"
#include "tests/value/read_whole.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef MATC_PROGRAM
#define MATC_PROGRAM "matc"
#endif

enum { MAX_MEMBERS = 256, BLOCK_CAPACITY = 16 * MAX_MEMBERS, RANDOM_TREES = 14, VARIANTS = 2 };

typedef struct {
    Drawer core, compat;
    Point points[POINT_COUNT];
    BatchSet examples, trees;
    /* by the shared program and by the material's own */
    GLuint words[2][FRAMEBUFFER_COLORS][POINT_COUNT * 4];
    float slots[2][SLOT_COUNT][POINT_COUNT * 4];
} Fixture;

static void add_file(BatchSet *set, const char *path)
{
    size_t size;
    char *text = read_whole(path, &size);
    assert_non_null(text);
    batch_set_add(set, text, VARIANTS);
    free(text);
}

static void add_examples(BatchSet *set)
{
    DocumentList list = documents_list(SOURCE_FOLDER);
    for (int i = 0; i < list.count; i++) {
        const char *rest = strstr(list.paths[i], "examples/") + strlen("examples/");
        if (!strchr(rest, '/') && !strstr(rest, "3D") &&
            !strstr(rest, "wrinkles")) /* 27 calls each, which drivers inline */
            add_file(set, list.paths[i]);
    }
    documents_free(&list);
}

static void add_trees(BatchSet *set)
{
    Choices *choices = calloc(1, sizeof *choices);
    assert_non_null(choices);
    for (uint64_t i = 0, added = 0; added < RANDOM_TREES; i++) {
        Arena arena = {0};
        Text text = text_new(&arena);
        choices_random(choices, 11, i);
        generate_document(choices, &text);
        if (!strstr(text.at, "3D") && text.size < 3000)
            added += batch_set_add(set, text.at, VARIANTS) > 1;
        arena_free(&arena);
    }
    free(choices);
}

static int set_up(void **state)
{
    Fixture *f = *state = calloc(1, sizeof *f);
    if (!f)
        return 1;
    points_make(f->points);
    if (!batch_set_open(&f->examples) || !batch_set_open(&f->trees))
        return 1;
    add_examples(&f->examples);
    add_trees(&f->trees);
    return !drawer_open(&f->core, true, f->points, POINT_COUNT) ||
           !drawer_open(&f->compat, false, f->points, POINT_COUNT);
}

static int tear_down(void **state)
{
    Fixture *f = *state;
    batch_set_close(&f->examples);
    batch_set_close(&f->trees);
    drawer_close(&f->core);
    drawer_close(&f->compat);
    free(f);
    return 0;
}

typedef struct {
    Fixture *f;
    BatchSet *set;
    Drawer *drawer;
    Target target;
    MatcOptions options; /* of the materials' own programs */
    MatcLayout *custom;
    Gbuffer g; /* of the material's own program */
    long materials, shared;
    /* words that were compared, whose codes are neighbors, whose codes are not */
    long words, steps, other;
    long numbers, far; /* slots that come back, that differ */
} Run;

static int number_of(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    assert_true(cJSON_IsNumber(item));
    return item->valueint;
}

static const char *text_of(const cJSON *object, const char *key)
{
    const char *text = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(object, key));
    assert_non_null(text);
    return text;
}

/* The members' offsets as the driver has them. */
static void check_offset(const Material *shared, const char *name, int offset)
{
    const GlUniforms *uniforms = &shared->program->uniforms;
    const int index = uniforms_find(uniforms, name);
    if (index < 0 || uniforms->at[index].block < 0)
        fail_msg("%s is no member", name);
    assert_int_equal(uniforms->at[index].offset, offset);
}

/* The block of the program, from the numbers that the manifest has for a material. */
static void set_constants(const Run *r, Material *shared, const cJSON *block, const cJSON *numbers)
{
    static unsigned char bytes[BLOCK_CAPACITY];
    const cJSON *members = cJSON_GetObjectItemCaseSensitive(block, "members"), *member,
                *list = numbers->child;
    int size = number_of(block, "size");
    assert_true(size > 0 && size <= BLOCK_CAPACITY && size % 16 == 0);
    assert_int_equal(cJSON_GetArraySize(members), cJSON_GetArraySize(numbers));
    memset(bytes, 0, sizeof bytes);
    cJSON_ArrayForEach(member, members)
    {
        const cJSON *number;
        int offset = number_of(member, "offset"), components = 0;
        bool word = text_of(member, "type")[0] == 'u';
        cJSON_ArrayForEach(number, list)
        {
            float value = (float)number->valuedouble;
            uint32_t whole = word ? (uint32_t)number->valuedouble : 0;
            assert_true(offset + 4 * components + 4 <= size);
            memcpy(bytes + offset + 4 * components++, word ? (void *)&whole : (void *)&value, 4);
        }
        if (!target_table[r->target].blocks)
            material_set(shared, &(MaterialValue){text_of(member, "name"), components,
                                                  (float *)(void *)(bytes + offset)});
        else
            check_offset(shared, text_of(member, "name"), offset);
        list = list->next;
    }
    material_write(shared, text_of(block, "block"), bytes, (size_t)size);
}

/* The drawn G-buffer, as words and unpacked. */
static void read_gbuffer(Run *r, int into)
{
    Fixture *f = r->f;
    Gbuffer *g = &r->g;
    gl_use(r->drawer->gl);
    for (int target = 0; target < g->targets.spec.color_count; target++)
        if (framebuffer_has_words(&g->targets, target) &&
            !framebuffer_read_words(r->drawer->gl, &g->targets, target, f->words[into][target]))
            fail_msg("%s", r->drawer->gl->error);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_has_slot(g->layout, (Slot)slot) &&
            !gbuffer_read(g, (Slot)slot, f->slots[into][slot]))
            fail_msg("%s", g->error);
}

/* The program into the targets of the material's own; its numbers come from the manifest if it has
 * a block. */
static void draw_shared(Run *r, const char *fragment, const cJSON *block, const cJSON *numbers)
{
    Material shared;
    Shading shading = r->g.shading; /* textures and params are the material's */
    shading.fragment = fragment;
    if (!drawer_material(r->drawer, &shading, &shared))
        fail_msg("%s", r->drawer->error);
    if (block)
        set_constants(r, &shared, block, numbers);
    if (!drawer_draw_to(r->drawer, &shared, true, &r->g.targets))
        fail_msg("%s", r->drawer->error);
    material_delete(&shared);
}

static int case_of(const Run *r, GLuint word)
{
    return (int)(word & ((1u << layout_case_bits(r->g.layout)) - 1));
}

/* The driver may combine literal factors, which moves a coordinate by an ULP or two: for a
 * coordinate up to 100 less than one code of any pattern of these sets; for one of 1e5 a
 * hundredth of a cell. */
static bool is_near(const Point *point)
{
    const double far = 100;
    double greatest = 0;
    for (int component = 0; component < 3; component++)
        greatest = fmax(greatest, fmax(fabs(point->input[INPUT_U][component]),
                                       fabs(point->input[INPUT_X][component])));
    return greatest <= far;
}

/* Words of the same case of the layout: a driver folds the numbers that it sees, so a value may
 * round to the next code. */
static void compare_words(Run *r)
{
    GLuint(*a)[POINT_COUNT * 4] = r->f->words[0], (*b)[POINT_COUNT * 4] = r->f->words[1];
    const int last = r->g.targets.spec.color_count - 1;
    for (int target = 0; target < r->g.targets.spec.color_count; target++)
        for (int i = 0; i < POINT_COUNT * 4 && framebuffer_has_words(&r->g.targets, target); i++) {
            if (!is_near(&r->f->points[i / 4]))
                continue;
            if (case_of(r, a[0][i / 4 * 4]) != case_of(r, b[0][i / 4 * 4]))
                /* of numbers from a buffer it is not known that a slot is as absent ones are */
                continue;
            bool near = packed_agree(
                r->g.layout, target, i % 4,
                &(PackedPair){{a[target][i], b[target][i]}, {a[last][i | 3], b[last][i | 3]}});
            r->words++;
            r->steps += near && a[target][i] != b[target][i];
            r->other += !near;
        }
}

/* Distance of two adjacent codes of a piece: each is within the field's error of one value, which
 * may be rounded differently by some ULP. */
static double piece_bound(const Piece *piece, const float *value)
{
    ErrorUnit unit = encoding_table[piece->field->encoding].unit;
    double greatest = fmax(fabs(value[0]), fmax(fabs(value[1]), fabs(value[2])));
    return 2 * field_error(piece->field) * (unit == UNIT_relative ? fmax(greatest, 1. / 32) : 1);
}

static double slot_bound(const Run *r, Slot slot, const float *value)
{
    double bound = 0;
    Placement placement;
    for (int number = 0; number < r->g.layout->case_count; number++) {
        assert_null(layout_allocate(r->g.layout, number, &placement));
        for (int i = 0; i < placement.count; i++)
            if (placement.pieces[i].field->source[placement.pieces[i].first].slot == slot)
                bound = fmax(bound, piece_bound(&placement.pieces[i], value));
    }
    return bound;
}

static bool comes_back(const Run *r, Slot slot, const float *a, const float *b)
{
    double bound = slot_bound(r, slot, b);
    if (slot == SLOT_normal) {
        double m[3] = {a[0], a[1], a[2]}, n[3] = {b[0], b[1], b[2]};
        return normal_angle(m, n) <= bound + 1e-3;
    }
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++)
        if (!(fabs((double)a[component] - (double)b[component]) <=
              bound + 1e-5 * fmax(1, fabs(b[component]))))
            return false;
    return true;
}

static void compare_slots(Run *r, const char *path)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int i = 0; i < POINT_COUNT && layout_has_slot(r->g.layout, (Slot)slot); i++) {
            const float *a = &r->f->slots[0][slot][4 * i], *b = &r->f->slots[1][slot][4 * i];
            if (!is_near(&r->f->points[i]))
                continue;
            r->numbers++;
            if (comes_back(r, (Slot)slot, a, b))
                continue;
            r->far++;
            if (getenv("VERBOSE"))
                print_message("u %.9g %.9g x %.9g %.9g %.9g: ", r->f->points[i].input[INPUT_U][0],
                              r->f->points[i].input[INPUT_U][1], r->f->points[i].input[INPUT_X][0],
                              r->f->points[i].input[INPUT_X][1], r->f->points[i].input[INPUT_X][2]),
                    print_message("%s, point %d, %s: (%g %g %g), not (%g %g %g)\n", path, i,
                                  slot_table[slot].name, a[0], a[1], a[2], b[0], b[1], b[2]);
        }
}

/* The material by itself, its numbers in the text, and the program that it shares. */
static void draw_material(Run *r, const cJSON *material, const cJSON *use)
{
    char path[SET_PATH];
    Document d;
    size_t size;
    const cJSON *program = cJSON_GetArrayItem(
        cJSON_GetObjectItemCaseSensitive(r->set->manifest, "programs"), number_of(use, "program"));
    const cJSON *block = cJSON_GetObjectItemCaseSensitive(program, "constants");
    if (!block && number_of(program, "materials") == 1)
        return; /* it is its own already */
    snprintf(path, sizeof path, "%s/%s", r->set->folder, text_of(material, "source"));
    if (!document_open(&d, path))
        fail_msg("%s", document_fault(&d));
    char *shared = batch_set_file(r->set, text_of(program, "fragment"), &size);
    assert_non_null(shared);
    if (!gbuffer_open(&r->g, r->drawer, &d, 0, &r->options) || !gbuffer_draw(&r->g, true))
        fail_msg("%s", r->g.error);
    assert_int_equal(matc_constant_count(r->g.program), 0);
    read_gbuffer(r, 1);
    draw_shared(r, shared, block, cJSON_GetObjectItemCaseSensitive(use, "constants"));
    read_gbuffer(r, 0);
    compare_words(r);
    compare_slots(r, path);
    r->shared++;
    free(shared);
    gbuffer_close(&r->g);
    document_close(&d);
}

static void open_layout(Run *r)
{
    size_t size;
    char *text = batch_set_layout(r->set, &size);
    assert_non_null(text);
    r->custom = matc_layout_read("set.layout.yaml", text, size, &r->options);
    free(text);
    if (!matc_layout_ok(r->custom))
        fail_msg("%s", matc_layout_diagnostics(r->custom, MATC_TEXT));
    r->options.custom = r->custom;
}

/* All materials of the set, compiled for a target and a layout. */
static void run_set(Fixture *f, BatchSet *set, Target target, const char *layout,
                    const char *constants)
{
    char options[SET_PATH];
    const cJSON *material;
    bool old = !target_table[target].in_out;
    Run r = {.f = f, .set = set, .drawer = old ? &f->compat : &f->core, .target = target};
    snprintf(options, sizeof options,
             "--target=%s --layout=%s --constants=%s --emit=glsl,layout --no-validate",
             target_table[target].name, layout, constants);
    if (!batch_set_run(set, MATC_PROGRAM, options))
        fail_msg("matc -d %s fails", options);
    matc_options_init(&r.options);
    r.options.target = target_table[target].name;
    r.options.validate = false;
    r.options.pixels = true;
    open_layout(&r);
    cJSON_ArrayForEach(material, cJSON_GetObjectItemCaseSensitive(set->manifest, "materials"))
    {
        draw_material(&r, material, cJSON_GetObjectItemCaseSensitive(material, "programs")->child);
        r.materials++;
    }
    print_message("%s, %s, %s: %ld materials, %ld shared; of %ld words %ld are a step apart, %ld "
                  "more; of %ld slots "
                  "%ld are other\n",
                  target_table[target].name, layout, constants, r.materials, r.shared, r.words,
                  r.steps, r.other, r.numbers, r.far);
    matc_layout_free(r.custom);
    assert_int_equal(r.materials, set->count);
    assert_true(r.shared > set->count / 2);
    assert_true(r.steps <= r.words / 1000); /* Mesa's llvmpipe leaves none */
    assert_int_equal(r.other, 0);
    assert_int_equal(r.far, 0);
}

static void examples_draw_the_same(void **state)
{
    Fixture *f = *state;
    run_set(f, &f->examples, TARGET_glsl330, "compact", "auto");
    run_set(f, &f->examples, TARGET_glsl110, "thesis", "auto");
}

static void random_trees_draw_the_same(void **state)
{
    Fixture *f = *state;
    run_set(f, &f->trees, TARGET_glsl330, "compact", "uniform");
    run_set(f, &f->trees, TARGET_glsl330, "thesis", "auto");
    run_set(f, &f->trees, TARGET_glsl330, "auto", "auto");
    run_set(f, &f->trees, TARGET_glsl110, "thin", "uniform");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_draw_the_same),
        cmocka_unit_test(random_trees_draw_the_same),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
