/* One thing of a scene, by its rows of scene.def: its kind, and what its keys say. */
#ifndef MATC_SCENE_THING_H
#define MATC_SCENE_THING_H
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "compiler/base/names.h"
#include "compiler/resolve/resolve.h"
#include "runtime/scene/scene.h"

/* The meshes of a file lie side by side in scene->meshes. `why`: it cannot be read, and was tried
 * once. */
typedef struct {
    int first, count;
    const char *why;
} SceneMeshFile;
typedef struct {
    Names paths;
    SceneMeshFile *at; /* by path */
    size_t count, room;
} SceneMeshFiles;

/* State of reading a scene. */
typedef struct {
    Session *session;  /* of the document, as is all memory */
    Resolver resolver; /* of the numbers */
    MatcDocument *document;
    Scene *scene;
    const Tree *named; /* `materials:` of the document, or NULL */
    Member *materials; /* its members, then those that stand inline */
    size_t named_count, material_count, material_room;
    size_t inline_number;    /* of the next name */
    HashIndex inlines, used; /* the trees of those inline; places in scene->materials */
    size_t object_room, root_room, light_room, used_room, mesh_room, document_room;
    SceneMeshFiles mesh_files[2]; /* read as a whole; read in parts */
    Names document_paths;         /* of scene->documents */
    Span *origins;                /* by object of the scene: where it is written */
    size_t origin_count, origin_room;
    int *planes; /* those of the objects that are one */
    size_t plane_count, plane_room;
    const Tree *definitions; /* the document's `defs:`; NULL: there are none */
    bool *instanced;         /* by the place of a definition */
    /* what is read now is no part of the scene: it has no material in use, no plane to be seen */
    bool aside;
    SceneMaterial *asides; /* materials of it; the first is none */
    size_t aside_count, aside_room;
    HashIndex aside_used;      /* places in them */
    struct SceneStand *stands; /* copies that stand on surfaces, in the order of their objects */
    size_t stand_count, stand_room;
    int things;       /* objects and groups so far */
    HashIndex solids; /* solid_keys, by them: objects with one key are one mesh */
    Key *solid_keys;
    size_t solid_count, solid_room;
    int64_t triangles;         /* of these meshes */
    int64_t surface_triangles; /* of all surfaces that copies stand on */
    bool fine;                 /* no fault yet */
} SceneReader;

/* Params of scene_param_table are named by their place there: S_Sphere_radius. */
typedef struct {
    SceneKind kind;
    const Tree *tree;                /* NULL: it was not given, and all is default */
    Value values[SCENE_KIND_PARAMS]; /* of the kind's run: those that are plain */
    Tree *given[SCENE_KIND_PARAMS];  /* those that are not; NULL: not there */
} SceneThing;

/* A value of that sort. False: it has faults, which are told. */
bool scene_thing_read(SceneReader *r, Tree *tree, SceneSort sort, SceneThing *thing);
/* The document itself: as the kind Scene, but that it may have the keys of a document, too. */
bool scene_thing_read_document(SceneReader *r, Tree *tree, SceneThing *thing);
/* Default of a part that is not given: the first kind of its sort. */
void scene_thing_default(SceneReader *r, SceneSort sort, SceneThing *thing);

/* Sets the parameters that are not given to the values that go with the word of the parameter
 * `key` (SCENE_PRESET). */
void scene_thing_preset(SceneThing *thing, int key);

double scene_thing_number(const SceneThing *thing, int param);
void scene_thing_vector(const SceneThing *thing, int param, double vector[3]);
/* NULL: not given. */
const Transform *scene_thing_transform(const SceneThing *thing, int param);
Tree *scene_thing_given(const SceneThing *thing, int param);
/* A text that names something; NULL where it is not given, or is no text, which is reported. */
const char *scene_thing_name(SceneReader *r, const Tree *given);
/* Where a fault of a parameter is: at its value, or at the thing. */
Span scene_thing_span(const SceneThing *thing, int param);
#endif
