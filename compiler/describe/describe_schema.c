/* matc --schema: JSON Schema (2020-12) of documents, from the tables. Editors complete and check
 * documents with it; a document that it rejects is also rejected by matc. describe_files.c has
 * the schemas of other files. */
#include "compiler/base/session.h"
#include "compiler/describe/describe.h"
#include "compiler/base/json_write.h"
#include "compiler/matc.h"
#include <string.h>

#define NUMBERS                                                                                    \
    "{\"type\": \"number\"}, {\"type\": \"number\"}, {\"type\": \"number\"}, {\"type\": "          \
    "\"number\"}"

/* Definitions with parameters; neither these nor the definitions below are in a table. */
static const char parameter_definitions[] =
    "    \"parameter\": {\n"
    "      \"description\": \"A definition's parameter: its default, or what is known of it.\",\n"
    "      \"if\": {\"type\": \"object\", \"anyOf\": [{\"required\": [\"default\"]}, "
    "{\"required\": [\"type\"]}], "
    "\"not\": {\"required\": [\"param\"]}},\n"
    "      \"then\": {\"additionalProperties\": false, \"properties\": {\n"
    "        \"default\": {},\n"
    "        \"type\": {\"enum\": [\"number\", \"color\", \"map\", \"material\", \"wave\", "
    "\"transform\", \"bool\", "
    "\"text\"]},\n"
    "        \"doc\": {\"type\": \"string\"}, \"min\": {\"type\": \"number\"}, \"max\": {\"type\": "
    "\"number\"}\n"
    "      }}\n"
    "    },\n";
static const char definition_properties[] =
    "      \"type\": \"object\", \"anyOf\": [{\"required\": [\"params\"]}, {\"required\": "
    "[\"doc\"]}],\n"
    "      \"oneOf\": [{\"required\": [\"map\"]}, {\"required\": [\"material\"]}, {\"required\": "
    "[\"ref\"]}],\n"
    "      \"properties\": {\n"
    "        \"doc\": {\"type\": \"string\"},\n"
    "        \"params\": {\"type\": [\"object\", \"null\"], \"additionalProperties\": {\"$ref\": "
    "\"#/$defs/parameter\"}, \"maxProperties\": 64}\n"
    "      }\n"
    "    },\n";

/* A use of any definition, without knowledge of the document's definitions. */
static const char any_ref[] = "      \"type\": \"object\", \"required\": [\"ref\"],\n"
                              "      \"properties\": {\"ref\": {\"type\": \"string\"}},\n"
                              "      \"additionalProperties\": {\"description\": \"An argument for "
                              "a parameter of the definition.\"}\n"
                              "    },\n";

/* Members allowed next to a material at the top level. */
#define BESIDE                                                                                     \
    "        \"defs\": {\"$ref\": \"#/$defs/defs\"},\n"                                            \
    "        \"include\": {\"$ref\": \"#/$defs/include\"},\n"                                      \
    "        \"colors\": {\"$ref\": \"#/$defs/colors\"}"

/* A document whose top level is a use of a definition. */
static const char any_ref_document[] =
    "{\n"
    "      \"description\": \"A material of `defs:`, the document's own or of a file that it "
    "includes.\",\n"
    "      \"type\": \"object\", \"required\": [\"ref\"], \"not\": {\"required\": "
    "[\"materials\"]},\n"
    "      \"properties\": {\n        \"ref\": {\"type\": \"string\"},\n" BESIDE "\n      },\n"
    "      \"additionalProperties\": {\"description\": \"An argument for a parameter of the "
    "definition.\"}\n"
    "    }";

/* Definitions that are not in a table. */
static const char fixed_definitions[] =
    "      \"type\": \"object\", \"required\": [\"param\", \"default\"], \"additionalProperties\": "
    "false,\n"
    "      \"properties\": {\n"
    "        \"param\": {\"type\": \"string\", \"pattern\": \"^[A-Za-z][A-Za-z0-9_]*$\", "
    "\"maxLength\": %d},\n"
    "        \"default\": {\"$ref\": \"#/$defs/constant\"}\n"
    "      }\n"
    "    },\n"
    "    \"list\": {\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 2, "
    "\"maxItems\": 4},\n"
    "    \"constant\": {\"anyOf\": [{\"type\": \"number\"}, {\"$ref\": \"#/$defs/color\"}, "
    "{\"$ref\": "
    "\"#/$defs/list\"}]},\n"
    "    \"numberParam\": {\"$ref\": \"#/$defs/param\", \"properties\": {\"default\": {\"type\": "
    "\"number\"}}},\n"
    "    \"number\": {\"anyOf\": [{\"type\": [\"number\", \"null\"]}, {\"$ref\": "
    "\"#/$defs/numberParam\"}, {\"$ref\": \"#/$defs/shorthand\"}]},\n"
    "    \"whole\": {\n"
    "      \"anyOf\": [\n"
    "        {\"type\": [\"integer\", \"null\"], \"minimum\": -2147483647, \"maximum\": "
    "2147483647},\n"
    "        {\"$ref\": \"#/$defs/numberParam\"},\n"
    "        {\"$ref\": \"#/$defs/shorthand\"}\n"
    "      ]\n"
    "    },\n"
    "    \"bool\": {\"type\": [\"boolean\", \"null\"]},\n"
    "    \"file\": {\"type\": [\"string\", \"null\"]},\n"
    "    \"vector\": {\n"
    "      \"anyOf\": [\n"
    "        {\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 3, "
    "\"maxItems\": 3},\n"
    "        {\"type\": [\"number\", \"null\"]},\n"
    "        {\"$ref\": \"#/$defs/color\"},\n"
    "        {\"$ref\": \"#/$defs/param\"},\n"
    "        {\"$ref\": \"#/$defs/shorthand\"}\n"
    "      ]\n"
    "    },\n"
    "    \"items\": {\n"
    "      \"type\": [\"array\", \"null\"],\n"
    "      \"items\": {\n"
    "        \"type\": \"object\", \"additionalProperties\": false,\n"
    "        \"properties\": {\n"
    "          \"value\": {\"description\": \"Where the item stands.\", \"$ref\": "
    "\"#/$defs/number\", \"default\": "
    "0},\n"
    "          \"input\": {\"description\": \"The map there.\", \"$ref\": \"#/$defs/map\"}\n"
    "        }\n"
    "      }\n"
    "    },\n"
    "    \"mapList\": {\"type\": [\"array\", \"null\"], \"items\": {\"$ref\": \"#/$defs/map\"}},\n"
    "    \"transform\": {\n"
    "      \"anyOf\": [\n"
    "        {\"type\": \"null\"},\n"
    "        {\n"
    "          \"type\": \"object\", \"required\": [\"matrix\"], \"additionalProperties\": false,\n"
    "          \"properties\": {\n"
    "            \"matrix\": {\n"
    "              \"description\": \"16 numbers, by rows; the last row is 0, 0, 0, 1.\",\n"
    "              \"type\": \"array\", \"minItems\": 16, \"maxItems\": 16,\n"
    "              \"prefixItems\": [\n"
    "                " NUMBERS ", " NUMBERS ", " NUMBERS ",\n"
    "                {\"const\": 0}, {\"const\": 0}, {\"const\": 0}, {\"const\": 1}\n"
    "              ]\n"
    "            }\n"
    "          }\n"
    "        },\n"
    "        {\n"
    "          \"type\": \"object\", \"minProperties\": 1, \"additionalProperties\": false,\n"
    "          \"properties\": {\n"
    "            \"translation\": {\"$ref\": \"#/$defs/vector\"},\n"
    "            \"rotation\": {\"description\": \"Radians about x, then y, then z.\", \"$ref\": "
    "\"#/$defs/vector\"},\n"
    "            \"scale\": {\"$ref\": \"#/$defs/vector\"},\n"
    "            \"shear\": {\"$ref\": \"#/$defs/vector\"}\n"
    "          }\n"
    "        }\n"
    "      ]\n"
    "    },\n"
    "    \"wave\": {\n"
    "      \"anyOf\": [\n"
    "        {\"type\": \"null\"},\n"
    "        {\"$ref\": \"#/$defs/waveName\"},\n"
    "        {\n"
    "          \"type\": \"object\", \"required\": [\"wave\"], \"additionalProperties\": false,\n"
    "          \"properties\": {\"wave\": {\"$ref\": \"#/$defs/waveName\"}}\n"
    "        },\n"
    "        {\n"
    "          \"type\": \"object\", \"required\": [\"wave\"], \"additionalProperties\": false,\n"
    "          \"properties\": {\n"
    "            \"wave\": {\"const\": \"Chain\"},\n"
    "            \"first\": {\"$ref\": \"#/$defs/wave\"},\n"
    "            \"factor\": {\"$ref\": \"#/$defs/number\", \"default\": 1},\n"
    "            \"shift\": {\"$ref\": \"#/$defs/number\", \"default\": 0},\n"
    "            \"second\": {\"$ref\": \"#/$defs/wave\"}\n"
    "          }\n"
    "        }\n"
    "      ]\n"
    "    },\n";

/* Appends a name to a JSON list. */
static void put_name(Text *out, const char *name, int *count)
{
    text_put(out, (*count)++ ? ", " : "");
    json_string(out, name);
}

static void put_color(Text *out)
{
    int count = 0;
    text_put(out, "    \"color\": {\n      \"description\": \"#rgb, #rrggbb, #rrggbbaa, or a name; "
                  "srgb(...) or linear(...) of "
                  "one.\",\n      \"anyOf\": [\n        {\"enum\": [");
    for (int i = 0; i < color_count; i++)
        put_name(out, color_table[i].name, &count);
    text_put(out,
             "]},\n        {\"type\": \"string\","
             " \"pattern\": \"^#([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6}|[0-9A-Fa-f]{8})$\"},\n        "
             "{\"type\": \"string\", "
             "\"pattern\": \"^(srgb|linear)\\\\((#([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6}|[0-9A-Fa-f]{8})");
    for (int i = 0; i < color_count; i++)
        text_format(out, "|%s", color_table[i].name);
    text_put(out, ")\\\\)$\"}\n      ]\n    },\n");
}

/* Writes "wordChannel": { all keywords of the list, or null } */
static void put_words(Text *out)
{
    for (int i = 0; i < WORD_COUNT; i++) {
        bool first = !i || keyword_table[i - 1].list != keyword_table[i].list;
        bool last = i + 1 == WORD_COUNT || keyword_table[i + 1].list != keyword_table[i].list;
        if (first)
            text_format(out, "    \"%s\": {\"enum\": [null%s",
                        describe_word_list(keyword_table[i].list),
                        word_of_truth(keyword_table[i].list, true) < 0 ? "" : ", false, true");
        text_format(out, ", \"%s\"%s", keyword_table[i].name, last ? "]},\n" : "");
    }
}

/* Writes an alternative per name, since only then can each name have a description. */
static void put_waves(Text *out)
{
    text_put(out, "    \"waveName\": {\n      \"oneOf\": [\n");
    for (int i = 0; i < WAVE_COUNT; i++) {
        text_format(out, "        {\"const\": \"%s\", \"description\": ", wave_table[i].name);
        json_string(out, wave_table[i].doc);
        text_put(out, "},\n");
    }
    text_put(out, "        {\"const\": \"Chain\", \"description\": ");
    json_string(out, CHAIN_DOC);
    text_put(out, "}\n      ]\n    },\n");
}

static bool has_preset(Kind kind)
{
    for (int i = 0; i < preset_count; i++)
        if (preset_table[i].kind == kind)
            return true;
    return false;
}

/* Writes "map": { all names of the kind } */
static void put_kind_names(Text *out, Kind kind)
{
    int count = 0;
    bool material = kind_table[kind].lowering == LOWERING_MATERIAL, more = has_preset(kind);
    for (int i = 0; i < alias_count; i++)
        more |= alias_table[i].kind == kind;
    text_format(out, "        \"%s\": {\"%s", material ? "material" : "map",
                more ? "enum\": [" : "const\": ");
    put_name(out, kind_table[kind].name, &count);
    for (int i = 0; i < alias_count; i++)
        if (alias_table[i].kind == kind)
            put_name(out, alias_table[i].alias, &count);
    for (int i = 0; i < preset_count; i++)
        if (preset_table[i].kind == kind && describe_is_preset_head(i))
            put_name(out, preset_table[i].name, &count);
    text_put(out, more ? "], \"description\": " : ", \"description\": ");
    json_string(out, kind_table[kind].doc);
    text_char(out, '}');
}

static void put_param(Text *out, const ParamRow *param)
{
    text_format(out, ",\n        \"%s\": {", param->name);
    describe_value(out, param);
    text_put(out, ", \"description\": ");
    json_string(out, param->doc);
    text_char(out, '}');
}

static void open_kind(Text *out, Kind kind, const char *suffix)
{
    bool material = kind_table[kind].lowering == LOWERING_MATERIAL;
    text_format(out, "    \"%s%s\": {\n      \"description\": ", kind_table[kind].name, suffix);
    json_string(out, kind_table[kind].doc);
    text_format(
        out,
        ",\n      \"type\": \"object\", \"required\": [\"%s\"], \"additionalProperties\": false,\n"
        "      \"properties\": {\n",
        material ? "material" : "map");
    put_kind_names(out, kind);
}

static void put_kind(Text *out, Kind kind)
{
    const KindRow *row = &kind_table[kind];
    open_kind(out, kind, "");
    for (int i = row->first; i < row->first + row->count; i++)
        put_param(out, &param_table[i]);
    text_put(out, "\n      }\n    },\n");
}

/* Writes a material at the top level: its parameters, and the other top-level keys. */
static void put_document(Text *out, Kind kind)
{
    const KindRow *row = &kind_table[kind];
    open_kind(out, kind, "Document");
    for (int i = row->first; i < row->first + row->count; i++)
        text_format(out, ",\n        \"%s\": {\"$ref\": \"#/$defs/%s/properties/%s\"}",
                    param_table[i].name, row->name, param_table[i].name);
    text_put(out, ",\n" BESIDE "\n      }\n    },\n");
}

/* Writes "name": any of the kinds of one group, or a reference; `more` are further alternatives. */
static void put_choice(Text *out, const char *name, bool material, const char *more)
{
    text_format(out,
                "    \"%s\": {\n      \"anyOf\": [\n%s        {\"$ref\": \"#/$defs/ref\"},\n"
                "        {\"type\": \"object\", \"required\": [\"%s\"], \"oneOf\": [",
                name, more, material ? "material" : "map");
    const char *comma = "";
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if ((kind_table[kind].lowering == LOWERING_MATERIAL) == material) {
            text_format(out, "%s\n          {\"$ref\": \"#/$defs/%s\"}", comma,
                        kind_table[kind].name);
            comma = ",";
        }
    text_put(out, "\n        ]}\n      ]\n    },\n");
}

static void put_top(Text *out)
{
    text_put(out, "  \"anyOf\": [\n    {\"$ref\": \"#/$defs/materialsDocument\"},\n    {\"$ref\": "
                  "\"#/$defs/definitions\"},\n    {\"$ref\": \"#/$defs/refDocument\"}");
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (kind_table[kind].lowering == LOWERING_MATERIAL)
            text_format(out, ",\n    {\"$ref\": \"#/$defs/%sDocument\"}", kind_table[kind].name);
    text_put(out, "\n  ],\n");
}

static void put_outermost(Text *out)
{
    describe_open_key(out, "defs", DOCUMENT_KEY_defs);
    text_put(out, "      \"type\": [\"object\", \"null\"],\n"
                  "      \"additionalProperties\": {\"anyOf\": [{\"$ref\": \"#/$defs/map\"}, "
                  "{\"$ref\": \"#/$defs/material\"}, "
                  "{\"$ref\": \"#/$defs/definition\"}]}\n"
                  "    },\n"
                  "    \"sceneDefs\": {\n"
                  "      \"description\": \"Maps and materials to refer to by `ref:`; and, of a "
                  "scene, objects for "
                  "Instances.\",\n"
                  "      \"type\": [\"object\", \"null\"],\n"
                  "      \"additionalProperties\": {\"anyOf\": [{\"$ref\": \"#/$defs/map\"}, "
                  "{\"$ref\": \"#/$defs/material\"}, "
                  "{\"$ref\": \"#/$defs/definition\"}, {\"$ref\": \"#/$defs/scene_object\"}]}\n"
                  "    },\n");
    describe_open_key(out, "include", DOCUMENT_KEY_include);
    text_put(out, "      \"anyOf\": [{\"type\": \"string\"}, {\"type\": \"array\", \"items\": "
                  "{\"type\": \"string\"}}]\n    },\n");
    describe_open_key(out, "colors", DOCUMENT_KEY_colors);
    text_put(out,
             "      \"enum\": [\"linear\", \"srgb\", null], \"default\": \"linear\"\n"
             "    },\n"
             "    \"definitions\": {\n"
             "      \"description\": \"Definitions alone, for other documents to include; or a "
             "scene.\",\n"
             "      \"type\": \"object\", \"additionalProperties\": false, \"minProperties\": 1,\n"
             "      \"not\": {\"required\": [\"colors\"], \"maxProperties\": 1},\n"
             "      \"properties\": {\n"
             "        \"defs\": {\"$ref\": \"#/$defs/sceneDefs\"},\n"
             "        \"include\": {\"$ref\": \"#/$defs/include\"},\n"
             "        \"colors\": {\"$ref\": \"#/$defs/colors\"}");
    describe_scene_keys(out);
    text_put(out, "\n      }\n    },\n");
}

static void put_materials_document(Text *out)
{
    describe_open_key(out, "materialsDocument", DOCUMENT_KEY_materials);
    text_format(out,
                "      \"type\": \"object\", \"required\": [\"materials\"], "
                "\"additionalProperties\": false,\n"
                "      \"properties\": {\n"
                "        \"materials\": {\n"
                "          \"description\": \"A material a name.\",\n"
                "          \"type\": \"object\", \"minProperties\": 1, \"additionalProperties\": "
                "{\"$ref\": "
                "\"#/$defs/material\"},\n"
                "          \"propertyNames\": {\"pattern\": \"^[A-Za-z][A-Za-z0-9_.-]*$\", "
                "\"maxLength\": %d}\n"
                "        },\n"
                "        \"defs\": {\"$ref\": \"#/$defs/sceneDefs\"},\n"
                "        \"include\": {\"$ref\": \"#/$defs/include\"},\n"
                "        \"colors\": {\"$ref\": \"#/$defs/colors\"}",
                LIMIT_NAME);
    describe_scene_keys(out);
    text_put(out, "\n      }\n    }\n");
}

void describe_beside(Text *out) { text_put(out, BESIDE); }

char *describe_document_schema(const char *ref, const char *document)
{
    static const char any_value[] =
        "        {\"type\": \"null\"},\n        {\"$ref\": \"#/$defs/constant\"},\n        "
        "{\"$ref\": \"#/$defs/param\"},\n        {\"$ref\": \"#/$defs/shorthand\"},\n";
    Arena arena = {0};
    Text out = text_new(&arena);
    text_put(&out, "{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n"
                   "  \"title\": \"matc " MATC_VERSION " document\",\n"
                   "  \"description\": \"Materials for matc, in YAML or JSON.\",\n");
    put_top(&out);
    text_put(&out, "  \"$defs\": {\n");
    text_put(&out, parameter_definitions);
    describe_open_key(&out, "definition", DOCUMENT_KEY_params);
    text_put(&out, definition_properties);
    if (ref) {
        text_format(&out, "    \"ref\": %s,\n", ref);
    } else {
        describe_open_key(&out, "ref", DOCUMENT_KEY_ref);
        text_put(&out, any_ref);
    }
    text_format(&out, "    \"refDocument\": %s,\n", document ? document : any_ref_document);
    describe_open_key(&out, "param", DOCUMENT_KEY_param);
    text_format(&out, fixed_definitions, LIMIT_NAME);
    text_put(&out, "    \"constantOrParam\": {\"anyOf\": [{\"$ref\": \"#/$defs/constant\"}, "
                   "{\"$ref\": \"#/$defs/param\"}]},\n");
    describe_formula_schema(&out);
    put_color(&out);
    put_waves(&out);
    put_words(&out);
    put_choice(&out, "map", false, any_value);
    put_choice(&out, "material", true, "");
    put_choice(&out, "anyMaterial", true, "        {\"type\": \"null\"},\n");
    for (int kind = 0; kind < KIND_COUNT; kind++)
        put_kind(&out, (Kind)kind);
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (kind_table[kind].lowering == LOWERING_MATERIAL)
            put_document(&out, (Kind)kind);
    describe_scene_definitions(&out);
    put_outermost(&out);
    put_materials_document(&out);
    text_put(&out, "  }\n}\n");
    return describe_finish(&out);
}

char *matc_schema(const char *of)
{
    return !of || !strcmp(of, "document") ? describe_document_schema(NULL, NULL)
                                          : describe_file(of);
}
