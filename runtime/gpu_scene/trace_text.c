/* Rewrites the texts line by line: declarations of inputs and outputs between stages become
 * variables. */
#include "runtime/gpu_scene/trace_text.h"
#include "gen/render_text.h"
#include "runtime/gpu_material/field.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const attributes[] = {"position", "normal",   "texcoord",
                                         "tangentU", "tangentV", "basePosition"};
enum { ATTRIBUTES = sizeof attributes / sizeof *attributes, NAME = 64, VARYINGS = 16 };

typedef struct {
    FILE *to;
    char varyings[VARYINGS][NAME]; /* varyings whose derivatives are used */
    int varying_count;
} Writer;

/* A stage's input or output, such as `layout(location = 4) [flat] in vec2 uv;`. */
typedef struct {
    char way[NAME], type[NAME], name[NAME];
} Declared;

/* Reads the next word of a line, and returns the rest. */
static const char *read_word(const char *at, char word[NAME])
{
    at += strspn(at, " ");
    const size_t length = strcspn(at, " ;\n"), size = length < NAME ? length : NAME - 1;
    memcpy(word, at, size);
    word[size] = 0;
    return at + size;
}

static bool read_declared(const char *line, Declared *made)
{
    static const char head[] = "layout(location = ";
    const char *at = strncmp(line, head, sizeof head - 1) ? NULL : strchr(line, ')');
    if (!at)
        return false;
    at = read_word(at + 1, made->way);
    if (!strcmp(made->way, "flat"))
        at = read_word(at, made->way);
    at = read_word(read_word(at, made->type), made->name);
    return *at == ';' && (!strcmp(made->way, "in") || !strcmp(made->way, "out"));
}

/* Writes a line with derivatives, built-ins and main() replaced. */
static void put_line(Writer *w, const char *line, size_t size, bool vertex)
{
    static const struct {
        const char *from, *to;
    } words[] = {{"gl_Position", "trace_clip"}, {"gl_FrontFacing", "trace_front"}};
    for (const char *at = line; at < line + size;) {
        const char axis = !strncmp(at, "dFdx(", 5) ? 'X' : !strncmp(at, "dFdy(", 5) ? 'Y' : 0;
        const char *end = axis ? strchr(at, ')') : NULL;
        bool put = false;
        if (end) {
            fprintf(w->to, "trace%c_%.*s", axis, (int)(end - at - 5), at + 5);
            at = end + 1;
            continue;
        }
        for (size_t i = 0; i < sizeof words / sizeof *words && !put; i++)
            if (!strncmp(at, words[i].from, strlen(words[i].from))) {
                fputs(words[i].to, w->to);
                at += strlen(words[i].from);
                put = true;
            }
        if (!put && !strncmp(at, "void main()", 11)) {
            fprintf(w->to, "void trace%sMain()", vertex ? "Vertex" : "Surface");
            at += 11;
        } else if (!put)
            fputc(*at++, w->to);
    }
}

/* Declares both derivatives of a varying, if the fragment program uses them. */
static void put_varying(Writer *w, const Declared *of, const char *fragment)
{
    char asked[2][NAME + 8];
    for (int i = 0; i < 2; i++)
        snprintf(asked[i], sizeof asked[i], "dFd%c(%s)", "xy"[i], of -> name);
    if ((!strstr(fragment, asked[0]) && !strstr(fragment, asked[1])) ||
        w->varying_count == VARYINGS)
        return;
    fprintf(w->to, "%s traceX_%s, traceY_%s;\n", of->type, of->name, of->name);
    strcpy(w->varyings[w->varying_count++], of->name);
}

static void put_program(Writer *w, const char *text, const char *fragment)
{
    const bool vertex = text != fragment;
    for (const char *line = text, *next; *line; line = next) {
        Declared declared;
        next = strchr(line, '\n');
        next = next ? next + 1 : line + strlen(line);
        if (*line == '#' && !strncmp(line, "#version", 8))
            continue;
        if (!read_declared(line, &declared) || (!vertex && !strcmp(declared.way, "out")))
            put_line(w, line, (size_t)(next - line), vertex);
        else if (vertex)
            fprintf(w->to, "%s %s;\n", declared.type, declared.name);
        else
            put_varying(w, &declared, fragment);
    }
}

static void put_functions(Writer *w)
{
    for (int axis = 0; axis < 2; axis++) {
        fprintf(w->to, "void traceKeep%c()\n{\n", "XY"[axis]);
        for (int i = 0; i < w->varying_count; i++)
            fprintf(w->to, "    trace%c_%s = %s;\n", "XY"[axis], w -> varyings[i],
                    w -> varyings[i]);
        fputs("}\n", w->to);
    }
    fputs("void traceSubtract()\n{\n", w->to);
    for (int i = 0; i < w->varying_count; i++)
        fprintf(w->to, "    traceX_%s -= %s;\n    traceY_%s -= %s;\n", w->varyings[i],
                w->varyings[i], w->varyings[i], w->varyings[i]);
    fputs("}\n", w->to);
}

/* Declares the attributes under names of their own, since functions and variables of the
 * fragment program may have the same names. */
static void put_attributes(FILE *to)
{
    for (int i = 0; i < ATTRIBUTES; i++)
        fprintf(to, "%s trace_%s;\n", strcmp(attributes[i], "texcoord") ? "vec3" : "vec2",
                attributes[i]);
}

/* Sets attributes that ray hits do not have to their defaults. */
static void put_defaults(FILE *to, const MatcProgram *program)
{
    for (int i = 0; i < matc_attribute_count(program); i++) {
        const MatcAttribute *attribute = matc_attribute(program, i);
        char value[FIELD_DEFAULT_CAPACITY];
        field_default(attribute, value);
        fprintf(to, "    %s = %s;\n", attribute->attribute, value);
    }
}

static void put_vertex(Writer *w, const MatcProgram *program, const char *vertex,
                       const char *fragment)
{
    for (int i = 0; i < ATTRIBUTES; i++)
        fprintf(w->to, "#define %s matc_%s\n", attributes[i], attributes[i]);
    put_program(w, vertex, fragment);
    fputs("void traceRun()\n{\n", w->to);
    for (int i = 0; i < ATTRIBUTES; i++)
        if (strstr(vertex, attributes[i]))
            fprintf(w->to, "    matc_%s = trace_%s;\n", attributes[i], attributes[i]);
    put_defaults(w->to, program);
    fputs("    traceVertexMain();\n}\n", w->to);
    for (int i = 0; i < ATTRIBUTES; i++)
        fprintf(w->to, "#undef %s\n", attributes[i]);
}

char *trace_text(const MatcProgram *program, const char *vertex, const char *fragment)
{
    char *text = NULL;
    size_t size = 0;
    Writer w = {.to = open_memstream(&text, &size)};
    if (!w.to)
        return NULL;
    fputs("#version 450 core\nvec4 trace_clip;\nbool trace_front;\n", w.to);
    put_attributes(w.to);
    put_vertex(&w, program, vertex, fragment);
    put_program(&w, fragment, fragment);
    put_functions(&w);
    fprintf(w.to, "%s%s%s", w.varying_count ? "#define TRACE_CHANGES\n" : "",
            render_text_trace_patch, render_text_trace_resolve);
    const bool fine = !ferror(w.to);
    if (fclose(w.to) == 0 && fine)
        return text;
    free(text);
    return NULL;
}
