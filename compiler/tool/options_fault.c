/* Faults of the command line, with suggestions like those for documents. */
#include "grammar/key_table.h"
#include "compiler/tool/options_fault.h"
#include "compiler/base/text.h"
#include "compiler/choice.h"
#include "compiler/describe/describe.h"
#include "compiler/evaluate.h"
#include <string.h>

static const char *layout_name(const void *user, int i)
{
    (void)user;
    return i == LAYOUT_COUNT ? "auto" : layout_table[i].name;
}

bool options_values(const char *option, NameChoice *values)
{
    if (strcmp(option, "--layout") != 0)
        return !strncmp(option, "--", 2) && choice_values(option + 2, values);
    *values = (NameChoice){layout_name, NULL, LAYOUT_COUNT + 1};
    return true;
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
    if (i < DOCUMENT_KEY_COUNT)
        return key_table[i].name;
    i -= DOCUMENT_KEY_COUNT;
    if (i < PARAM_COUNT)
        return param_table[i].name;
    i -= PARAM_COUNT;
    if (i < SCENE_PARAM_COUNT)
        return scene_param_table[i].param.name;
    i -= SCENE_PARAM_COUNT;
    if (i < SCENE_KIND_COUNT)
        return scene_kind_table[i].name;
    i -= SCENE_KIND_COUNT;
    return i < LAYOUT_COUNT ? layout_table[i].name : diag_table[i - LAYOUT_COUNT].name;
}

const char *options_fault_explain(Arena *arena, const char *name)
{
    enum {
        NAMES = KIND_COUNT + WAVE_COUNT + CHOICE_COUNT + SLOT_COUNT + DOCUMENT_KEY_COUNT +
                PARAM_COUNT + SCENE_PARAM_COUNT + SCENE_KIND_COUNT + LAYOUT_COUNT + DIAG_COUNT
    };
    Text out = text_new(arena);
    text_format(&out, "--explain: unknown name '%s'%s", name,
                suggest(arena, name, explained_name, NULL, NAMES));
    return out.at;
}

const char *options_fault_list(Arena *arena, const char *kind)
{
    NameChoice kinds = {describe_list_kind, NULL, 0};
    while (describe_list_kind(NULL, kinds.count))
        kinds.count++;
    return option_fault_value(arena, "--list", kind, &kinds);
}

const char *options_fault_point(Arena *arena, const char *point)
{
    const char *fault = evaluate_point_fault(arena, point);
    Text out = text_new(arena);
    text_format(&out, "--eval: %s", fault ? fault : "");
    return fault ? out.at : NULL;
}
