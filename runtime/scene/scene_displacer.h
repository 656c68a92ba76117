/* State of a scene's displacement, shared by its files. */
#ifndef MATC_SCENE_DISPLACER_H
#define MATC_SCENE_DISPLACER_H
#include "runtime/scene/scene_detail.h"
#include "runtime/scene/scene_seen.h"

/* The mesh or solid that an object displaces. */
typedef struct {
    SceneKind kind; /* SCENE_Plane: not displaced */
    int mesh;       /* index of the mesh if kind is SCENE_Mesh */
} SceneBase;

/* A parameter of a material whose value differs from its document. */
typedef struct {
    int material;
    char *name;
    double components[4];
    int count;
} SceneDisplacedParam;

struct SceneDisplacer {
    MatcOptions options;
    Keyword method;     /* a KEYWORD_Displacing_... value, such as KEYWORD_Displacing_mesh */
    bool processor;     /* the GPU cannot displace */
    SceneViewSet seen;  /* cameras on which subdivision depends, if any */
    MatcMoves *moves;   /* what displacement depends on, indexed by material */
    SceneDetail detail; /* views on which detail depends, if any */
    SceneBall *balls;   /* bounding spheres of imported meshes */
    /* Indexed by material: max displacement, infinite if detail does not depend on the picture;
     * NULL: detail never does. */
    double *bounds;
    SceneBase *bases; /* shapes before displacement, indexed by object */
    Key *keys;        /* indexed by mesh of the scene: hash of its source */
    int *users;       /* indexed by mesh: number of objects that use the mesh */
    int first;        /* index of the first displaced mesh */
    int vacant;       /* every mesh before this index is used */
    SceneDisplacedParam *params;
    int param_count;
    int fault; /* index of the material to which `why` belongs */
    const char *why;
};
#endif
