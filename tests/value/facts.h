/* Inputs and outputs of a program, as rows: by its reflection, by its SPIR-V, by the driver. */
#ifndef MATC_VALUE_FACTS_H
#define MATC_VALUE_FACTS_H
#include "runtime/gl/context.h"
#include <stddef.h>
#include <stdint.h>

typedef enum {
    FACT_input, /* a varying that the fragment program reads; place: its location */
    /* a color output; place: its location; type: "float" or "uint" for any number of components */
    FACT_output,
    FACT_attribute, /* vertex attribute; place: its location */
    FACT_texture,   /* place: its binding */
    FACT_block,     /* uniform block; place: its binding; size: in bytes */
    FACT_member,    /* member of a block, as "Block.member"; place: its offset in bytes */
    FACT_uniform,   /* uniform outside of blocks */
    FACT_system,    /* a built-in variable, or "discard" */
    FACT_KINDS
} FactKind;
extern const char *const fact_kinds[FACT_KINDS];

enum { FACT_TEXT = 128, FACT_CAPACITY = 512, NO_PLACE = -1 };

typedef struct {
    FactKind kind;
    char name[FACT_TEXT], type[FACT_TEXT]; /* an empty type is unknown */
    int place, size;                       /* NO_PLACE: none, or unknown */
} Fact;

typedef struct {
    Fact at[FACT_CAPACITY];
    int count;
} Facts;

/* Returns NULL if no fact has that kind and name. */
const Fact *facts_find(const Facts *facts, FactKind kind, const char *name);

/* Reads the JSON of --emit=reflect: facts of the fragment program and of the vertex program.
 * Returns false for other JSON. */
bool facts_of_reflection(const char *json, Facts *fragment, Facts *vertex);
/* Reads a module with one entry point: its variables and decorations. Returns false if the words
 * are no module. */
bool facts_of_spirv(const uint32_t *words, size_t bytes, Facts *facts);
/* Facts of a linked program, fragment and vertex together, as far as the driver keeps them.
 * `load` finds a GL function by name; outputs are queried by the names fragment0 and so on. */
typedef void (*FactsProc)(void);
void facts_of_program(GlContext *gl, GLuint program,
                      FactsProc (*load)(void *state, const char *name), Facts *facts);
#endif
