/* Groups units into programs, in the order of the inputs, so that the result does not depend on
 * the number of threads. */
#include "compiler/tool/batch_state.h"
#include <stdlib.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

static void add_unit(Batch *b, KeySet *keys, Key key, Unit *unit)
{
    bool added;
    unit->program = key_set_add(keys, key, &added);
    unit->next = NULL;
    if (added) {
        if (unit->program % 64 == 0)
            b->programs =
                sets_resize(b->programs, (size_t)(unit->program + 64) * sizeof *b->programs);
        b->programs[unit->program] = (BatchProgram){.first = unit, .last = unit};
        b->program_count = unit->program + 1;
    } else {
        b->programs[unit->program].last->next = unit;
        b->programs[unit->program].last = unit;
    }
    b->programs[unit->program].unit_count++;
}

/* Returns true if all units of the program have equal numbers at a place. */
static bool is_same(const BatchProgram *program, int at, int components)
{
    size_t size = (size_t)components * sizeof(uint32_t);
    for (const Unit *unit = program->first->next; unit; unit = unit->next)
        if (memcmp(unit->bits + at, program->first->bits + at, size) != 0)
            return false;
    return true;
}

static Key column_key(const BatchProgram *program, int at, int components)
{
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    XXH3_128bits_update(&state, &components, sizeof components);
    for (const Unit *unit = program->first; unit; unit = unit->next)
        XXH3_128bits_update(&state, unit->bits + at, (size_t)components * sizeof(uint32_t));
    XXH128_hash_t hash = XXH3_128bits_digest(&state);
    return (Key){hash.low64, hash.high64};
}

/* Makes a member of each place at which the materials differ; places with equal numbers in all
 * of them share a member. Returns the number of members. */
static int find_members(BatchProgram *program)
{
    const Unit *first = program->first;
    KeySet columns = {0};
    int *offsets = unit_offsets(first), *place_of = NULL, members = 0;
    program->members = sets_resize(NULL, (size_t)first->count * sizeof *program->members);
    place_of = sets_resize(NULL, (size_t)first->count * sizeof *place_of);
    for (int i = 0; i < first->count; i++) {
        bool added;
        int components = unit_components(first, i), kind = first->components[i];
        program->members[i] = -1;
        if (is_same(program, offsets[i], components))
            continue;
        Key key = column_key(program, offsets[i], components);
        key.low ^= (uint64_t)kind; /* makes the keys of a word and a float differ */
        int column = key_set_add(&columns, key, &added);
        if (added)
            place_of[column] = i;
        members += added;
        program->members[i] = place_of[column];
    }
    key_set_free(&columns);
    free(offsets);
    free(place_of);
    return members;
}

/* Splits a program of one shape by key if its materials differ in more numbers than a uniform
 * block can hold. */
static void share_shapes(Batch *b, KeySet *keys)
{
    int count = b->program_count;
    for (int i = 0; i < count; i++) {
        BatchProgram *program = &b->programs[i];
        int members = program->unit_count > 1 ? find_members(program) : 0;
        if (members && members <= MAX_CONSTANTS)
            continue;
        free(program->members);
        program->members = NULL;
        if (!members)
            continue;
        Unit *rest = program->first->next, *next;
        Unit *kept = program->first;
        program->last = kept;
        program->unit_count = 1;
        kept->next = NULL;
        for (; rest; rest = next) {
            next = rest->next;
            if (key_equal(rest->key, kept->key)) {
                rest->next = NULL;
                b->programs[i].last->next = rest;
                b->programs[i].last = rest;
                b->programs[i].unit_count++;
            } else {
                add_unit(b, keys, rest->key, rest);
            }
        }
    }
}

/* Plans to rewrite a program if it was written under another material's name, or needs members.
 * The document of its first material writes it. */
static void plan_writing(Batch *b, int index)
{
    BatchProgram *program = &b->programs[index];
    char name[LONGEST_NAME];
    batch_name(b, program->first, name);
    program->name = sets_copy(name);
    if (program->first->written && !program->members)
        return;
    BatchDocument *document = &b->documents[program->first->document];
    document->again =
        sets_resize(document->again, (size_t)(document->again_count + 1) * sizeof *document->again);
    document->again[document->again_count++] = index;
}

void batch_group(Batch *b)
{
    KeySet keys = {0};
    for (int d = 0; d < b->document_count; d++)
        for (int m = 0; m < b->documents[d].material_count; m++)
            for (int t = 0; t < b->request_count; t++) {
                Unit *unit = batch_unit(b, d, m, t);
                add_unit(b, &keys, b->numbers == NUMBERS_auto ? unit->shape : unit->key, unit);
            }
    if (b->numbers == NUMBERS_auto)
        share_shapes(b, &keys);
    for (int i = 0; i < b->program_count; i++)
        plan_writing(b, i);
    key_set_free(&keys);
}
