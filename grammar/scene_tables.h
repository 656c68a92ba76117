/* Tables of scenes: sorts, their kinds, and the parameters of each kind. */
#ifndef MATC_SCENE_TABLES_H
#define MATC_SCENE_TABLES_H
#include "tables.h"

typedef enum {
#define SCENE_SORT(name, doc) SCENE_SORT_##name,
#include "scene.def"
    SCENE_SORT_COUNT
} SceneSort;
typedef enum {
#define SCENE_KIND(sort, name, doc) SCENE_##name,
#include "scene.def"
    SCENE_KIND_COUNT
} SceneKind;
/* One index over all; S_Sphere_radius is that of the sphere's radius. */
enum {
#define SCENE_PARAM(kind, name, type, init, range, unit, doc) S_##kind##_##name,
#define SCENE_PART(kind, name, sort, number, doc)             S_##kind##_##name,
#include "scene.def"
    SCENE_PARAM_COUNT
};
enum { SCENE_KIND_PARAMS = 32 }; /* of a kind, at most */
typedef enum {
    SCENE_VALUE_plain,    /* numbers, truth values and transformations: as `param` says */
    SCENE_VALUE_material, /* one */
    SCENE_VALUE_file,     /* a path */
    SCENE_VALUE_name,     /* of a definition */
    SCENE_VALUE_one,      /* a thing of the sort `of` */
    SCENE_VALUE_list,     /* things of it */
} SceneValueKind;
typedef struct {
    const char *name, *doc;
} SceneSortRow;
typedef struct {
    const char *name, *doc;
    SceneSort sort;
    int first, count; /* its run in scene_param_table */
} SceneKindRow;
typedef struct {
    SceneKind kind; /* whose */
    SceneValueKind value;
    SceneSort of;
    ParamRow param; /* name, default, range, line; its kind is KIND_COUNT */
    const char *unit;
} SceneParamRow;
/* Value of a plain parameter if the parameter `key` of the same kind has a word. */
typedef struct {
    int key;
    Word word;
    int param;
    double value;
} ScenePresetRow;
extern const ScenePresetRow scene_preset_table[];
extern const int scene_preset_count;
extern const SceneSortRow scene_sort_table[SCENE_SORT_COUNT];
extern const SceneKindRow scene_kind_table[SCENE_KIND_COUNT];
extern const SceneParamRow scene_param_table[SCENE_PARAM_COUNT];
/* The kind of that name of a sort, or -1. */
int scene_kind_find(SceneSort sort, const char *name);
/* The kind of a sort that has but one, else -1. */
int scene_kind_only(SceneSort sort);
#endif
