/* Grouping of units into shared programs (compiler/tool/batch_group.c), with units made by hand:
 * which materials share a program, which numbers become members of its buffer, and which
 * programs are compiled a second time. test_manifest.c tests the resulting batches. */
#include "tests/test.h"
#include "compiler/tool/batch_state.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAX_UNITS = 200,
    MAX_MEMBERS = 1024,
    VEC3 = 3,
    FLOAT = 1,
    WORD = UNIT_WORDS + 1,
    WORDS = UNIT_WORDS + 4
};

/* A unit: a row of its own numbers, all components one after the other, as bits. */
typedef struct {
    uint64_t shape, key;
    const uint32_t *bits;
    bool written;
} Row;

/* Units of one layout of numbers, in documents of one material each. */
typedef struct {
    const uint8_t *components;
    int count, documents, requests;
    Numbers numbers;
    const Row *rows; /* documents times requests */
} Case;

typedef struct {
    Batch batch;
    BatchDocument documents[MAX_UNITS];
    BatchMaterial materials[MAX_UNITS];
    Unit units[MAX_UNITS];
    char names[MAX_UNITS][8];
    Written written;
} Made;

static void fill_unit(Made *made, const Case *c, int i)
{
    const Row *row = &c->rows[i];
    int bits = 0;
    for (int k = 0; k < c->count; k++)
        bits += c->components[k] > UNIT_WORDS ? c->components[k] - UNIT_WORDS : c->components[k];
    made->units[i] = (Unit){.key = {row->key, 0},
                            .shape = {0, row->shape},
                            .pass = i % c->requests ? PASS_depth : PASS_gbuffer,
                            .count = c->count,
                            .components = (uint8_t *)c->components,
                            .bits = (uint32_t *)row->bits,
                            .bit_count = bits,
                            .written = row->written ? &made->written : NULL,
                            .document = i / c->requests,
                            .request = i % c->requests};
}

static Made *group(const Case *c)
{
    Made *made = calloc(1, sizeof *made);
    assert_non_null(made);
    made->batch = (Batch){.documents = made->documents,
                          .document_count = c->documents,
                          .request_count = c->requests,
                          .numbers = c->numbers};
    for (int i = 0; i < c->documents * c->requests; i++)
        fill_unit(made, c, i);
    for (int d = 0; d < c->documents; d++) {
        snprintf(made->names[d], sizeof made->names[d], "m%d", d);
        made->materials[d] =
            (BatchMaterial){.name = made->names[d], .units = &made->units[d * c->requests]};
        made->documents[d] = (BatchDocument){.materials = &made->materials[d], .material_count = 1};
    }
    batch_group(&made->batch);
    return made;
}

static void done(Made *made)
{
    for (int i = 0; i < made->batch.program_count; i++) {
        free(made->batch.programs[i].members);
        free(made->batch.programs[i].name);
    }
    for (int d = 0; d < made->batch.document_count; d++)
        free(made->documents[d].again);
    free(made->batch.programs);
    free(made);
}

/* The program of each unit, and that each program's list has exactly its units, in the order of the
 * inputs. */
static void assert_programs(const Made *made, const int *programs, int units)
{
    int listed = 0;
    for (int i = 0; i < units; i++)
        assert_int_equal(made->units[i].program, programs[i]);
    for (int p = 0; p < made->batch.program_count; p++) {
        const BatchProgram *program = &made->batch.programs[p];
        const Unit *before = NULL;
        int count = 0;
        for (const Unit *unit = program->first; unit; before = unit, unit = unit->next, count++) {
            assert_int_equal(unit->program, p);
            assert_true(!before || before < unit);
        }
        assert_ptr_equal(before, program->last);
        assert_int_equal(count, program->unit_count);
        listed += count;
    }
    assert_int_equal(listed, units);
}

static void assert_members(const Made *made, int program, const int *members, int count)
{
    const int *got = made->batch.programs[program].members;
    assert_true(!got == !members);
    for (int i = 0; members && i < count; i++)
        assert_int_equal(got[i], members[i]);
}

/* Checks which documents write programs a second time: "program" lists. */
static void assert_again(const Made *made, int document, const int *again, int count)
{
    assert_int_equal(made->documents[document].again_count, count);
    for (int i = 0; i < count; i++)
        assert_int_equal(made->documents[document].again[i], again[i]);
}

/* A vec3, a float, a vec3, a float and a word. The second vec3 differs as the first does; the
 * second float is the same in all materials; the word has the float's very bits. */
static const uint8_t mixed[] = {VEC3, FLOAT, VEC3, FLOAT, WORD};
static const uint32_t first_bits[] = {1, 2, 3, 10, 1, 2, 3, 7, 10},
                      second_bits[] = {1, 2, 4, 11, 1, 2, 4, 7, 11},
                      third_bits[] = {1, 2, 3, 12, 1, 2, 3, 7, 12},
                      other_bits[] = {1, 2, 3, 10, 9, 2, 3, 8, 10};

static void one_shape_shares_a_program(void **state)
{
    static const Row rows[] = {{5, 100, first_bits, true},
                               {6, 101, other_bits, true},
                               {5, 102, second_bits, false},
                               {5, 103, third_bits, false}};
    (void)state;
    Made *made = group(&(Case){mixed, 5, 4, 1, NUMBERS_auto, rows});
    assert_int_equal(made->batch.program_count, 2);
    assert_programs(made, (int[]){0, 1, 0, 0}, 4);
    assert_members(made, 0, (int[]){0, 1, 0, -1, 4}, 5);
    assert_members(made, 1, NULL, 0);
    assert_string_equal(made->batch.programs[0].name, "m0");
    assert_string_equal(made->batch.programs[1].name, "m1");
    assert_again(made, 0, (int[]){0}, 1); /* with members, though it was written without */
    assert_again(made, 1, NULL, 0);       /* stands as it was written */
    assert_again(made, 2, NULL, 0);
    done(made);
}

/* With a further material two places differ in another way, and are two members. */
static void places_that_differ_apart_are_two_members(void **state)
{
    static const Row rows[] = {
        {5, 100, first_bits, true}, {5, 101, second_bits, false}, {5, 102, other_bits, false}};
    (void)state;
    Made *made = group(&(Case){mixed, 5, 3, 1, NUMBERS_auto, rows});
    assert_programs(made, (int[]){0, 0, 0}, 3);
    assert_members(made, 0, (int[]){0, 1, 2, 3, 4}, 5);
    done(made);
}

/* One differing component of four makes a member; components of a neighbor do not, nor does a
 * number of other width with equal bits. */
static void components_are_of_their_own_number(void **state)
{
    static const uint8_t components[] = {WORDS, FLOAT, 2, FLOAT, FLOAT};
    static const uint32_t a[] = {1, 1, 1, 1, 3, 4, 4, 4, 5}, b[] = {1, 1, 1, 2, 3, 6, 6, 6, 5};
    static const Row rows[] = {{5, 100, a, true}, {5, 101, b, true}};
    (void)state;
    Made *made = group(&(Case){components, 5, 2, 1, NUMBERS_auto, rows});
    assert_members(made, 0, (int[]){0, -1, 2, 3, -1}, 5);
    done(made);
}

/* Materials with the same numbers share the program as it was written, without a buffer. */
static void equal_numbers_need_no_buffer(void **state)
{
    static const Row rows[] = {
        {5, 100, first_bits, true}, {5, 100, first_bits, false}, {5, 100, first_bits, false}};
    (void)state;
    Made *made = group(&(Case){mixed, 5, 3, 1, NUMBERS_auto, rows});
    assert_programs(made, (int[]){0, 0, 0}, 3);
    assert_members(made, 0, NULL, 0);
    assert_again(made, 0, NULL, 0);
    done(made);
}

/* With baked numbers, and with all in a buffer already, programs go by the key alone. A program
 * whose first material was not the one that wrote it is written once more, under the first one's
 * name. */
static void without_auto_only_equal_keys_share(void **state)
{
    static const Row rows[] = {
        {5, 100, first_bits, false}, {5, 101, second_bits, true}, {7, 100, first_bits, true}};
    (void)state;
    for (Numbers numbers = NUMBERS_baked; numbers <= NUMBERS_uniform; numbers++) {
        Made *made = group(&(Case){mixed, 5, 3, 1, numbers, rows});
        assert_int_equal(made->batch.program_count, 2);
        assert_programs(made, (int[]){0, 1, 0}, 3);
        assert_members(made, 0, NULL, 0);
        assert_again(made, 0, (int[]){0}, 1);
        assert_again(made, 1, NULL, 0);
        assert_again(made, 2, NULL, 0);
        done(made);
    }
}

/* Programs of two passes, document by document. The name of any pass but the G-buffer's has the
 * pass in it. */
static void passes_have_programs_of_their_own(void **state)
{
    static const Row rows[] = {{5, 100, first_bits, false},  {8, 110, first_bits, false},
                               {5, 101, second_bits, false}, {8, 110, first_bits, false},
                               {9, 120, first_bits, false},  {8, 110, first_bits, false}};
    (void)state;
    Made *made = group(&(Case){mixed, 5, 3, 2, NUMBERS_auto, rows});
    assert_int_equal(made->batch.program_count, 3);
    assert_programs(made, (int[]){0, 1, 0, 1, 2, 1}, 6);
    assert_string_equal(made->batch.programs[0].name, "m0");
    assert_string_equal(made->batch.programs[1].name, "m0.depth");
    assert_string_equal(made->batch.programs[2].name, "m2");
    assert_members(made, 0, (int[]){0, 1, 0, -1, 4}, 5);
    assert_members(made, 1, NULL, 0);
    assert_again(made, 0, (int[]){0, 1}, 2);
    assert_again(made, 2, (int[]){2}, 1);
    done(made);
}

/* `count` floats that differ in each of four units, but that the last two units are one program;
 * and a unit of another shape. */
static Made *group_wide(int count)
{
    static uint8_t components[MAX_MEMBERS + 1];
    static uint32_t bits[3][MAX_MEMBERS + 1];
    static const Row rows[] = {{5, 100, bits[0], true}, {5, 101, bits[1], true},
                               {5, 100, bits[0], true}, {6, 103, bits[0], true},
                               {5, 102, bits[2], true}, {5, 102, bits[2], true}};
    memset(components, FLOAT, sizeof components);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= MAX_MEMBERS; k++)
            bits[i][k] = (uint32_t)(k * 3 + i);
    return group(&(Case){components, count, 6, 1, NUMBERS_auto, rows});
}

static void a_buffer_has_capacity_for_1024_members(void **state)
{
    (void)state;
    Made *made = group_wide(MAX_MEMBERS);
    assert_int_equal(made->batch.program_count, 2);
    assert_programs(made, (int[]){0, 0, 0, 1, 0, 0}, 6);
    for (int i = 0; i < MAX_MEMBERS; i++)
        assert_int_equal(made->batch.programs[0].members[i], i);
    done(made);
}

/* One more, and only equal programs share; the new ones come behind those that there are. */
static void more_members_share_nothing(void **state)
{
    (void)state;
    Made *made = group_wide(MAX_MEMBERS + 1);
    assert_int_equal(made->batch.program_count, 4);
    assert_programs(made, (int[]){0, 2, 0, 1, 3, 3}, 6);
    for (int i = 0; i < 4; i++) {
        static const int first[] = {0, 3, 1, 4};
        assert_null(made->batch.programs[i].members);
        assert_ptr_equal(made->batch.programs[i].first, &made->units[first[i]]);
        assert_again(made, first[i], NULL, 0);
    }
    done(made);
}

/* The list of programs grows. */
static void many_programs_keep_their_order(void **state)
{
    Row rows[MAX_UNITS];
    int programs[MAX_UNITS];
    (void)state;
    for (int i = 0; i < MAX_UNITS; i++) {
        rows[i] = (Row){5, 1000 + (uint64_t)(i % 129), first_bits, true};
        programs[i] = i % 129;
    }
    Made *made = group(&(Case){mixed, 5, MAX_UNITS, 1, NUMBERS_baked, rows});
    assert_int_equal(made->batch.program_count, 129);
    assert_programs(made, programs, MAX_UNITS);
    done(made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_shape_shares_a_program),
        cmocka_unit_test(places_that_differ_apart_are_two_members),
        cmocka_unit_test(components_are_of_their_own_number),
        cmocka_unit_test(equal_numbers_need_no_buffer),
        cmocka_unit_test(without_auto_only_equal_keys_share),
        cmocka_unit_test(passes_have_programs_of_their_own),
        cmocka_unit_test(a_buffer_has_capacity_for_1024_members),
        cmocka_unit_test(more_members_share_nothing),
        cmocka_unit_test(many_programs_keep_their_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
