/* Opcodes, decorations and storage classes by their numbers in the specification. */
#include "tests/value/spirv.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAGIC = 0x07230203,
    HEAD = 5,
    OP_ENTRY = 15,
    OP_MODE = 16,
    OP_INT = 21,
    OP_FLOAT,
    OP_VECTOR,
    OP_MATRIX,
    OP_IMAGE,
    OP_SAMPLED = 27,
    OP_ARRAY = 28,
    OP_RUNTIME,
    OP_STRUCT,
    OP_POINTER = 32,
    OP_CONSTANT = 43,
    OP_VARIABLE = 59,
    OP_DECORATE = 71,
    OP_MEMBER = 72,
    MODE_LOCAL_SIZE = 17,
    IS_LOCATION = 30,
    IS_BINDING = 33,
    IS_SET = 34,
    IS_OFFSET = 35
};

typedef struct {
    const uint32_t *words;
    size_t count;
} Words;

/* The first instruction from `at` on that has this opcode and this id as its operand number
 * `place`; else the end of the words. */
static size_t find(const Words *w, size_t at, uint32_t op, size_t place, uint32_t id)
{
    while (at < w->count &&
           ((w->words[at] & 0xFFFF) != op || (place && w->words[at + place] != id)))
        at += w->words[at] >> 16;
    return at;
}

static int decoration(const Words *w, uint32_t id, uint32_t which)
{
    for (size_t at = HEAD; (at = find(w, at, OP_DECORATE, 1, id)) < w->count;
         at += w->words[at] >> 16)
        if (w->words[at + 2] == which)
            return (int)w->words[at + 3];
    return -1;
}

static int offset_of(const Words *w, uint32_t id, uint32_t member)
{
    for (size_t at = HEAD; (at = find(w, at, OP_MEMBER, 1, id)) < w->count;
         at += w->words[at] >> 16)
        if (w->words[at + 2] == member && w->words[at + 3] == IS_OFFSET)
            return (int)w->words[at + 4];
    return -1;
}

/* The instruction that defines a type's id. */
static size_t type_at(const Words *w, uint32_t id)
{
    size_t at = HEAD;
    while (at < w->count && ((w->words[at] & 0xFFFF) < OP_INT - 2 ||
                             (w->words[at] & 0xFFFF) > OP_POINTER || w->words[at + 1] != id))
        at += w->words[at] >> 16;
    return at;
}

static void put_type(const Words *w, uint32_t id, char *text)
{
    const size_t at = type_at(w, id), length = strlen(text);
    char *end = text + length;
    const size_t capacity = SPIRV_TYPE - length;
    if (at >= w->count || capacity < 40)
        return;
    const uint32_t op = w->words[at] & 0xFFFF, size = w->words[at] >> 16;
    if (op == OP_INT || op == OP_FLOAT) {
        snprintf(end, capacity, "%c%u",
                 op == OP_FLOAT     ? 'f'
                 : w->words[at + 3] ? 'i'
                                    : 'u',
                 w->words[at + 2]);
    } else if (op == OP_VECTOR || op == OP_MATRIX) {
        put_type(w, w->words[at + 2], text);
        snprintf(text + strlen(text), SPIRV_TYPE - strlen(text), "x%u", w->words[at + 3]);
    } else if (op == OP_ARRAY || op == OP_RUNTIME) {
        snprintf(end, capacity, "[]");
        put_type(w, w->words[at + 2], text);
    } else if (op == OP_STRUCT) {
        for (uint32_t i = 2; i < size; i++) {
            snprintf(text + strlen(text), SPIRV_TYPE - strlen(text), "%s%d:", i == 2 ? "{" : " ",
                     offset_of(w, id, i - 2));
            put_type(w, w->words[at + i], text);
        }
        snprintf(text + strlen(text), SPIRV_TYPE - strlen(text), "}");
    } else {
        snprintf(end, capacity, op == OP_SAMPLED || op == OP_IMAGE ? "image" : "type %u", op);
    }
}

static void put_variable(const Words *w, size_t at, SpirvModule *module)
{
    const uint32_t id = w->words[at + 2];
    const size_t pointer = type_at(w, w->words[at + 1]);
    SpirvVariable v = {.storage = (SpirvStorage)w->words[at + 3],
                       .location = decoration(w, id, IS_LOCATION),
                       .set = decoration(w, id, IS_SET),
                       .binding = decoration(w, id, IS_BINDING)};
    if ((v.location < 0 && v.binding < 0) || pointer >= w->count ||
        module->count == SPIRV_VARIABLES)
        return;
    uint32_t type = w->words[pointer + 3];
    const size_t own = type_at(w, type);
    v.array = (w->words[own] & 0xFFFF) == OP_ARRAY && v.location >= 0;
    put_type(w, v.array ? w->words[own + 2] : type, v.type);
    module->variables[module->count++] = v;
}

bool spirv_read(const char *bytes, size_t size, SpirvModule *module)
{
    const Words w = {(const uint32_t *)(const void *)bytes, size / sizeof(uint32_t)};
    *module = (SpirvModule){.model = -1};
    if (size % sizeof(uint32_t) || w.count < HEAD || w.words[0] != MAGIC)
        return false;
    for (size_t at = HEAD; at < w.count; at += w.words[at] >> 16) {
        const uint32_t op = w.words[at] & 0xFFFF;
        if (w.words[at] >> 16 == 0 || at + (w.words[at] >> 16) > w.count)
            return false;
        if (op == OP_ENTRY)
            module->model = module->model < 0 ? (int)w.words[at + 1] : -1;
        if (op == OP_MODE && w.words[at + 2] == MODE_LOCAL_SIZE)
            module->local_size = (int)w.words[at + 3];
        if (op == OP_VARIABLE)
            put_variable(&w, at, module);
    }
    return true;
}
