#include "runtime/cache/exact_number.h"
#include "gen/render_text.h"
#include <stdio.h>
#include <string.h>

static const char around[] = "#define main surfaceMain\n";
static const char vertex_tail[] =
    "#undef main\nflat out uint exact_place;\nvoid main()\n{\n    surfaceMain();\n    "
    "exact_place = matc_instance;\n}\n";

void exact_number_text(const GlContext *gl, const Set *set, ExactNumberWhat what,
                       ExactNumberText *made)
{
    int targets = 0;
    while (set_format(set, targets))
        targets++;
    made->head = gl->major * 10 + gl->minor >= 45 ? "#version 450 core\n" : "#version 430 core\n";
    made->what = what;
    made->instances = what == EXACT_NUMBER_numbers && set->instances;
    snprintf(made->defined, sizeof made->defined, "#undef main\n#define EXACT_TARGET %d\n%s",
             targets, made->instances ? "#define EXACT_INSTANCES\n" : "");
}

/* What follows its #version. */
static const char *rest_of(const char *text)
{
    const char *end = strchr(text, '\n');
    return end ? end + 1 : text;
}

void exact_number_wrap(const ExactNumberText *text, ProgramText *program)
{
    const char *const fragment[] = {
        text->head, around, rest_of(program->fragment[0]), text->defined,
        text->what == EXACT_NUMBER_numbers ? render_text_exact_number : render_text_facet_slopes};
    const char *const vertex[] = {text->head, around, rest_of(program->vertex[0]), vertex_tail};
    memcpy(program->fragment, fragment, sizeof fragment);
    if (text->instances)
        memcpy(program->vertex, vertex, sizeof vertex);
}
