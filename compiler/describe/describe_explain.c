/* matc --explain NAME: writes the page of a name, or several pages if the name is ambiguous.
 * Case is ignored if no name matches exactly. */
#include "compiler/base/warnings.h"
#include "compiler/describe/describe.h"
#include "compiler/matc.h"
#include "grammar/expression_tables.h"
#include "grammar/key_table.h"
#include <math.h>
#include <string.h>
#include <strings.h>

typedef struct {
    Text *out;
    const char *name;
    int (*compare)(const char *, const char *); /* strcmp or strcasecmp, to compare names */
} Query;

/* Begins a new page if a row has the queried name. */
static bool begins(const Query *q, const char *name)
{
    if (q->compare(q->name, name) != 0)
        return false;
    if (q->out->size)
        text_char(q->out, '\n');
    return true;
}

static void put_indented(Text *out, const char *text)
{
    for (size_t size; *text; text += size + (text[size] == '\n')) {
        size = strcspn(text, "\n");
        text_put(out, "  ");
        text_add(out, text, size);
        text_char(out, '\n');
    }
}

typedef enum { COLUMN_name, COLUMN_type, COLUMN_default, COLUMN_range, COLUMN_COUNT } Column;

static Text cell(Arena *arena, const ParamRow *param, Column column, const char *preset)
{
    Text text = text_new(arena);
    text_put(&text, "");
    if (column == COLUMN_name)
        text_put(&text, param->name);
    else if (column == COLUMN_type)
        text_put(&text, describe_type(param));
    else if (column == COLUMN_default)
        describe_default(&text, param, preset);
    else
        describe_range(&text, param);
    return text;
}

static void put_parameters(Text *out, const KindRow *row, const char *preset)
{
    int width[COLUMN_COUNT] = {0};
    for (int i = row->first; i < row->first + row->count; i++)
        for (int column = 0; column < COLUMN_COUNT; column++) {
            int size = (int)cell(out->arena, &param_table[i], (Column)column, preset).size;
            width[column] = size > width[column] ? size : width[column];
        }
    text_put(out, "\nParameters: name, type, default, range\n");
    for (int i = row->first; i < row->first + row->count; i++) {
        for (int column = 0; column < COLUMN_COUNT; column++)
            if (width[column])
                text_format(out, "  %-*s", width[column],
                            cell(out->arena, &param_table[i], (Column)column, preset).at);
        text_format(out, "  %s\n", param_table[i].doc);
    }
}

static void put_aliases(Text *out, Kind kind)
{
    const char *before = "Also called ";
    for (int i = 0; i < alias_count; i++)
        if (alias_table[i].kind == kind) {
            text_format(out, "%s%s", before, alias_table[i].alias);
            before = ", ";
        }
    if (*before == ',')
        text_put(out, ".\n");
}

static void put_presets(Text *out, Kind kind)
{
    for (int i = 0; i < preset_count; i++) {
        const ParamRow *param = &param_table[preset_table[i].param];
        if (preset_table[i].kind != kind)
            continue;
        if (describe_is_preset_head(i))
            text_format(out, "Preset %s: ", preset_table[i].name);
        text_format(out, "%s ", param->name);
        text_plain(out, preset_table[i].init);
        text_put(out, i + 1 < preset_count && !describe_is_preset_head(i + 1) ? ", " : ".\n");
    }
}

static void put_kind(Text *out, Kind kind, const char *preset)
{
    const KindRow *row = &kind_table[kind];
    const char *what = row->lowering == LOWERING_MATERIAL ? "material" : "map";
    if (preset)
        text_format(out, "%s (preset of the %s %s)\n", preset, what, row->name);
    else
        text_format(out, "%s (%s)\n", row->name, what);
    text_format(out, "%s\n", row->doc);
    put_aliases(out, kind);
    if (!preset)
        put_presets(out, kind);
    put_parameters(out, row, preset);
    text_put(out, "\nMeaning\n");
    put_indented(out, kind_table[kind].formula);
    describe_translations(out, kind, "  ");
    text_put(out, "\nAnswers\n");
    put_indented(out, kind_table[kind].answers);
    Text example = text_new(out->arena);
    describe_example(&example, kind, preset ? preset : row->name);
    text_put(out, "\nExample\n");
    put_indented(out, example.at);
}

static void explain_kinds(const Query *q)
{
    for (int i = 0; i < KIND_COUNT; i++)
        if (begins(q, kind_table[i].name))
            put_kind(q->out, (Kind)i, NULL);
    for (int i = 0; i < alias_count; i++)
        if (begins(q, alias_table[i].alias))
            put_kind(q->out, alias_table[i].kind, NULL);
    for (int i = 0; i < preset_count; i++)
        if (describe_is_preset_head(i) && begins(q, preset_table[i].name))
            put_kind(q->out, preset_table[i].kind, preset_table[i].name);
}

static void explain_scenes(const Query *q)
{
    for (int sort = 0; sort < SCENE_SORT_COUNT; sort++)
        if (begins(q, scene_sort_table[sort].name))
            describe_scene_sort(q->out, (SceneSort)sort);
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (begins(q, scene_kind_table[kind].name))
            describe_scene_kind(q->out, (SceneKind)kind);
}

static void explain_waves(const Query *q)
{
    for (int i = 0; i < WAVE_COUNT; i++)
        if (begins(q, wave_table[i].name))
            text_format(q->out,
                        "%s (wave)\n%s\n\nExample\n  diffuse: { map: Gradient, waveForm: %s }\n",
                        wave_table[i].name, wave_table[i].doc, wave_table[i].name);
    if (begins(q, "Chain"))
        text_put(q->out,
                 "Chain (wave)\n" CHAIN_DOC "\n\nFields: name, type, default\n"
                 "  first   wave    none  The waveform that is applied first; none is v itself.\n"
                 "  factor  number  1     Factor of the first waveform's value.\n"
                 "  shift   number  0     Added after the factor.\n"
                 "  second  wave    none  The waveform that is applied last.\n\nExample\n"
                 "  diffuse: { map: Gradient, waveForm: { wave: Chain, first: Sin01, "
                 "factor: 2, second: Abs } }\n");
}

static void explain_functions(const Query *q)
{
    for (int i = 0; i < TERM_COUNT; i++)
        if (term_table[i].callable && begins(q, term_table[i].name))
            describe_function(q->out, i);
    for (int i = 0; i < QUANTITY_COUNT; i++)
        if (begins(q, quantity_table[i].name))
            text_format(q->out, "%s (value of formulas)\n%s\n\nExample\n  diffuse: \"= %s\"\n",
                        quantity_table[i].name, quantity_table[i].doc, quantity_table[i].name);
    for (int i = 0; i < vector_count; i++)
        if (begins(q, vector_table[i].name))
            text_format(q->out, "%s (function of formulas)\n%s\n", vector_table[i].name,
                        vector_table[i].doc);
    for (int i = 0; i < SPECIAL_COUNT; i++)
        if (begins(q, formula_special_table[i].name))
            text_format(q->out, "%s (function of formulas)\n%s\n%s\n",
                        formula_special_table[i].name, formula_special_table[i].form,
                        formula_special_table[i].doc);
}

static void explain_colors(const Query *q)
{
    for (int i = 0; i < color_count; i++) {
        const unsigned char *rgb = color_table[i].rgb;
        if (begins(q, color_table[i].name))
            text_format(q->out, "%s (color)\n#%02x%02x%02x\n", color_table[i].name, rgb[0], rgb[1],
                        rgb[2]);
    }
}

/* Writes the page on color spaces. */
static void explain_color_spaces(const Query *q)
{
    if (begins(q, "srgb"))
        text_put(q->out,
                 "srgb (of a color, or of colors:)\n"
                 "Encoded by IEC 61966-2-1, as in color pickers and most images.\n\nMeaning\n"
                 "  c / 12.92 if c <= 0.04045, else ((c + 0.055) / 1.055)^2.4; alpha is "
                 "unchanged\n\nExample\n"
                 "  diffuse: \"srgb(#808080)\"\n");
    if (begins(q, "linear"))
        text_put(q->out,
                 "linear (of a color, or of colors:)\n"
                 "Linear light: the value is the byte divided by 255.\n\nExample\n  diffuse: "
                 "\"linear(#808080)\"\n");
}

static void explain_keys(const Query *q)
{
    for (int i = 0; i < DOCUMENT_KEY_COUNT; i++) {
        const KeyRow *row = &key_table[i];
        if (begins(q, row->name))
            text_format(q->out, "%s (key %s)\n%s\n\nExample\n%s", row->name, row->where, row->doc,
                        row->example);
    }
}

static void explain_channels(const Query *q)
{
    for (int i = 0; i < CHANNEL_COUNT; i++)
        if (begins(q, channel_table[i].name))
            text_format(q->out, "%s (channel %d)\n%s\n", channel_table[i].name,
                        COMPONENTS_OF_GROUP * (int)channel_table[i].group +
                            channel_table[i].component,
                        channel_table[i].doc);
}

static void explain_slots(const Query *q)
{
    for (int i = 0; i < SLOT_COUNT; i++) {
        const SlotRow *slot = &slot_table[i];
        if (!begins(q, slot->name))
            continue;
        text_format(q->out, "%s (slot, %s)\n%s\nFrom ", slot->name, type_table[slot->type].name,
                    slot->doc);
        text_plain(q->out, slot->low);
        text_put(q->out, " to ");
        text_plain(q->out, slot->high);
        text_put(q->out, " on a valid surface.\n");
    }
}

static void explain_layouts(const Query *q)
{
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (begins(q, layout_table[i].name))
            describe_layout(q->out, &layout_table[i]);
}

static void explain_encodings(const Query *q)
{
    for (int i = 0; i < ENCODING_COUNT; i++) {
        const EncodingRow *row = &encoding_table[i];
        if (!begins(q, row->name))
            continue;
        text_format(q->out, "%s (encoding, for targets of %s)\n%s\n", row->name,
                    row->words ? "words" : "floats", row->doc);
        if (row->least != row->most)
            text_format(q->out, "%d to %d bits.\n", row->least, row->most);
    }
}

static void explain_programs(const Query *q)
{
    for (int i = 0; i < TARGET_COUNT; i++)
        if (begins(q, target_table[i].name))
            text_format(q->out, "%s (target, #version %s)\n%s\n", target_table[i].name,
                        target_table[i].version, target_table[i].doc);
    for (int i = 0; i < PASS_COUNT; i++)
        if (begins(q, pass_table[i].name))
            text_format(q->out, "%s (pass)\n%s\n", pass_table[i].name, pass_table[i].doc);
    for (int i = 0; i < NORMALS_COUNT; i++)
        if (begins(q, normals_table[i].name))
            text_format(q->out, "%s (of --normals)\n%s\n", normals_table[i].name,
                        normals_table[i].doc);
    for (int i = 0; i < CHOICE_COUNT; i++)
        if (begins(q, choice_table[i].name))
            text_format(q->out, "%s (of --%s)\n%s\n", choice_table[i].name,
                        axis_table[choice_table[i].axis].name, choice_table[i].doc);
}

static void explain_diags(const Query *q)
{
    for (int i = 0; i < DIAG_COUNT; i++) {
        const DiagRow *diag = &diag_table[i];
        if (!begins(q, diag->name))
            continue;
        text_format(q->out, "%s (diagnostic)\n%s: ", diag->name, severity_names[diag->severity]);
        describe_message(q->out, diag);
        text_format(q->out, "\n%s\n", diag->doc);
    }
}

static void explain_warnings(const Query *q)
{
    if (!begins(q, "warnings"))
        return;
    text_put(q->out,
             "warnings (diagnostics that do not stop compilation)\n-Wno-NAME disables a warning, "
             "-Werror=NAME makes it an error, -Werror makes all warnings errors. The last "
             "option\nfor a warning wins; -WNAME and -Wno-error=NAME undo earlier options. All "
             "warnings are enabled by default, except\nlinear_colors: a note, never an error, that "
             "is enabled for single documents, and otherwise by -Wlinear_colors.\n\n");
    for (int i = 0; i < DIAG_COUNT; i++)
        if (diag_is_named((DiagKind)i))
            text_format(q->out, "  %-20s  %s\n", diag_table[i].name, diag_table[i].doc);
}

/* Writes the page of a warning's present name, for a name of version 0.1. */
static void explain_renamed(const Query *q)
{
    const char *present = warnings_renamed(q->name);
    if (!present)
        return;
    text_format(q->out, "%s (former name of a warning, now %s)\n", q->name, present);
    explain_diags(&(Query){q->out, present, strcmp});
}

char *describe_explain(const char *name)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    Query query = {&out, name, strcmp};
    explain_renamed(&query);
    for (int round = 0; round < 2 && !out.size; round++) {
        explain_kinds(&query);
        explain_scenes(&query);
        explain_waves(&query);
        explain_functions(&query);
        explain_colors(&query);
        explain_color_spaces(&query);
        explain_keys(&query);
        explain_channels(&query);
        explain_slots(&query);
        explain_programs(&query);
        explain_layouts(&query);
        explain_encodings(&query);
        explain_diags(&query);
        explain_warnings(&query);
        describe_params(&out, name, query.compare);
        describe_words(&out, name, query.compare);
        query.compare = strcasecmp;
    }
    describe_foreign(&out, name);
    if (out.size)
        return describe_finish(&out);
    arena_free(&arena);
    return matc_list_of(name); /* a name of --list */
}
