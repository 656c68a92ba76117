/* Reads rows from the reflection's JSON. */
#include "facts.h"
#include <cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const fact_kinds[FACT_KINDS] = {"input", "output", "attribute", "texture",
                                            "block", "member", "uniform",   "system"};

const Fact *facts_find(const Facts *facts, FactKind kind, const char *name)
{
    for (int i = 0; i < facts->count; i++)
        if (facts->at[i].kind == kind && !strcmp(facts->at[i].name, name))
            return &facts->at[i];
    return NULL;
}

static Fact *next(Facts *facts, FactKind kind)
{
    if (facts->count == FACT_CAPACITY)
        abort();
    Fact *fact = &facts->at[facts->count++];
    *fact = (Fact){.kind = kind, .place = NO_PLACE};
    return fact;
}

static const char *text_of(const cJSON *object, const char *key)
{
    const cJSON *value = cJSON_GetObjectItemCaseSensitive(object, key);
    return cJSON_IsString(value) ? value->valuestring : "";
}

static int number_of(const cJSON *object, const char *key, int otherwise)
{
    const cJSON *value = cJSON_GetObjectItemCaseSensitive(object, key);
    return cJSON_IsNumber(value) ? value->valueint : otherwise;
}

static Fact *take(Facts *facts, FactKind kind, const cJSON *row, const char *place)
{
    Fact *fact = next(facts, kind);
    snprintf(fact->name, sizeof fact->name, "%s", text_of(row, "name"));
    snprintf(fact->type, sizeof fact->type, "%s", text_of(row, "type"));
    fact->place = place ? number_of(row, place, NO_PLACE) : NO_PLACE;
    return fact;
}

/* Adds a uniform, or a member of the block if the row has an offset. */
static void take_uniform(Facts *facts, const cJSON *row, const char *block)
{
    bool member = cJSON_HasObjectItem(row, "offset");
    Fact *fact = take(facts, member ? FACT_member : FACT_uniform, row, "offset");
    if (member)
        snprintf(fact->name, sizeof fact->name, "%.40s.%.80s", block, text_of(row, "name"));
}

static void take_block(Facts *facts, const cJSON *block, const char *name)
{
    if (!block)
        return;
    Fact *fact = take(facts, FACT_block, block, "binding");
    snprintf(fact->name, sizeof fact->name, "%s", text_of(block, name));
    fact->size = number_of(block, "size", 0);
}

static void take_input(Facts *facts, const cJSON *row)
{
    const char *source = text_of(row, "source");
    if (!strcmp(source, "varying"))
        take(facts, FACT_input, row, "location");
    else if (!strcmp(source, "system"))
        take(facts, FACT_system, row, NULL)->type[0] = 0;
    else
        take_uniform(facts, row, "Material");
}

static void take_output(Facts *facts, const cJSON *row)
{
    bool color = !strcmp(text_of(row, "kind"), "color");
    Fact *fact = next(facts, color ? FACT_output : FACT_system);
    const char *format = text_of(row, "format");
    if (!color) {
        snprintf(fact->name, sizeof fact->name, "%s",
                 !strcmp(text_of(row, "kind"), "depth") ? "gl_FragDepth" : "discard");
        return;
    }
    fact->place = number_of(row, "location", NO_PLACE);
    snprintf(fact->name, sizeof fact->name, "fragment%d", fact->place);
    snprintf(fact->type, sizeof fact->type, "%s", strstr(format, "UI") ? "uint" : "float");
}

static void take_constants(Facts *facts, const cJSON *constants, bool plain)
{
    const cJSON *row;
    if (!plain)
        take_block(facts, constants, "block");
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(constants, "members")) if (plain)
        take(facts, FACT_uniform, row, NULL);
    else take_uniform(facts, row, "Constants");
}

bool facts_of_reflection(const char *json, Facts *fragment, Facts *vertex)
{
    cJSON *root = cJSON_Parse(json);
    const cJSON *row, *shader = cJSON_GetObjectItem(root, "vertex");
    fragment->count = vertex->count = 0;
    if (!shader) {
        cJSON_Delete(root);
        return false;
    }
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "inputs")) take_input(fragment, row);
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "uniforms"))
        take_uniform(fragment, row, "Material");
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "textures"))
    {
        Facts *stage = cJSON_GetObjectItem(row, "stage") ? vertex : fragment;
        snprintf(take(stage, FACT_texture, row, "binding")->type, FACT_TEXT, "sampler2D");
    }
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(root, "outputs")) take_output(fragment, row);
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(shader, "attributes"))
        take(vertex, FACT_attribute, row, "location");
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(shader, "uniforms"))
        take_uniform(vertex, row, "Draw");
    take_block(fragment, cJSON_GetObjectItem(root, "block"), "name");
    take_constants(fragment, cJSON_GetObjectItem(root, "constants"),
                   !strcmp(text_of(root, "target"), "glsl110"));
    take_block(vertex, cJSON_GetObjectItem(shader, "block"), "name");
    cJSON_Delete(root);
    return true;
}
