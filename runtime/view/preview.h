/* A material as a small scene: on a shape in three lamps and light from all around, before a glow,
 * or as the sky that it is. */
#ifndef MATC_VIEW_PREVIEW_H
#define MATC_VIEW_PREVIEW_H
#include "runtime/scene/scene.h"
#include "runtime/view/camera.h"

typedef struct {
    ShapeKind shape;
    const Shape *mesh;       /* instead of the shape; or NULL */
    const Viewpoint *camera; /* NULL: where the shape looks best */
    int width, height;       /* of the picture */
    bool sky;
} PreviewOptions;

enum { PREVIEW_LAMPS = 3 };

/* The scene, and what it is made of. */
typedef struct {
    Scene scene;
    SceneObject object;
    SceneLight lights[PREVIEW_LAMPS + 1];
    SceneMaterial material;
    SceneMesh mesh;
    bool owns_mesh; /* else it is the caller's */
} Preview;

/* The scene is there until preview_free, as are the material's document and the caller's mesh.
 * False: memory ran out. */
bool preview_make(const PreviewOptions *options, SceneMaterial material, const MatcOptions *compile,
                  Preview *made);
/* Safe on an empty one, which it leaves behind. */
void preview_free(Preview *preview);
#endif
