/* A mesh that is displaced, as plain triangles. */
#ifndef MATC_SCENE_DISPLACEMENT_H
#define MATC_SCENE_DISPLACEMENT_H
#include "runtime/scene/scene_seen.h"

/* By which material, with whose options, where in the world, how it is divided, and to how many triangles at least. */
typedef struct {
    const MatcDocument *document;
    int material;
    const MatcOptions *options;
    SceneMatrix world_from_local;
    Word method; /* WORD_Displacing_mesh, ... */
    int triangles;
    const SceneSeen *seen; /* by whom, where triangles go by what is seen; or NULL */
    double pixels;         /* that an error may have then */
} SceneDisplacing;

/* False: memory ran out, or a value takes too many operations; *made is empty. */
bool scene_displaced_shape(const SceneDisplacing *how, const Shape *from, Shape *made);
#endif
