/* A program, between program.c, which compiles it, and program_outputs.c, which writes it. */
#ifndef MATC_PROGRAM_H
#define MATC_PROGRAM_H
#include "compiler/document.h"
#include "compiler/emit/attribute.h"
#include "compiler/ir/key.h"
#include "compiler/pipeline.h"

enum { OUTPUT_COUNT = 17 }; /* bits of MatcOutput */

struct MatcProgram {
    Arena arena;
    MatcOptions options;
    Session session;
    const MatcDocument *document;
    int material;
    Job job;
    bool ok, written; /* the GLSL is there */
    unsigned asked;   /* MatcOutputs that were asked for so far */
    Ir *ir;
    Products products;
    const char *outputs[OUTPUT_COUNT]; /* by bit of MatcOutput */
    size_t sizes[OUTPUT_COUNT];
    const char *words[OUTPUT_COUNT]; /* SPIR-V of those that are stages */
    size_t word_sizes[OUTPUT_COUNT];
    MatcTexture *textures;
    int *texture_made_by;
    int texture_count;
    const LayoutRow *layout;                    /* NULL: the pass writes none */
    MatcAttribute attributes[LIMIT_ATTRIBUTES]; /* those in use */
    int attribute_count;
    MatcUniform *uniforms; /* those in use */
    int uniform_count;
    MatcConstant *constants;
    bool keyed; /* the next four are there */
    IrKey key;
    MatcConstant *places;
    char key_digits[KEY_TEXT], shape_digits[KEY_TEXT];
};

const Node *program_material(const MatcProgram *program);
/* Writes what is asked for (MatcOutput, or-ed). False: see the diagnostics. */
bool program_write(MatcProgram *program, unsigned outputs);
#endif
