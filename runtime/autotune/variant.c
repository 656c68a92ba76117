/* Converts variants to options and names, and enumerates combinations. */
#include "runtime/autotune/variant.h"
#include "compiler/pipeline.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

MatcProgram *variant_compile(const MatcDocument *document, int material, unsigned outputs,
                             const MatcOptions *options)
{
    MatcOptions quiet = *options;
    quiet.target = NULL;
    quiet.validate = quiet.check = quiet.measure = false;
    MatcProgram *program = matc_compile(document, material, outputs, &quiet);
    if (matc_ok(program))
        return program;
    matc_program_free(program);
    return NULL;
}

bool variant_of(const MatcOptions *options, Variant *variant)
{
    Job job;
    if (choice_job(options, &job))
        return false;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        variant->choice[axis] = (int)job.choice[axis];
    variant->layout = (int)(job.layout - layout_table);
    return true;
}

VariantAxes variant_open(const MatcOptions *o)
{
    VariantAxes open = {.axis = {
#define AXIS(name, chunks, doc) [AXIS_##name] = o->name == NULL,
#include "grammar/variants.def"
                        }};
    open.layout = o->layout == NULL;
    for (int row = 0; o->precision && row < PRECISION_COUNT; row++)
        for (int axis = 0; axis < AXIS_COUNT; axis++)
            if (!strcmp(precision_table[row].name, o->precision) &&
                precision_table[row].choice[axis] >= 0)
                open.axis[axis] = false;
    return open;
}

MatcOptions variant_options(const Variant *variant, const MatcOptions *base)
{
    MatcOptions options = *base;
    options.precision = NULL;
    options.layout = layout_table[variant->layout].name;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        matc_options_set(&options, axis_table[axis].name, choice_table[variant->choice[axis]].name);
    return options;
}

/* Returns the size of a program's header up to the comment that names the choices, or else up to
 * the empty line after the header. */
static size_t header_size(const char *program)
{
    const char *end = strstr(program, "\n\n"), *choices = strstr(program, "\n// choices:");
    return (size_t)((choices && choices < end ? choices : end ? end : program) - program);
}

bool variant_programs_equal(const char *a, const char *b)
{
    const char *a_body = strstr(a, "\n\n"), *b_body = strstr(b, "\n\n");
    size_t header = header_size(a);
    return a_body && b_body && header == header_size(b) && !memcmp(a, b, header) &&
           !strcmp(a_body, b_body);
}

int variant_distance(const Variant *a, const Variant *b)
{
    int distance = a->layout != b->layout;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        distance += a->choice[axis] != b->choice[axis];
    return distance;
}

/* Steps to the next combination like an odometer; returns false after the last. */
static bool advance(Variant *variant, const VariantAxes *open)
{
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        if (!open->axis[axis])
            continue;
        if (++variant->choice[axis] < axis_table[axis].first + axis_choices((Axis)axis))
            return true;
        variant->choice[axis] = axis_table[axis].first;
    }
    if (!open->layout)
        return false;
    if (++variant->layout < LAYOUT_COUNT)
        return true;
    variant->layout = 0;
    return false;
}

static Variant *all_combinations(const Variant *base, const VariantAxes *open, int *count)
{
    Variant *list = calloc(VARIANT_LIMIT, sizeof *list), next = *base;
    if (!list)
        abort();
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        if (open->axis[axis])
            next.choice[axis] = axis_table[axis].first;
    if (open->layout)
        next.layout = 0;
    *count = 0;
    do
        list[(*count)++] = next;
    while (advance(&next, open) && *count < VARIANT_LIMIT);
    return list;
}

Variant *variant_list(const Variant *base, const VariantAxes *open, int *count)
{
    Variant *all = all_combinations(base, open, count),
            *sorted = calloc((size_t)*count + 1, sizeof *sorted);
    if (!sorted)
        abort();
    int filled = 0;
    for (int distance = 0; distance <= AXIS_COUNT + 1; distance++)
        for (int i = 0; i < *count; i++)
            if (variant_distance(&all[i], base) == distance)
                sorted[filled++] = all[i];
    free(all);
    return sorted;
}

static void add(char *name, const char *what, const char *value)
{
    size_t size = strlen(name);
    snprintf(name + size, VARIANT_NAME - size, "%s%s=%s", size ? " " : "", what, value);
}

void variant_name(const Variant *variant, const Variant *base, char name[VARIANT_NAME])
{
    *name = 0;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        if (variant->choice[axis] != base->choice[axis])
            add(name, axis_table[axis].name, choice_table[variant->choice[axis]].name);
    if (variant->layout != base->layout)
        add(name, "layout", layout_table[variant->layout].name);
    if (!*name)
        strcpy(name, "as given");
}
