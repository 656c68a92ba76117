/* Reads rows from SPIR-V, by its specification: one sweep over the instructions notes the
 * decorations of each id; then the variables are inspected. An instruction's first word has its
 * length in words in the upper half, its opcode in the lower. */
#include "grammar/layout_tables.h"
#include "facts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAGIC = 0x07230203, BOUND = 3, HEADER = 5, MEMBERS = 128, VECTOR_BYTES = 16 };
enum {
    OP_NAME = 5,
    OP_MEMBER_NAME = 6,
    OP_TYPE_BOOL = 20,
    OP_TYPE_INT = 21,
    OP_TYPE_FLOAT = 22,
    OP_TYPE_VECTOR = 23,
    OP_TYPE_MATRIX = 24,
    OP_TYPE_SAMPLED_IMAGE = 27,
    OP_TYPE_STRUCT = 30,
    OP_TYPE_POINTER = 32,
    OP_VARIABLE = 59,
    OP_DECORATE = 71,
    OP_MEMBER_DECORATE = 72,
    OP_KILL = 252
};
enum { BUILT_IN = 11, LOCATION = 30, BINDING = 33, DESCRIPTOR_SET = 34, OFFSET = 35 };
enum { CLASS_CONSTANT, CLASS_INPUT, CLASS_UNIFORM, CLASS_OUTPUT };

typedef struct {
    const char *name, *members[MEMBERS];
    int offsets[MEMBERS];
    int number[OFFSET + 1];     /* values by decoration; NO_PLACE: none */
    const uint32_t *definition; /* the instruction that defines the type or variable */
} Id;

typedef struct {
    const uint32_t *words;
    Id *ids;
    Facts *facts;
} Module;

static int opcode(const uint32_t *at) { return (int)(at[0] & 0xffff); }
static int length(const uint32_t *at) { return (int)(at[0] >> 16); }

static void note(Module *m, const uint32_t *at)
{
    if (at[1] >= m->words[BOUND]) /* not an id */
        return;
    Id *id = &m->ids[at[1]];
    switch (opcode(at)) {
    case OP_NAME:
        id->name = (const char *)(at + 2);
        break;
    case OP_MEMBER_NAME:
        id->members[at[2]] = (const char *)(at + 3);
        break;
    case OP_DECORATE:
        if (at[2] <= OFFSET)
            id->number[at[2]] = length(at) > 3 ? (int)at[3] : 0;
        break;
    case OP_MEMBER_DECORATE:
        if (at[3] == OFFSET)
            id->offsets[at[2]] = (int)at[4];
        break;
    case OP_VARIABLE:
        m->ids[at[2]].definition = at;
        break;
    default:
        if (opcode(at) >= OP_TYPE_BOOL && opcode(at) <= OP_TYPE_POINTER)
            id->definition = at;
    }
}

static int columns_of(const Module *m, uint32_t type)
{
    const uint32_t *at = m->ids[type].definition;
    return opcode(at) == OP_TYPE_VECTOR || opcode(at) == OP_TYPE_MATRIX ? (int)at[3] : 1;
}

/* Writes a type's GLSL name. */
static void spell(const Module *m, uint32_t type, char text[FACT_TEXT])
{
    const uint32_t *at = m->ids[type].definition,
                   *component = opcode(at) == OP_TYPE_VECTOR ? m->ids[at[2]].definition : NULL;
    switch (opcode(at)) {
    case OP_TYPE_BOOL:
        snprintf(text, FACT_TEXT, "bool");
        break;
    case OP_TYPE_INT:
        snprintf(text, FACT_TEXT, at[3] ? "int" : "uint");
        break;
    case OP_TYPE_FLOAT:
        snprintf(text, FACT_TEXT, "float");
        break;
    case OP_TYPE_VECTOR:
        snprintf(text, FACT_TEXT, "%svec%u",
                 opcode(component) == OP_TYPE_FLOAT ? ""
                 : component[3]                     ? "i"
                                                    : "u",
                 at[3]);
        break;
    case OP_TYPE_MATRIX:
        snprintf(text, FACT_TEXT, "mat%u", at[3]);
        break;
    default:
        snprintf(text, FACT_TEXT, opcode(at) == OP_TYPE_SAMPLED_IMAGE ? "sampler2D" : "?");
    }
}

static Fact *add(Module *m, FactKind kind, const char *name, int place)
{
    if (m->facts->count == FACT_CAPACITY)
        abort();
    Fact *fact = &m->facts->at[m->facts->count++];
    *fact = (Fact){.kind = kind, .place = place};
    snprintf(fact->name, sizeof fact->name, "%s", name ? name : "");
    return fact;
}

/* End of a type by std140: a matrix is columns of 16 bytes each, and a block's size is a
 * multiple of 16 bytes. */
static int end_of(const Module *m, uint32_t type, int offset)
{
    bool matrix = opcode(m->ids[type].definition) == OP_TYPE_MATRIX;
    int end = offset + columns_of(m, type) * (matrix ? VECTOR_BYTES : 4);
    return (end + VECTOR_BYTES - 1) / VECTOR_BYTES * VECTOR_BYTES;
}

static void add_block(Module *m, const Id *variable, uint32_t type)
{
    const Id *block = &m->ids[type];
    int count = length(block->definition) - 2, size = 0;
    for (int i = 0; i < count; i++) {
        char name[FACT_TEXT];
        uint32_t member = block->definition[2 + i];
        snprintf(name, sizeof name, "%.40s.%.80s", block->name, block->members[i]);
        spell(m, member, add(m, FACT_member, name, block->offsets[i])->type);
        int end = end_of(m, member, block->offsets[i]);
        size = end > size ? end : size;
    }
    add(m, FACT_block, block->name, variable->number[BINDING])->size = size;
}

static const char *built_in_name(int number)
{
    return number == 17   ? "gl_FrontFacing"
           : number == 22 ? "gl_FragDepth"
           : number == 15 ? "gl_FragCoord"
                          : "?";
}

/* Returns false for a resource in a descriptor set other than 0. */
static bool add_variable(Module *m, const Id *variable)
{
    uint32_t type = m->ids[variable->definition[1]].definition[3];
    int storage = (int)variable->definition[3];
    if (storage == CLASS_INPUT || storage == CLASS_OUTPUT) {
        bool built_in = variable->number[BUILT_IN] != NO_PLACE;
        FactKind kind = built_in ? FACT_system : storage == CLASS_INPUT ? FACT_input : FACT_output;
        Fact *fact =
            add(m, kind, built_in ? built_in_name(variable->number[BUILT_IN]) : variable->name,
                variable->number[LOCATION]);
        if (!built_in)
            spell(m, type, fact->type);
        if (kind == FACT_output)
            snprintf(fact->type, FACT_TEXT, "%s", fact->type[0] == 'u' ? "uint" : "float");
        return true;
    }
    if (storage == CLASS_CONSTANT)
        spell(m, type, add(m, FACT_texture, variable->name, variable->number[BINDING])->type);
    if (storage == CLASS_UNIFORM)
        add_block(m, variable, type);
    return (storage != CLASS_CONSTANT && storage != CLASS_UNIFORM) ||
           variable->number[DESCRIPTOR_SET] == 0;
}

bool facts_of_spirv(const uint32_t *words, size_t bytes, Facts *facts)
{
    const uint32_t *end = words + bytes / sizeof *words;
    facts->count = 0;
    if (bytes < HEADER * sizeof *words || words[0] != MAGIC)
        return false;
    Module m = {words, calloc(words[BOUND], sizeof(Id)), facts};
    bool fine = m.ids != NULL;
    for (uint32_t i = 0; fine && i < words[BOUND]; i++)
        for (int k = 0; k <= OFFSET; k++)
            m.ids[i].number[k] = NO_PLACE;
    bool discards = false;
    for (const uint32_t *at = words + HEADER; fine && at < end; at += length(at)) {
        fine = length(at) > 0;
        discards |= opcode(at) == OP_KILL;
        if (length(at) > 1)
            note(&m, at);
    }
    for (uint32_t i = 0; fine && i < words[BOUND]; i++)
        if (m.ids[i].definition && opcode(m.ids[i].definition) == OP_VARIABLE)
            fine = add_variable(&m, &m.ids[i]);
    if (discards)
        add(&m, FACT_system, "discard", NO_PLACE);
    free(m.ids);
    return fine;
}
