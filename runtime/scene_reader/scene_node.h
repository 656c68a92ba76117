/* A node of a scene's document, read by its rows of scene.def: its kind, and the values of its
 * keys. */
#ifndef MATC_SCENE_NODE_H
#define MATC_SCENE_NODE_H
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "compiler/base/names.h"
#include "compiler/resolve/resolve.h"
#include "runtime/scene/scene.h"

/* Meshes of a file, consecutive in scene->meshes. `why` is the reason why the file could not be
 * read; NULL: it was read. */
typedef struct {
    int first, count;
    const char *why;
} SceneMeshFile;
typedef struct {
    Names paths;
    SceneMeshFile *at; /* array of files, parallel to `paths` */
    size_t count, capacity;
} SceneMeshFiles;

/* State of reading a scene. */
typedef struct {
    Session *session;  /* the document's session, which owns all memory */
    Resolver resolver; /* resolves numbers and maps */
    MatcDocument *document;
    Scene *scene;
    const Tree *named; /* the document's `materials:`; NULL: missing */
    Member *materials; /* members of `materials:`, then inline materials */
    size_t named_count, material_count, material_capacity;
    size_t inline_number;    /* number in the next inline material's name */
    HashIndex inlines, used; /* index of the trees of inline materials; index of scene->materials */
    size_t object_capacity, root_capacity, light_storage, used_capacity, mesh_capacity,
        document_capacity;
    SceneMeshFiles mesh_files[2]; /* files read as a single mesh; files split by material */
    Names document_paths;         /* paths of scene->documents */
    Span *origins;                /* indexed by object of the scene: its place in the document */
    size_t origin_count, origin_capacity;
    int *planes; /* indices of objects that are planes */
    size_t plane_count, plane_capacity;
    const Tree *definitions; /* the document's `defs:`; NULL if missing */
    bool *instanced;         /* indexed by definition: the definition is used */
    /* The current objects do not enter the scene: their materials and planes do not count. */
    bool aside;
    SceneMaterial *asides; /* materials of the objects outside the scene; element 0 is unused */
    size_t aside_count, aside_capacity;
    HashIndex aside_used;      /* index of `asides` */
    struct SceneStand *stands; /* surfaces with copies, in the order of their objects */
    size_t stand_count, stand_capacity;
    int objects;      /* number of objects and groups so far */
    HashIndex solids; /* index of solid_keys: objects with equal keys share a mesh */
    Key *solid_keys;
    size_t solid_count, solid_capacity;
    int64_t triangles;         /* number of triangles of all different meshes, solids included */
    int64_t surface_triangles; /* number of triangles of all surfaces with copies */
    bool fine;                 /* no error has been reported so far */
} SceneReader;

/* A read node. Parameters are named by their index in scene_param_table, such as
 * S_Sphere_radius. */
typedef struct {
    SceneKind kind;
    const Tree *tree;                /* NULL: missing in the document, all values are defaults */
    Value values[SCENE_KIND_PARAMS]; /* values of the kind's plain parameters */
    Tree *given[SCENE_KIND_PARAMS];  /* other parameters, as trees; NULL: not given */
} SceneNodeDesc;

/* Reads a node of a sort. Returns false after errors were reported. */
bool scene_node_read(SceneReader *r, Tree *tree, SceneSort sort, SceneNodeDesc *desc);
/* Reads the document itself, as the kind Scene; keys of a document are allowed, too. */
bool scene_node_read_document(SceneReader *r, Tree *tree, SceneNodeDesc *desc);
/* Sets a missing part to its default: the first kind of its sort. */
void scene_node_default(SceneReader *r, SceneSort sort, SceneNodeDesc *desc);

/* Sets the parameters that are not given to the values that go with the word of the parameter
 * `key` (SCENE_PRESET). */
void scene_node_preset(SceneNodeDesc *desc, int key);

double scene_node_number(const SceneNodeDesc *desc, int param);
void scene_node_vector(const SceneNodeDesc *desc, int param, double vector[3]);
/* The next two return NULL if the parameter is not given. */
const Transform *scene_node_transform(const SceneNodeDesc *desc, int param);
Tree *scene_node_given(const SceneNodeDesc *desc, int param);
/* Returns a name; NULL if it is missing, or not a text, which is reported. */
const char *scene_node_name(SceneReader *r, const Tree *given);
/* Returns the span for errors of a parameter: its value, or the node. */
Span scene_node_span(const SceneNodeDesc *desc, int param);
#endif
