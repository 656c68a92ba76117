/* Describes scenes: lists, pages, and schema definitions. */
#include "compiler/describe/describe.h"
#include "compiler/base/json_write.h"
#include <string.h>

const char *describe_scene_type(const SceneParamRow *row)
{
    static const char *const names[] = {[SCENE_VALUE_material] = "material",
                                        [SCENE_VALUE_file] = "file",
                                        [SCENE_VALUE_name] = "name",
                                        [SCENE_VALUE_one] = "object",
                                        [SCENE_VALUE_list] = "list"};
    return row->value == SCENE_VALUE_plain ? describe_type(&row->param) : names[row->value];
}

/* Formats a default with its unit: "1", "[0, 0, 1]", "40 degrees". */
static const char *default_text(Arena *arena, const SceneParamRow *row)
{
    Text text = text_new(arena);
    describe_default(&text, &row->param, NULL);
    if (*row->unit && row->param.components)
        text_format(&text, " %s", row->unit);
    return text.at;
}

static const char *range_text(Arena *arena, const SceneParamRow *row)
{
    Text text = text_new(arena);
    text_put(&text, "");
    if (row->value == SCENE_VALUE_plain)
        describe_range(&text, &row->param);
    return text.at;
}

static int wider(int width, const char *text)
{
    return (int)strlen(text) > width ? (int)strlen(text) : width;
}

static void put_params(Text *out, const SceneKindRow *kind)
{
    int width[4] = {0};
    const SceneParamRow *rows = &scene_param_table[kind->first];
    for (int i = 0; i < kind->count; i++) {
        const char *cells[4] = {rows[i].param.name, describe_scene_type(&rows[i]),
                                default_text(out->arena, &rows[i]),
                                range_text(out->arena, &rows[i])};
        for (int k = 0; k < 4; k++)
            width[k] = wider(width[k], cells[k]);
    }
    text_put(out, "\nParameters: name, type, default, range\n");
    for (int i = 0; i < kind->count; i++)
        text_format(out, "  %-*s  %-*s  %-*s  %-*s  %s\n", width[0], rows[i].param.name, width[1],
                    describe_scene_type(&rows[i]), width[2], default_text(out->arena, &rows[i]),
                    width[3], range_text(out->arena, &rows[i]), rows[i].param.doc);
}

static void put_preset_value(Text *out, const ScenePresetRow *row)
{
    const ParamRow *param = &scene_param_table[row->param].param;
    text_format(out, "%s: ", param->name);
    if (param_is_word(param))
        text_put(out, keyword_table[(int)row->value].name);
    else
        text_plain(out, row->value);
}

/* Writes a line for each keyword that sets other parameters: "quality: draft  rays: 4,
 * resolution: half". */
static void put_presets(Text *out, SceneKind kind)
{
    enum { WIDTH = 24 };
    const ScenePresetRow *before = NULL;
    for (int i = 0; i < scene_preset_count; i++) {
        const ScenePresetRow *row = &scene_preset_table[i];
        const SceneParamRow *key = &scene_param_table[row->key];
        if (key->kind != kind)
            continue;
        const bool same = before && before->key == row->key && before->word == row->word;
        if (!before)
            text_put(out, "\nValues of parameters that are not given, by words of others\n");
        if (!same)
            text_format(out, "%s  %s: %-*s", before ? "\n" : "", key->param.name,
                        WIDTH - (int)strlen(key->param.name), keyword_table[row->word].name);
        text_put(out, same ? ", " : "");
        put_preset_value(out, row);
        before = row;
    }
    text_put(out, before ? "\n" : "");
}

void describe_scene_kind(Text *out, SceneKind kind)
{
    const SceneKindRow *row = &scene_kind_table[kind];
    text_format(out, "%s (%s of a scene)\n%s\n", row->name, scene_sort_table[row->sort].name,
                row->doc);
    put_params(out, row);
    put_presets(out, kind);
}

void describe_scene_sort(Text *out, SceneSort sort)
{
    text_format(out, "%s (of a scene)\n%s\n\n", scene_sort_table[sort].name,
                scene_sort_table[sort].doc);
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (scene_kind_table[kind].sort == sort)
            text_format(out, "  %-14s %s\n", scene_kind_table[kind].name,
                        scene_kind_table[kind].doc);
}

/* Writes the schema of a value without the enclosing braces. */
static void put_value(Text *out, const SceneParamRow *row)
{
    const char *sort = scene_sort_table[row->of].name;
    switch (row->value) {
    case SCENE_VALUE_plain:
        describe_value(out, &row->param);
        break;
    case SCENE_VALUE_material:
        text_put(out, "\"$ref\": \"#/$defs/sceneMaterial\"");
        break;
    case SCENE_VALUE_file:
    case SCENE_VALUE_name:
        text_put(out, "\"type\": \"string\"");
        break;
    case SCENE_VALUE_one:
        text_format(out, "\"anyOf\": [{\"type\": \"null\"}, {\"$ref\": \"#/$defs/scene_%s\"}]",
                    sort);
        break;
    case SCENE_VALUE_list:
        text_format(out,
                    "\"type\": [\"array\", \"null\"], \"items\": {\"$ref\": \"#/$defs/scene_%s\"}",
                    sort);
        break;
    }
}

static void put_kind(Text *out, const SceneKindRow *row)
{
    const char *sort = scene_sort_table[row->sort].name, *comma = "";
    text_format(out, "    \"scene%s\": {\n      \"description\": ", row->name);
    json_string(out, row->doc);
    const bool only = scene_kind_only(row->sort) >= 0;
    text_put(out, ",\n      \"type\": \"object\", \"additionalProperties\": false");
    if (!only)
        text_format(out, ", \"required\": [\"%s\"]", sort);
    text_put(out, ",\n      \"properties\": {");
    if (row - scene_kind_table != SCENE_Scene) {
        text_format(out, "\n        \"%s\": {\"const\": \"%s\"}", sort, row->name);
        comma = ",";
    }
    for (int i = row->first; i < row->first + row->count; i++, comma = ",") {
        text_format(out, "%s\n        \"%s\": {\"description\": ", comma,
                    scene_param_table[i].param.name);
        json_string(out, scene_param_table[i].param.doc);
        text_put(out, ", ");
        put_value(out, &scene_param_table[i]);
        text_char(out, '}');
    }
    text_put(out, "\n      }\n    },\n");
}

static void put_sort(Text *out, SceneSort sort)
{
    const char *comma = "";
    text_format(out, "    \"scene_%s\": {\n      \"description\": ", scene_sort_table[sort].name);
    json_string(out, scene_sort_table[sort].doc);
    text_put(out, ",\n      \"anyOf\": [");
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (scene_kind_table[kind].sort == sort) {
            text_format(out, "%s\n        {\"$ref\": \"#/$defs/scene%s\"}", comma,
                        scene_kind_table[kind].name);
            comma = ",";
        }
    text_put(out, "\n      ]\n    },\n");
}

void describe_scene_definitions(Text *out)
{
    text_put(out,
             "    \"sceneMaterial\": {\n"
             "      \"description\": \"A name of `materials:`, a material, or one of a file.\",\n"
             "      \"anyOf\": [\n"
             "        {\"type\": [\"string\", \"null\"]},\n"
             "        {\"$ref\": \"#/$defs/material\"},\n"
             "        {\"type\": \"object\", \"required\": [\"file\"], \"additionalProperties\": "
             "false,\n"
             "          \"properties\": {\"file\": {\"type\": \"string\"}, \"material\": "
             "{\"type\": \"string\"}}}\n"
             "      ]\n    },\n");
    for (int sort = 0; sort < SCENE_SORT_COUNT; sort++)
        put_sort(out, (SceneSort)sort);
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        put_kind(out, &scene_kind_table[kind]);
}

void describe_scene_keys(Text *out)
{
    const SceneKindRow *row = &scene_kind_table[SCENE_Scene];
    for (int i = row->first; i < row->first + row->count; i++)
        text_format(out, ",\n        \"%s\": {\"$ref\": \"#/$defs/sceneScene/properties/%s\"}",
                    scene_param_table[i].param.name, scene_param_table[i].param.name);
}
