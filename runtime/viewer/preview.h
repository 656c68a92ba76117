/* Builds a small scene that previews a material: a shape under three lamps and hemisphere light
 * in front of a glow, or the sky for a sky material. */
#ifndef MATC_VIEWER_PREVIEW_H
#define MATC_VIEWER_PREVIEW_H
#include "runtime/scene/scene.h"
#include "runtime/viewer/camera.h"

typedef struct {
    ShapeKind shape;
    const Shape *mesh;       /* mesh that replaces the shape; NULL: none */
    const Viewpoint *camera; /* NULL: the shape's default viewpoint */
    int width, height;       /* size of the picture, in pixels */
    bool sky;
} PreviewOptions;

enum { PREVIEW_LAMPS = 3 };

/* The preview scene and the storage that its pointers refer to. */
typedef struct {
    Scene scene;
    SceneObject object;
    SceneLight lights[PREVIEW_LAMPS + 1];
    SceneMaterial material;
    SceneMesh mesh;
    bool owns_mesh; /* false: the mesh belongs to the caller */
} Preview;

/* Builds the preview scene, which is valid until preview_free. The material's document and the
 * caller's mesh must live as long. Returns false if memory runs out. */
bool preview_make(const PreviewOptions *options, SceneMaterial material, const MatcOptions *compile,
                  Preview *made);
/* Frees the scene and resets *preview to empty; safe on an empty preview. */
void preview_free(Preview *preview);
#endif
