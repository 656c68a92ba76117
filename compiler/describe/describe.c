/* Formats rows of the tables as text. */
#include "compiler/describe/describe.h"
#include "compiler/base/memory.h"
#include "grammar/unit_table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const severity_names[] = {"note", "warning", "error", "note, off by default"};

const char *describe_type(const ParamRow *param)
{
    static const char *const names[] = {
        [PARAM_Map] = "map",           [PARAM_Material] = "material",
        [PARAM_Float] = "number",      [PARAM_Int] = "whole",
        [PARAM_Bool] = "bool",         [PARAM_Vec3] = "3 numbers",
        [PARAM_Wave] = "wave",         [PARAM_Image] = "file",
        [PARAM_Items] = "items",       [PARAM_Transform] = "transform",
        [PARAM_Formula] = "formula",   [PARAM_Maps] = "maps",
        [PARAM_List] = "list of maps",
    };
    return param_is_word(param)           ? "name"
           : param->kind == KIND_Constant ? "1-4 numbers"
                                          : names[param->type];
}

static double initial(const ParamRow *param, int component, const char *preset)
{
    for (int i = 0; preset && i < preset_count; i++)
        if (!strcmp(preset_table[i].name, preset) && &param_table[preset_table[i].param] == param)
            return preset_table[i].init;
    return param->init[component];
}

void describe_default(Text *out, const ParamRow *param, const char *preset)
{
    if (!param->components) {
        text_put(out, "none");
    } else if (param->type == PARAM_Bool) {
        text_put(out, initial(param, 0, preset) != 0 ? "true" : "false");
    } else if (param_is_word(param)) {
        text_put(out, keyword_table[(int)param->init[0]].name);
    } else if (param->components == 1) {
        text_plain(out, initial(param, 0, preset));
    } else {
        for (int i = 0; i < param->components; i++) {
            text_put(out, i ? ", " : "[");
            text_plain(out, initial(param, i, preset));
        }
        text_char(out, ']');
    }
}

void describe_range(Text *out, const ParamRow *param)
{
    const UnitRow *unit = param->kind == KIND_COUNT ? NULL : unit_of((int)(param - param_table));
    const bool bound = isfinite(param->low);
    if (!bound && !(unit && isfinite(unit->low))) {
        text_put(out, unit ? unit->name : "");
        return;
    }
    text_put(out, bound ? "" : "usually ");
    text_plain(out, bound ? param->low : round(unit->low * 1e3) / 1e3);
    text_put(out, " to ");
    text_plain(out, bound ? param->high : round(unit->high * 1e3) / 1e3);
    if (unit && *unit->name)
        text_format(out, " %s", unit->name);
}

/* Returns an example value for a parameter without a default; NULL: omit the parameter. */
static const char *sample_value(const ParamRow *param)
{
    switch (param->type) {
    case PARAM_Map:
        return strcmp(param->name, "displacement") != 0 ? NULL : "{ map: Carpenter }";
    case PARAM_Material:
        return "{ material: RGBA }";
    case PARAM_Wave:
        return "Id";
    case PARAM_Transform:
        return "{ scale: 2 }";
    case PARAM_Formula:
        return "mix(a, b, u)";
    case PARAM_Maps:
        return "{ a: black, b: white }";
    case PARAM_List:
        return "[black, white]";
    case PARAM_Items:
        return "[{ value: 0, input: black }, { value: 1, input: white }]";
    default:
        return NULL;
    }
}

/* Returns true if an example shows the parameter: examples of materials omit displacement. */
static bool is_in_example(const ParamRow *param, bool material)
{
    static const char moves[] = "displacement";
    return (param->components || sample_value(param)) &&
           !(material && !strncmp(param->name, moves, sizeof moves - 1));
}

void describe_example(Text *out, Kind kind, const char *name)
{
    const KindRow *row = &kind_table[kind];
    bool material = row->lowering == LOWERING_MATERIAL;
    const char *indent = material ? "" : "  ";
    if (row->example) {
        text_put(out, row->example);
        return;
    }
    text_format(out, material ? "material: %s\n" : "material: Phong\n", name);
    if (!material)
        text_format(out, "%s:\n  map: %s\n",
                    section_of(kind) == SECTION_normal ? "input" : "diffuse", name);
    for (int i = row->first; i < row->first + row->count; i++) {
        const ParamRow *param = &param_table[i];
        if (!is_in_example(param, material))
            continue;
        text_format(out, "%s%s: ", indent, param->name);
        if (param->components)
            describe_default(out, param, name);
        else
            text_put(out, sample_value(param));
        text_char(out, '\n');
    }
}

static void put_slot(Text *out, Slot slot, int from, int count)
{
    const int components = type_table[slot_table[slot].type].components;
    text_put(out, slot_table[slot].name);
    if (components == 1 || count == components)
        return;
    text_char(out, '.');
    for (int i = 0; i < count; i++)
        text_char(out, "rgba"[from + i]);
}

void describe_piece(Text *out, const Piece *piece)
{
    const SlotComponent *source = &piece->field->source[piece->first];
    if (piece->field->gray) {
        text_format(out, "%s, equal in all components", slot_table[source->slot].name);
        return;
    }
    for (int i = 0, run; i < piece->count; i += run) {
        run = 1;
        while (i + run < piece->count && source[i + run].slot == source[i].slot &&
               source[i + run].component == source[i].component + run)
            run++;
        text_put(out, i ? ", " : "");
        put_slot(out, source[i].slot, source[i].component, run);
    }
}

void describe_allocation(Text *out, const LayoutRow *layout, const Piece *piece)
{
    const char *letter = &"rgba"[piece->component];
    int last = piece->shift + piece->size - 1;
    if (!format_table[layout->formats[piece->target]].words)
        text_format(out, "%d.%.*s", piece->target, piece->size, letter);
    else if (last > piece->shift)
        text_format(out, "%d.%c %d-%d", piece->target, *letter, piece->shift, last);
    else
        text_format(out, "%d.%c %d", piece->target, *letter, last);
}

/* Rounds to three significant digits. */
static void put_rounded(Text *out, double value) { text_rounded(out, value, 3); }

void describe_error(Text *out, const FieldRow *field)
{
    double error = field_error(field);
    switch (encoding_table[field->encoding].unit) {
    case UNIT_degrees:
        put_rounded(out, error);
        text_put(out, " degrees");
        break;
    case UNIT_relative:
        put_rounded(out, 100 * error);
        text_put(out, error == 0 ? "" : " %");
        break;
    case UNIT_absolute:
        put_rounded(out, error);
    }
}

/* Returns true for a "%s" directly after a word or a closing quote: a hint, usually empty. */
static bool is_hint(const char *format, const char *at)
{
    if (at == format || strchr(" \n", at[-1]))
        return false;
    return at[-1] != '\'' || (at - 1 != format && at[-2] != ' ');
}

void describe_message(Text *out, const DiagRow *diag)
{
    const char *format = diag->format;
    for (const char *at = format; *at; at++) {
        if (*at == '\n')
            text_char(out, ' ');
        else if (*at != '%')
            text_char(out, *at);
        else if (*++at == '%')
            text_char(out, '%');
        else {
            if (!is_hint(format, at - 1))
                text_put(out, "...");
            at += strspn(at, "l"); /* skips the length modifier of %ld */
        }
    }
}

bool describe_is_preset_head(int row)
{
    return !row || strcmp(preset_table[row].name, preset_table[row - 1].name) != 0;
}

char *describe_finish(Text *text)
{
    char *copy = strdup(text->at ? text->at : "");
    if (!copy)
        memory_exhausted();
    arena_free(text->arena);
    return copy;
}
