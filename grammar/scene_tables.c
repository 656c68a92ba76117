/* The rows of scene.def as const arrays. */
#include "scene_tables.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

#define PLAIN(sort)        .value = SCENE_VALUE_plain, .param.type = PARAM_##sort
#define VALUE_Float        PLAIN(Float)
#define VALUE_Int          PLAIN(Int)
#define VALUE_Bool         PLAIN(Bool)
#define VALUE_Vec3         PLAIN(Vec3)
#define VALUE_Shadows      PLAIN(Shadows)
#define VALUE_Volume       PLAIN(Volume)
#define VALUE_Displacing   PLAIN(Displacing)
#define VALUE_Skirts       PLAIN(Skirts)
#define VALUE_Symbol       PLAIN(Symbol)
#define VALUE_Path         PLAIN(Path)
#define VALUE_Indirect     PLAIN(Indirect)
#define VALUE_Weight       PLAIN(Weight)
#define VALUE_Distribution PLAIN(Distribution)
#define VALUE_Sequence     PLAIN(Sequence)
#define VALUE_Rotation     PLAIN(Rotation)
#define VALUE_Filter       PLAIN(Filter)
#define VALUE_Resolution   PLAIN(Resolution)
#define VALUE_Preset       PLAIN(Preset)
#define VALUE_Quality      PLAIN(Quality)
#define VALUE_March        PLAIN(March)
#define VALUE_Transform    PLAIN(Transform)
#define VALUE_Material     .value = SCENE_VALUE_material, .param.type = PARAM_Material
#define VALUE_File         .value = SCENE_VALUE_file, .param.type = PARAM_Image
#define VALUE_Name         .value = SCENE_VALUE_name, .param.type = PARAM_Image
#define PART_ONE           SCENE_VALUE_one
#define PART_LIST          SCENE_VALUE_list
#define NONE               .param.components = 0
#define D(x)               .param.components = 1, .param.init = {x}
#define D3(x, y, z)        .param.components = 3, .param.init = {x, y, z}
#define ANY                .param.low = -INFINITY, .param.high = INFINITY
#define RANGE(least, most) .param.low = least, .param.high = most
#define NAMED(of, text, line)                                                                      \
    .kind = SCENE_##of, .param.kind = KIND_COUNT, .param.name = #text, .param.doc = line

const SceneParamRow scene_param_table[SCENE_PARAM_COUNT] = {
#define SCENE_PARAM(kind, name, type, init, range, in, doc)                                        \
    {NAMED(kind, name, doc), VALUE_##type, init, range, .unit = in},
#define SCENE_PART(owner, name, sort, number, doc)                                                 \
    {NAMED(owner, name, doc), .value = PART_##number, .of = SCENE_SORT_##sort, .unit = ""},
#include "scene.def"
};

/* Index ranges of parameters and of kinds, as in tables.c. */
enum {
#define SCENE_KIND(sort, name, doc) FIRST_##name, RESET_##name = FIRST_##name - 1,

#define SCENE_PARAM(kind, name, type, init, range, in, doc) AT_##kind##_##name,
#define SCENE_PART(kind, name, sort, number, doc)           AT_##kind##_##name,
#include "scene.def"
};
enum {
    KINDS_BEGIN = -1 /* expands to `, COUNT_kind = 0 +1 +1 ...`, +1 per row */
#define SCENE_KIND(sort, name, doc)                         , COUNT_##name = 0
#define SCENE_PARAM(kind, name, type, init, range, in, doc) +1
#define SCENE_PART(kind, name, sort, number, doc)           +1
#include "scene.def"
};

#define SCENE_KIND(sort, name, doc)                                                                \
    _Static_assert((int)COUNT_##name <= (int)SCENE_KIND_PARAMS, #name " has too many rows");
#include "scene.def"

const SceneKindRow scene_kind_table[SCENE_KIND_COUNT] = {
#define SCENE_KIND(sort, name, doc) {#name, doc, SCENE_SORT_##sort, FIRST_##name, COUNT_##name},
#include "scene.def"
};

const SceneSortRow scene_sort_table[SCENE_SORT_COUNT] = {
#define SCENE_SORT(name, doc) {#name, doc},
#include "scene.def"
};

const ScenePresetRow scene_preset_table[] = {
#define SCENE_PRESET(kind, key, word, name, value)                                                 \
    {S_##kind##_##key, word, S_##kind##_##name, value},
#include "scene.def"
};
const int scene_preset_count = sizeof scene_preset_table / sizeof *scene_preset_table;

int scene_kind_find(SceneSort sort, const char *name)
{
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (scene_kind_table[kind].sort == sort && !strcmp(scene_kind_table[kind].name, name))
            return kind;
    return -1;
}

int scene_kind_only(SceneSort sort)
{
    int only = -1;
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (scene_kind_table[kind].sort == sort) {
            if (only >= 0)
                return -1;
            only = kind;
        }
    return only;
}
