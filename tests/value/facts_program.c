/* Reads rows from OpenGL's queries of a linked program. */
#include "facts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* GL functions that the GL layer does not load. */
typedef struct {
    void (*active_attribute)(GLuint, GLuint, GLsizei, GLsizei *, GLint *, GLenum *, GLchar *);
    GLint (*attribute_location)(GLuint, const GLchar *);
    GLint (*output_location)(GLuint, const GLchar *);
    void (*uniform_values)(GLuint, GLsizei, const GLuint *, GLenum, GLint *);
    void (*block_value)(GLuint, GLuint, GLenum, GLint *);
    void (*block_name)(GLuint, GLuint, GLsizei, GLsizei *, GLchar *);
    void (*uniform_value)(GLuint, GLint, GLint *);
} Asking;

static const struct {
    GLenum type;
    const char *name;
} types[] = {
    {GL_FLOAT, "float"},
    {GL_FLOAT_VEC2, "vec2"},
    {GL_FLOAT_VEC3, "vec3"},
    {GL_FLOAT_VEC4, "vec4"},
    {GL_INT, "int"},
    {GL_UNSIGNED_INT, "uint"},
    {GL_FLOAT_MAT3, "mat3"},
    {GL_FLOAT_MAT4, "mat4"},
    {GL_SAMPLER_2D, "sampler2D"},
    {GL_UNSIGNED_INT_VEC4, "uvec4"},
    {GL_BOOL, "bool"},
};

static void spell(GLenum type, char text[FACT_TEXT])
{
    snprintf(text, FACT_TEXT, "?");
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (types[i].type == type)
            snprintf(text, FACT_TEXT, "%s", types[i].name);
}

static Fact *add(Facts *facts, FactKind kind, const char *name, int place)
{
    if (facts->count == FACT_CAPACITY)
        abort();
    Fact *fact = &facts->at[facts->count++];
    *fact = (Fact){.kind = kind, .place = place};
    snprintf(fact->name, sizeof fact->name, "%s", name);
    return fact;
}

static Asking ask(GlContext *gl, FactsProc (*load)(void *state, const char *name))
{
    Asking a;
    const struct {
        const char *name;
        void *function;
    } rows[] = {
        {"glGetActiveAttrib", &a.active_attribute},
        {"glGetAttribLocation", &a.attribute_location},
        {"glGetFragDataLocation", &a.output_location},
        {"glGetActiveUniformsiv", &a.uniform_values},
        {"glGetActiveUniformBlockiv", &a.block_value},
        {"glGetActiveUniformBlockName", &a.block_name},
        {"glGetUniformiv", &a.uniform_value},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        FactsProc found = load(gl->state, rows[i].name);
        memcpy(rows[i].function, &found, sizeof found);
    }
    return a;
}

static void add_attributes(GlContext *gl, const Asking *a, GLuint program, Facts *facts)
{
    GLint count = 0;
    gl->GetProgramiv(program, GL_ACTIVE_ATTRIBUTES, &count);
    for (GLint i = 0; i < count; i++) {
        char name[FACT_TEXT];
        GLint size;
        GLenum type;
        a->active_attribute(program, (GLuint)i, sizeof name, NULL, &size, &type, name);
        if (strncmp(name, "gl_", 3) != 0)
            spell(type,
                  add(facts, FACT_attribute, name, a->attribute_location(program, name))->type);
    }
}

static void add_uniform(GlContext *gl, const Asking *a, GLuint program, GLuint index, Facts *facts)
{
    char name[FACT_TEXT], block[FACT_TEXT], whole[FACT_TEXT];
    GLint size, owner = -1, place = NO_PLACE;
    GLenum type;
    gl->GetActiveUniform(program, index, sizeof name, NULL, &size, &type, name);
    if (a->uniform_values)
        a->uniform_values(program, 1, &index, GL_UNIFORM_BLOCK_INDEX, &owner);
    if (owner >= 0) {
        a->block_name(program, (GLuint)owner, sizeof block, NULL, block);
        a->uniform_values(program, 1, &index, GL_UNIFORM_OFFSET, &place);
        snprintf(whole, sizeof whole, "%.40s.%.80s", block, name);
        spell(type, add(facts, FACT_member, whole, place)->type);
        return;
    }
    if (type == GL_SAMPLER_2D)
        a->uniform_value(program, gl->GetUniformLocation(program, name), &place);
    spell(type, add(facts, type == GL_SAMPLER_2D ? FACT_texture : FACT_uniform, name, place)->type);
}

static void add_blocks(GlContext *gl, const Asking *a, GLuint program, Facts *facts)
{
    GLint count = 0;
    gl->GetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
    for (GLint i = 0; i < count; i++) {
        char name[FACT_TEXT];
        GLint binding, size;
        a->block_name(program, (GLuint)i, sizeof name, NULL, name);
        a->block_value(program, (GLuint)i, GL_UNIFORM_BLOCK_BINDING, &binding);
        a->block_value(program, (GLuint)i, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        add(facts, FACT_block, name, binding)->size = size;
    }
}

void facts_of_program(GlContext *gl, GLuint program,
                      FactsProc (*load)(void *state, const char *name), Facts *facts)
{
    enum { TARGETS = 8 };
    Asking a = ask(gl, load);
    GLint count = 0;
    facts->count = 0;
    add_attributes(gl, &a, program, facts);
    gl->GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; i++)
        add_uniform(gl, &a, program, (GLuint)i, facts);
    add_blocks(gl, &a, program, facts);
    for (int i = 0; i < TARGETS; i++) {
        char name[FACT_TEXT];
        snprintf(name, sizeof name, "fragment%d", i);
        GLint location = a.output_location(program, name);
        if (location >= 0)
            add(facts, FACT_output, name, location);
    }
}
