/* Writes the schema of parameters' values in documents. */
#include "compiler/base/json_write.h"
#include "compiler/describe/describe.h"
#include <math.h>

static const char *const word_list_names[PARAM_KIND_COUNT] = {
#define WORDS(list) [PARAM_##list] = "word" #list,
#include "grammar/words.def"
};

const char *describe_word_list(ParamKind list) { return word_list_names[list]; }

static const char *definition_of(const ParamRow *param)
{
    static const char *const names[] = {
        [PARAM_Map] = "map",         [PARAM_Material] = "anyMaterial",
        [PARAM_Float] = "number",    [PARAM_Int] = "whole",
        [PARAM_Bool] = "bool",       [PARAM_Vec3] = "vector",
        [PARAM_Wave] = "wave",       [PARAM_Image] = "file",
        [PARAM_Items] = "items",     [PARAM_Transform] = "transform",
        [PARAM_Formula] = "formula", [PARAM_Maps] = "maps",
        [PARAM_List] = "mapList",
    };
    return param_is_word(param)           ? describe_word_list(param->type)
           : param->kind == KIND_Constant ? "constantOrParam"
                                          : names[param->type];
}

static void put_limits(Text *out, const ParamRow *param)
{
    text_put(out, ", \"minimum\": ");
    text_plain(out, param->low);
    text_put(out, ", \"maximum\": ");
    text_plain(out, param->high);
}

void describe_open_key(Text *out, const char *name, DocumentKey key)
{
    text_format(out, "    \"%s\": {\n      \"description\": ", name);
    json_string(out, key_table[key].doc);
    text_put(out, ",\n");
}

void describe_value(Text *out, const ParamRow *param)
{
    text_format(out, "\"$ref\": \"#/$defs/%s\"", definition_of(param));
    if (param->kind != KIND_COUNT && param_is_number((int)(param - param_table)))
        text_put(out, ", \"not\": {\"type\": \"array\"}");
    if (isfinite(param->low)) {
        put_limits(out, param);
        text_put(out, ", \"properties\": {\"default\": {\"type\": \"number\"");
        put_limits(out, param);
        text_put(out, "}}");
    }
    if (param->components) {
        text_put(out, param_is_word(param) ? ", \"default\": \"" : ", \"default\": ");
        describe_default(out, param, NULL);
        text_put(out, param_is_word(param) ? "\"" : "");
    }
}
