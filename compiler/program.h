/* The program handle, shared by program.c (compilation) and program_outputs.c (outputs). */
#ifndef MATC_PROGRAM_H
#define MATC_PROGRAM_H
#include "compiler/document.h"
#include "compiler/emit/attribute.h"
#include "compiler/ir/key.h"
#include "compiler/pipeline.h"

enum { OUTPUT_COUNT = 17 }; /* number of bits of MatcOutput */

struct MatcProgram {
    Arena arena;
    MatcOptions options;
    Session session;
    const MatcDocument *document;
    int material;
    Job job;
    bool ok, written; /* `written`: the GLSL exists */
    unsigned asked;   /* set of the MatcOutputs requested so far */
    Ir *ir;
    Products products;
    const char *outputs[OUTPUT_COUNT]; /* texts by bit number of MatcOutput */
    size_t sizes[OUTPUT_COUNT];
    const char *words[OUTPUT_COUNT]; /* SPIR-V of those outputs that are stages */
    size_t word_sizes[OUTPUT_COUNT];
    MatcTexture *textures;
    int *texture_made_by;
    int texture_count;
    const LayoutRow *layout;                    /* layout that the pass writes; NULL: none */
    MatcAttribute attributes[LIMIT_ATTRIBUTES]; /* attributes that the program uses */
    int attribute_count;
    MatcUniform *uniforms; /* uniforms that the program uses */
    int uniform_count;
    MatcConstant *constants;
    bool keyed; /* the next four members are valid */
    IrKey key;
    MatcConstant *places;
    char key_digits[KEY_TEXT], shape_digits[KEY_TEXT];
};

const Node *program_material(const MatcProgram *program);
/* Generates the requested outputs (MatcOutput, or-ed). Returns false after reporting faults. */
bool program_write(MatcProgram *program, unsigned outputs);
#endif
