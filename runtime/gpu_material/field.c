/* Uploads vertices, and writes the vertex program that passes their inputs on. */
#include "runtime/gpu_material/field.h"
#include "runtime/gl/mesh.h"
#include "compiler/base/text.h"
#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum { TEXT_CAPACITY = 12288 };

static const char *const attributes[FIELD_VARYINGS + 1] = {
    "at", "in_P", "in_N", "in_DU", "in_DV", "in_U", "in_X", "in_eyeN", "in_ray", "in_XU", "in_XV",
};

bool field_make(GlContext *gl, const FieldVertex *vertices, int count, GLenum mode, Field *made)
{
    *made = (Field){.mode = mode, .count = count};
    gl->GenVertexArrays(1, &made->array);
    gl->GenBuffers(1, &made->buffer);
    gl->BindVertexArray(made->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, made->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)count * sizeof *vertices), vertices,
                   GL_STATIC_DRAW);
    for (int i = 0; i <= FIELD_VARYINGS; i++) {
        size_t offset =
            i ? offsetof(FieldVertex, input) + (size_t)(i - 1) * sizeof vertices->input[0] : 0;
        gl->VertexAttribPointer((GLuint)i, i ? 3 : 4, GL_FLOAT, GL_FALSE, sizeof *vertices,
                                (void *)offset);
        gl->EnableVertexAttribArray((GLuint)i);
    }
    gl->BindVertexArray(0);
    return gl_check(gl, "making vertices");
}

void field_draw(const GlContext *gl, const Field *field)
{
    gl->BindVertexArray(field->array);
    gl->DrawArrays(field->mode, 0, field->count);
}

void field_delete(const GlContext *gl, Field *field)
{
    gl->DeleteVertexArrays(1, &field->array);
    gl->DeleteBuffers(1, &field->buffer);
    *field = (Field){0};
}

/* Reports whether the fragment program declares the input, as "... worldNormal;". */
static bool declares(const char *fragment, const InputRow *row)
{
    char text[64];
    snprintf(text, sizeof text, "%s %s;", type_table[row->type].name, row->glsl);
    return strstr(fragment, text) != NULL;
}

/* Returns the location of an input in GLSL with locations: the input's index among the varyings. */
static int location(int input)
{
    int count = 0;
    for (int i = 0; i < input; i++)
        count += input_table[i].source == SOURCE_varying;
    return count;
}

/* GLSL types, indexed by number of components */
static const char *const types[] = {"", "float", "vec2", "vec3", "vec4"};

void field_default(const MatcAttribute *attribute, char text[FIELD_DEFAULT_CAPACITY])
{
    Arena scratch = {0};
    Text components = text_new(&scratch);
    for (int component = 0; component < attribute->components; component++) {
        text_put(&components, component ? ", " : "");
        text_double(&components, attribute->initial[component]);
    }
    snprintf(text, FIELD_DEFAULT_CAPACITY, "%s(%s)", types[attribute->components], components.at);
    arena_free(&scratch);
}

/* Appends like snprintf. */
#define PUT(...)                                                                                   \
    (size += snprintf(text + size, size < TEXT_CAPACITY ? (size_t)(TEXT_CAPACITY - size) : 0,      \
                      __VA_ARGS__))

/* Writes the vertex program. Named attributes get their defaults, since no mesh is drawn. */
static void write_vertex(Target target, const MatcProgram *program, const char *fragment,
                         char text[TEXT_CAPACITY])
{
    const bool old = !target_table[target].in_out, located = target_table[target].locations;
    const char *in = old ? "attribute" : "in", *out = old ? "varying" : "out";
    int size = 0;
    PUT("#version %s\n%s vec4 at;\nuniform vec2 field_jitter;\n", target_table[target].version, in);
    for (int i = 0; i < FIELD_VARYINGS; i++) {
        const InputRow *row = &input_table[i];
        if (!declares(fragment, row))
            continue;
        PUT("%s %s %s;\n", in, type_table[row->type].name, attributes[1 + i]);
        if (located)
            PUT("layout(location = %d) ", location(i));
        PUT("%s %s %s;\n", out, type_table[row->type].name, row->glsl);
    }
    const int named = program ? matc_attribute_count(program) : 0;
    for (int i = 0; i < named; i++) {
        const MatcAttribute *attribute = matc_attribute(program, i);
        if (located)
            PUT("layout(location = %d) ",
                location(INPUT_COUNT) + 2 + attribute->location - MESH_ATTRIBUTE_end);
        PUT("%s %s %s;\n", out, types[attribute->components], attribute->varying);
    }
    PUT("void main() {\n");
    for (int i = 0; i < named; i++) {
        const MatcAttribute *attribute = matc_attribute(program, i);
        char value[FIELD_DEFAULT_CAPACITY];
        field_default(attribute, value);
        PUT("    %s = %s;\n", attribute->varying, value);
    }
    for (int i = 0; i < FIELD_VARYINGS; i++)
        if (declares(fragment, &input_table[i]))
            PUT("    %s = %s;\n", input_table[i].glsl, attributes[1 + i]);
    PUT("    gl_Position = at + vec4(field_jitter * at.w, 0.0, 0.0);\n}\n");
}
#undef PUT

bool field_material(Store *store, MatcProgram *program, const FieldText *text, Material *made)
{
    char vertex[TEXT_CAPACITY];
    const char *fragment =
        text->fragment ? text->fragment : matc_output(program, MATC_FRAGMENT, NULL);
    write_vertex(text->target, program, fragment, vertex);
    return material_make(store, program,
                         &(ProgramText){.vertex = {vertex},
                                        .fragment = {fragment, text->library},
                                        .attributes = attributes,
                                        .attribute_count = FIELD_VARYINGS + 1},
                         made);
}
