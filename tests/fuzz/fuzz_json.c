/* libFuzzer's entry for strict JSON: any bytes as a .json file. cJSON must read every text that
 * our reader accepts, with equal values. Exempt are numbers of more than 63 characters and texts
 * with a zero byte, which cJSON cannot read. The reverse is not required: cJSON accepts `01` and
 * control characters (tests/compiler/base/test_json.c). */
#include "fuzz.h"
#include "tests/read_text.h"
#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CJSON_NUMBER = 63 };

static bool long_number(const Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return tree->plain && tree->count > CJSON_NUMBER;
    for (uint32_t i = 0; i < tree->count; i++)
        if (long_number(tree->kind == TREE_list ? tree->items[i] : tree->members[i].value))
            return true;
    return false;
}

static bool same_word(const Tree *tree, const cJSON *json)
{
    double number;
    if (cJSON_IsNumber(json))
        return tree_number(tree, &number) && number == json->valuedouble;
    return !strcmp(tree->text, cJSON_IsTrue(json)    ? "true"
                               : cJSON_IsFalse(json) ? "false"
                                                     : "null");
}

static bool same(const Tree *tree, const cJSON *json)
{
    if (tree->kind == TREE_scalar)
        return tree->plain ? same_word(tree, json)
                           : cJSON_IsString(json) && !strcmp(tree->text, json->valuestring);
    if (tree->kind == TREE_list ? !cJSON_IsArray(json) : !cJSON_IsObject(json))
        return false;
    const cJSON *part = json->child;
    for (uint32_t i = 0; i < tree->count; i++, part = part->next) {
        const Tree *value = tree->kind == TREE_list ? tree->items[i] : tree->members[i].value;
        if (!part || (tree->kind == TREE_object && strcmp(tree->members[i].key, part->string) != 0))
            return false;
        if (!same(value, part))
            return false;
    }
    return !part;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    ReadText r;
    char *text = malloc(size + 1); /* exact size, so that a sanitizer detects reads past the zero */
    if (!text)
        abort();
    if (size)
        memcpy(text, bytes, size);
    text[size] = 0;
    read_text(&r, "fuzz.json", text, size);
    if (!r.tree && !r.session.diags.errors)
        abort();
    if (r.tree && !long_number(r.tree)) {
        cJSON *json = cJSON_ParseWithLengthOpts(text, size + 1, NULL, true);
        if (!json || !same(r.tree, json))
            abort();
        cJSON_Delete(json);
    }
    read_text_done(&r);
    free(text);
    return 0;
}
