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
/* Index over all parameters; S_Sphere_radius is the sphere's radius. */
enum {
#define SCENE_PARAM(kind, name, type, init, range, unit, doc) S_##kind##_##name,
#define SCENE_PART(kind, name, sort, number, doc)             S_##kind##_##name,
#include "scene.def"
    SCENE_PARAM_COUNT
};
enum { SCENE_KIND_PARAMS = 32 }; /* max parameters of a kind */
typedef enum {
    SCENE_VALUE_plain,    /* numbers, booleans and transforms: see `param` */
    SCENE_VALUE_material, /* a material */
    SCENE_VALUE_file,     /* the path of a file */
    SCENE_VALUE_name,     /* name of a definition */
    SCENE_VALUE_one,      /* a part of the sort `of` */
    SCENE_VALUE_list,     /* a list of parts of the sort `of` */
} SceneValueKind;
typedef struct {
    const char *name, *doc;
} SceneSortRow;
typedef struct {
    const char *name, *doc;
    SceneSort sort;
    int first, count; /* range of the kind's rows in scene_param_table */
} SceneKindRow;
typedef struct {
    SceneKind kind; /* the kind that has the parameter */
    SceneValueKind value;
    SceneSort of;
    ParamRow param; /* name, default, range, description; its kind is KIND_COUNT */
    const char *unit;
} SceneParamRow;
/* Default of a plain parameter if the parameter `key` of the same kind has a certain keyword. */
typedef struct {
    int key;
    Keyword word;
    int param;
    double value;
} ScenePresetRow;
extern const ScenePresetRow scene_preset_table[];
extern const int scene_preset_count;
extern const SceneSortRow scene_sort_table[SCENE_SORT_COUNT];
extern const SceneKindRow scene_kind_table[SCENE_KIND_COUNT];
extern const SceneParamRow scene_param_table[SCENE_PARAM_COUNT];
/* Returns the kind of a sort with that name; -1: none. */
int scene_kind_find(SceneSort sort, const char *name);
/* Returns the only kind of a sort; -1 if it has several. */
int scene_kind_only(SceneSort sort);
#endif
