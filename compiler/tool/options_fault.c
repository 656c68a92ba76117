/* Faults of the command line, as good as those of documents. */
#include "compiler/tool/options_fault.h"
#include "compiler/base/text.h"
#include "compiler/describe/describe.h"
#include <string.h>

static const char *target_name(const void *user, int i)
{
    (void)user;
    return target_table[i].name;
}

static const char *pass_name(const void *user, int i)
{
    (void)user;
    return pass_table[i].name;
}

static const char *slot_name(const void *user, int i)
{
    (void)user;
    return slot_table[i].name;
}

static const char *layout_name(const void *user, int i)
{
    (void)user;
    return i == LAYOUT_COUNT ? "auto" : layout_table[i].name;
}

static const char *precision_name(const void *user, int i)
{
    (void)user;
    return precision_table[i].name;
}

static const char *constants_name(const void *user, int i)
{
    static const char *const names[] = {"auto", "baked", "uniform"};
    (void)user;
    return names[i];
}

static const char *choice_name(const void *axis, int i)
{
    return choice_table[((const AxisRow *)axis)->first + i].name;
}

bool options_fault_values(const char *option, NameChoice *values)
{
    static const struct {
        const char *option;
        NameChoice values;
    } lists[] = {{"target", {target_name, NULL, TARGET_COUNT}},
                 {"pass", {pass_name, NULL, PASS_COUNT}},
                 {"slot", {slot_name, NULL, SLOT_COUNT}},
                 {"layout", {layout_name, NULL, LAYOUT_COUNT + 1}},
                 {"precision", {precision_name, NULL, PRECISION_COUNT}},
                 {"constants", {constants_name, NULL, 3}}};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        if (!strcmp(lists[i].option, option)) {
            *values = lists[i].values;
            return true;
        }
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        if (!strcmp(axis_table[axis].name, option)) {
            *values = (NameChoice){choice_name, &axis_table[axis], axis_choices(axis)};
            return true;
        }
    return false;
}

const char *options_fault_value(Arena *arena, const char *option, const char *value, const NameChoice *values)
{
    Text out = text_new(arena);
    text_format(&out, "%s: there is no '%s', but %s%s", option, value, suggest_list(arena, values),
                suggest(arena, value, values->name, values->user, values->count));
    return out.at;
}

static const char *explained_name(const void *user, int i)
{
    (void)user;
    if (i < KIND_COUNT)
        return kind_table[i].name;
    i -= KIND_COUNT;
    if (i < WAVE_COUNT)
        return wave_table[i].name;
    i -= WAVE_COUNT;
    if (i < CHOICE_COUNT)
        return choice_table[i].name;
    i -= CHOICE_COUNT;
    if (i < SLOT_COUNT)
        return slot_table[i].name;
    i -= SLOT_COUNT;
    return i < LAYOUT_COUNT ? layout_table[i].name : diag_table[i - LAYOUT_COUNT].name;
}

const char *options_fault_explain(Arena *arena, const char *name)
{
    enum { NAMES = KIND_COUNT + WAVE_COUNT + CHOICE_COUNT + SLOT_COUNT + LAYOUT_COUNT + DIAG_COUNT };
    Text out = text_new(arena);
    text_format(&out, "--explain: nothing is called '%s'%s", name, suggest(arena, name, explained_name, NULL, NAMES));
    return out.at;
}

const char *options_fault_list(Arena *arena, const char *kind)
{
    NameChoice kinds = {describe_list_kind, NULL, 0};
    while (describe_list_kind(NULL, kinds.count))
        kinds.count++;
    return options_fault_value(arena, "--list", kind, &kinds);
}

const char *options_fault_number(Arena *arena, const char *wants, const char *value)
{
    Text out = text_new(arena);
    text_format(&out, "%s, not '%s'", wants, value);
    return out.at;
}
