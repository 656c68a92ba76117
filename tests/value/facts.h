/* Inputs and outputs of a program, as rows: by its reflection, by its SPIR-V, by the driver. */
#ifndef MATC_VALUE_FACTS_H
#define MATC_VALUE_FACTS_H
#include "runtime/gl/context.h"
#include <stddef.h>
#include <stdint.h>

typedef enum {
    FACT_input,  /* a varying that the fragment program reads; place: its location */
    FACT_output, /* a colour; place: its location; type: "float" or "uint", whatever its components
                  */
    FACT_attribute, /* of the vertex program; place: its location */
    FACT_texture,   /* place: its binding */
    FACT_block,     /* of uniforms; place: its binding; size: in bytes */
    FACT_member,    /* of a block, as "Block.member"; place: its offset in bytes */
    FACT_uniform,   /* in no block */
    FACT_system,    /* a built-in variable, or "discard" */
    FACT_KINDS
} FactKind;
extern const char *const fact_kinds[FACT_KINDS];

enum { FACT_TEXT = 128, FACT_CAPACITY = 512, NO_PLACE = -1 };

typedef struct {
    FactKind kind;
    char name[FACT_TEXT], type[FACT_TEXT]; /* no type: none is told */
    int place, size;                       /* NO_PLACE: it has none, or none is told */
} Fact;

typedef struct {
    Fact at[FACT_CAPACITY];
    int count;
} Facts;

/* NULL: there is none of that kind and name. */
const Fact *facts_find(const Facts *facts, FactKind kind, const char *name);

/* Reads the JSON of --emit=reflect: facts of the fragment program and of the vertex program. False:
 * it is no reflection. */
bool facts_of_reflection(const char *json, Facts *fragment, Facts *vertex);
/* Reads a module with one entry point: its variables and decorations. False: it is no module. */
bool facts_of_spirv(const uint32_t *words, size_t bytes, Facts *facts);
/* Facts of a linked program, fragment and vertex together, as far as the driver keeps them. `load`
 * finds a function of GL by its name; outputs are queried by the names fragment0 and so on. */
typedef void (*FactsProc)(void);
void facts_of_program(GlContext *gl, GLuint program,
                      FactsProc (*load)(void *state, const char *name), Facts *facts);
#endif
