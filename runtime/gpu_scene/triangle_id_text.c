#include "runtime/gpu_scene/triangle_id_text.h"
#include <stdio.h>
#include <string.h>

static const char around_main[] = "#define main surfaceMain\n";
static const char vertex_tail[] =
    "#undef main\nflat out uint seen_place;\nvoid main()\n{\n    surfaceMain();\n    "
    "seen_place = matc_instance;\n}\n";

void triangle_id_text_make(const GlContext *gl, const MaterialSet *set, const TriangleIdText *text,
                           TriangleIdTextParts *made)
{
    int targets = 0;
    while (material_set_format(set, targets))
        targets++;
    made->text = text;
    made->head = gl->major * 10 + gl->minor >= 45 ? "#version 450 core\n" : "#version 430 core\n";
    made->instances = text && text->places && set->instances;
    snprintf(made->defined, sizeof made->defined, "#undef main\n#define SEEN_TARGET %d\n%s",
             targets, made->instances ? "#define SEEN_INSTANCES\n" : "");
}

/* Returns the GLSL text after the #version line. */
static const char *rest_of(const char *text)
{
    const char *end = strchr(text, '\n');
    return end ? end + 1 : text;
}

void triangle_id_text_wrap(const TriangleIdTextParts *around, ProgramText *program)
{
    const char *const fragment[] = {around->head, around_main, rest_of(program->fragment[0]),
                                    around->defined, around->text->fragment};
    const char *const vertex[] = {around->head, around_main, rest_of(program->vertex[0]),
                                  vertex_tail};
    memcpy(program->fragment, fragment, sizeof fragment);
    if (around->instances)
        memcpy(program->vertex, vertex, sizeof vertex);
}
