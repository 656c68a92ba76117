/* What is looked up in a set: programs, their texts, the layout. */
#include "runtime/cache/set.h"
#include "compiler/layout/custom.h"
#include <string.h>

const SetProgram *set_find(const Set *set, int material, const char *pass)
{
    int number = set->of_material[material];
    while (number && strcmp(set->programs[number - 1].pass, pass) != 0)
        number = set->programs[number - 1].other;
    return number ? &set->programs[number - 1] : NULL;
}

int set_rows(const Set *set, int text)
{
    int rows = 0;
    for (int i = text; i >= 0; i = set->programs[i].next)
        rows++;
    return rows;
}

const char *set_vertex(const Set *set, const SetProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_VERTEX, NULL);
}

const char *set_fragment(const Set *set, const SetProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_FRAGMENT, NULL);
}

const char *set_format(const Set *set, int target)
{
    for (int i = 0; i < set->count; i++)
        if (strcmp(set->programs[i].pass, "sky") != 0)
            return target < matc_target_count(set->programs[i].program)
                       ? matc_target_format(set->programs[i].program, target)
                       : NULL;
    return NULL;
}

const LayoutRow *set_layout(const Set *set, const MatcOptions *compile_options)
{
    const MatcLayout *custom = set->layout ? set->layout : compile_options->custom;
    if (custom)
        return custom->row;
    for (int i = 0; compile_options->layout && i < LAYOUT_COUNT; i++)
        if (!strcmp(layout_table[i].name, compile_options->layout))
            return &layout_table[i];
    return &layout_table[LAYOUT_compact]; /* the default of the targets here */
}
