/* One walk over each function's blocks, which SPIR-V stores in the order of structured control
 * flow: header, construct, merge block. */
#include "tests/value/spirv_flow.h"
#include <glslang/Include/glslang_c_interface.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAGIC = 0x07230203,
    HEAD = 5,
    OP_FUNCTION = 54,
    OP_CALL = 57,
    OP_SAMPLE_FIRST = 87, /* OpImageSampleImplicitLod */
    /* only every second one is implicit: 88, 90, 92, 94 have an explicit level */
    OP_SAMPLE_LAST = 94,
    OP_QUERY_LOD = 105,
    OP_DERIVATIVE_FIRST = 207, /* OpDPdx */
    OP_DERIVATIVE_LAST = 215,  /* OpFwidthCoarse */
    OP_LOOP_MERGE = 246,
    OP_SELECTION_MERGE,
    OP_LABEL,
    OP_KILL = 252,
    OP_RETURN,
    OP_RETURN_VALUE,
    OP_DEMOTE = 5380,
    MAX_NESTED = 256,
    MAX_FUNCTIONS = 512
};

extern const glslang_resource_t *glslang_default_resource(void);

typedef struct {
    uint32_t id;
    size_t from, to;  /* words of its body */
    int conditional;  /* derivatives in non-uniform control flow, callees included */
    int derivatives;  /* all derivatives */
    bool kills, done; /* may discard */
} Function;

typedef struct {
    const uint32_t *words;
    size_t count;
    Function functions[MAX_FUNCTIONS];
    int function_count;
} Module;

static bool is_implicit(uint32_t op)
{
    return (op >= OP_SAMPLE_FIRST && op <= OP_SAMPLE_LAST && op % 2 == OP_SAMPLE_FIRST % 2) ||
           op == OP_QUERY_LOD || (op >= OP_DERIVATIVE_FIRST && op <= OP_DERIVATIVE_LAST);
}

static bool find_functions(Module *m)
{
    for (size_t at = HEAD; at < m->count; at += m->words[at] >> 16) {
        if (!(m->words[at] >> 16) || m->function_count == MAX_FUNCTIONS)
            return false;
        if ((m->words[at] & 0xFFFF) == OP_FUNCTION)
            m->functions[m->function_count++] = (Function){.id = m->words[at + 2], .from = at};
        if (m->function_count)
            m->functions[m->function_count - 1].to = at + (m->words[at] >> 16);
    }
    return true;
}

/* State of the walk through a function's blocks. */
typedef struct {
    uint32_t merges[MAX_NESTED]; /* merge blocks of the enclosing constructs */
    int depth;
    bool ended; /* some invocations may have ended */
} Path;

static void walk(Module *m, Function *f);

static Function *called(Module *m, uint32_t id)
{
    for (int i = 0; i < m->function_count; i++)
        if (m->functions[i].id == id) {
            walk(m, &m->functions[i]); /* GLSL has no recursion */
            return &m->functions[i];
        }
    return NULL;
}

static void step(Module *m, Function *f, Path *path, const uint32_t *at)
{
    const uint32_t op = *at & 0xFFFF;
    const bool within = path->depth > 0, conditional = within || path->ended;
    const Function *callee = op == OP_CALL ? called(m, at[3]) : NULL;
    if (is_implicit(op)) {
        f->derivatives++;
        f->conditional += conditional;
    }
    if (callee) {
        f->derivatives += callee->derivatives;
        f->conditional += conditional ? callee->derivatives : callee->conditional;
        path->ended |= callee->kills;
        f->kills |= callee->kills;
    }
    if (op == OP_LABEL)
        while (path->depth && path->merges[path->depth - 1] == at[1])
            path->depth--;
    if ((op == OP_LOOP_MERGE || op == OP_SELECTION_MERGE) && path->depth < MAX_NESTED)
        path->merges[path->depth++] = at[1];
    f->kills |= op == OP_KILL || op == OP_DEMOTE;
    path->ended |=
        op == OP_DEMOTE || (within && (op == OP_KILL || op == OP_RETURN || op == OP_RETURN_VALUE));
}

static void walk(Module *m, Function *f)
{
    Path path = {.depth = 0};
    if (f->done)
        return;
    f->done = true;
    for (size_t at = f->from; at < f->to; at += m->words[at] >> 16)
        step(m, f, &path, &m->words[at]);
}

/* Counts in main, the function that no other calls, which glslang writes first. */
int spirv_conditional_derivatives(const char *words, size_t size, int *derivatives)
{
    Module *m = calloc(1, sizeof *m);
    uint32_t *copy = malloc(size + 1);
    int found = -1;
    *derivatives = 0;
    if (m && copy && size > HEAD * sizeof *copy) {
        memcpy(copy, words, size);
        m->words = copy;
        m->count = size / sizeof *copy;
        if (*copy == MAGIC && find_functions(m) && m->function_count) {
            walk(m, &m->functions[0]);
            found = m->functions[0].conditional;
            *derivatives = m->functions[0].derivatives;
        }
    }
    free(copy);
    free(m);
    return found;
}

static pthread_once_t initialized = PTHREAD_ONCE_INIT;
static void initialize(void) { glslang_initialize_process(); }

int glsl_conditional_derivatives(const char *text, int *derivatives)
{
    const glslang_input_t input = {.language = GLSLANG_SOURCE_GLSL,
                                   .stage = GLSLANG_STAGE_FRAGMENT,
                                   .client = GLSLANG_CLIENT_NONE,
                                   .target_language = GLSLANG_TARGET_NONE,
                                   .code = text,
                                   .default_version = 110,
                                   .default_profile = GLSLANG_NO_PROFILE,
                                   .messages = GLSLANG_MSG_DEFAULT_BIT,
                                   .resource = glslang_default_resource()};
    pthread_once(&initialized, initialize);
    glslang_spv_options_t options = {.disable_optimizer = true};
    glslang_shader_t *shader = glslang_shader_create(&input);
    glslang_program_t *program = glslang_program_create();
    int found = -1;
    if (glslang_shader_preprocess(shader, &input) && glslang_shader_parse(shader, &input)) {
        glslang_program_add_shader(program, shader);
        if (glslang_program_link(program, GLSLANG_MSG_DEFAULT_BIT)) {
            glslang_program_SPIRV_generate_with_options(program, GLSLANG_STAGE_FRAGMENT, &options);
            found = spirv_conditional_derivatives(
                (const char *)glslang_program_SPIRV_get_ptr(program),
                glslang_program_SPIRV_get_size(program) * sizeof(unsigned), derivatives);
        }
    }
    if (found < 0)
        fprintf(stderr, "%s\n", glslang_shader_get_info_log(shader));
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return found;
}
