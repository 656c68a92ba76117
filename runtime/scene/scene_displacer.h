/* The state of a scene's displacement, shared by its files. */
#ifndef MATC_SCENE_DISPLACER_H
#define MATC_SCENE_DISPLACER_H
#include "runtime/scene/scene_detail.h"
#include "runtime/scene/scene_seen.h"

/* The part of an object that is displaced. */
typedef struct {
    SceneKind kind; /* SCENE_Plane: nothing is */
    int mesh;       /* of a Mesh */
} SceneBase;

/* A param of a material that has another value than its document says. */
typedef struct {
    int material;
    char *name;
    double lanes[4];
    int count;
} SceneDisplacedParam;

struct SceneDisplacer {
    MatcOptions options;
    Word method;        /* WORD_Displacing_mesh, ... */
    bool processor;     /* whoever draws cannot displace */
    SceneSeen seen;     /* where meshes go by that */
    MatcMoves *moves;   /* by material */
    SceneDetail detail; /* where that goes by the picture */
    SceneBall *balls;   /* of the meshes of files */
    double *
        /* by material: how far it moves points, infinite where detail does not go by the picture;
         * NULL: it does nowhere */
        bounds;
    SceneBase *bases; /* by object */
    Key *keys;        /* by mesh of the scene: what it was made of */
    int *users;       /* by mesh: so many objects have it */
    int first;        /* meshes that were displaced: from there on */
    int vacant;       /* none before it is free for another */
    SceneDisplacedParam *params;
    int param_count;
    int fault; /* the material of which `why` is */
    const char *why;
};
#endif
