/* Displacement on the GPU: patches (scene_patches.h) become triangles in a buffer, by transform
 * feedback or compute, once, or once per camera for view-dependent methods. Later passes draw
 * the result like any mesh, and need not know that it was displaced. */
#ifndef MATC_DISPLACE_DISPLACED_H
#define MATC_DISPLACE_DISPLACED_H
#include "runtime/gpu_material/material.h"
#include "runtime/gl/mesh.h"
#include "runtime/scene/scene_patches.h"

enum { DISPLACED_BUFFERS = 3 };

typedef struct {
    const ScenePatches *patches; /* patches of the scene's mesh */
    int mesh;
    bool volume; /* the material replaces the surface by a volume */
    const struct DisplacedMethod *method;
    void *own;          /* private state of the method */
    Material material;  /* program that writes displaced points */
    bool written, anew; /* triangles exist; the last displaced_write() changed them */
    /* parts of each patch's edges as written, from scene_patches_levels() */
    uint8_t (*parts)[3];
    GLuint buffers[DISPLACED_BUFFERS]; /* rows, patches, and drawn patches: displace_point.glsl */
    GLuint array;                      /* vertex array without attributes */
    /* A draw needs a framebuffer although nothing is rasterized, and a context may have none of
     * its own. */
    GLuint framebuffer, pixel;
    /* Bytes of the mesh's buffers of rows and indices, which are reused as long as they suffice. */
    size_t capacity[2];
    size_t numbered; /* number of leading indices that are 0, 1, 2 ... */
    int points;      /* number of written points */
} Displaced;

/* The view for which triangles are written. */
typedef struct {
    const Scene *scene; /* scene whose camera and lights are read */
    int size[2];        /* width and height of the picture in pixels */
    /* Bounding box of all shadow receivers; low >= high: unbounded. */
    double low[3], high[3];
    /* View frustums of the picture, if only shadow maps need triangles outside; no planes: all
     * triangles are needed. */
    SceneFrustums sight;
} DisplacedView;

/* Returns whether the driver supports the method: OpenGL 4.5, with storage buffers in the
 * method's stages. */
bool displaced_supported(const GlContext *gl, Keyword method);
/* Makes programs and buffers for a scene mesh with patches; of the mesh only its arrays exist so
 * far. False: failed, see the context's error; *made is empty. */
bool displaced_make(Store *store, const Scene *scene, const MatcOptions *compile, int mesh,
                    Displaced *made);
/* Writes the triangles for a view, unless they are up to date. False: failed, see the context's
 * error. */
bool displaced_write(Displaced *displaced, const DisplacedView *view, Mesh *mesh);
/* Returns whether the method exists, and its triangles depend on the camera. */
bool displaced_by_view(const Displaced *displaced);
/* Returns whether the method exists, and its triangles depend on lights that cast shadows. */
bool displaced_by_lights(const Displaced *displaced);
/* Reads the last written triangles. False: failed, see the context's error; *made is empty. */
bool displaced_read(const Displaced *displaced, const Mesh *mesh, Shape *made);
/* Deletes all resources and zeroes the struct; also valid for a zeroed struct. */
void displaced_delete(Displaced *displaced);
#endif
