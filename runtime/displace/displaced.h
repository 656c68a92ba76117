/* Meshes that the driver displaces: patches (scene_patches.h) become triangles in a buffer, by
 * transform feedback, once, or once for each camera that they go by. All that draws afterwards sees
 * a mesh like any other: no pass knows how it came about, or that it was displaced at all. */
#ifndef MATC_DISPLACE_DISPLACED_H
#define MATC_DISPLACE_DISPLACED_H
#include "runtime/draw/material.h"
#include "runtime/gl/mesh.h"
#include "runtime/scene/scene_patches.h"

enum { DISPLACED_BUFFERS = 3 };

typedef struct {
    const ScenePatches *patches; /* the scene's, of that mesh */
    int mesh;
    bool volume; /* the material puts a volume in the surface's place */
    const struct DisplacedMethod *method;
    void *own;          /* what the method keeps */
    Material material;  /* writes displaced points */
    bool written, anew; /* the last call of displaced_write had to */
    /* that were written: of each patch's edges, as scene_patches_levels has them */
    uint8_t (*parts)[3];
    GLuint buffers[DISPLACED_BUFFERS]; /* rows, patches, and which are drawn: displace_point.glsl */
    GLuint array;                      /* of no attributes */
    /* a draw wants one, though it gets nothing, and a context may have none of its own */
    GLuint framebuffer, pixel;
    /* bytes of the mesh's rows and indices, which stay there as long as they suffice */
    size_t room[2];
    size_t numbered; /* indices of the mesh that are 0, 1, 2 ... */
    int points;      /* that were written */
} Displaced;

/* By whom triangles are seen. */
typedef struct {
    const Scene *scene; /* its camera, and lights */
    int size[2];        /* pixels of the picture */
    /* of a box around all that shadows may fall on; low >= high: they fall anywhere */
    double low[3], high[3];
    /* what the picture shows, where nothing else asks for triangles but maps of shadows; of no
     * planes: all are wanted */
    SceneSight sight;
} DisplacedView;

/* The driver can: OpenGL 4.5, with buffers that its stages read. */
bool displaced_there(const GlContext *gl, Word method);
/* Makes programs and buffers of a mesh of the scene that has patches; of the mesh nothing yet but
 * its arrays. False: see the context's error; *made is empty. */
bool displaced_make(Store *store, const Scene *scene, const MatcOptions *compile, int mesh,
                    Displaced *made);
/* Writes the triangles for that view, where they are not those that are there. False: see the
 * context's error. */
bool displaced_write(Displaced *displaced, const DisplacedView *view, Mesh *mesh);
/* It exists, and its triangles depend on the camera. */
bool displaced_by_view(const Displaced *displaced);
/* It exists, and its triangles depend on lights that cast shadows. */
bool displaced_by_lights(const Displaced *displaced);
/* The triangles that were written last. False: see the context's error; *made is empty. */
bool displaced_read(const Displaced *displaced, const Mesh *mesh, Shape *made);
/* Safe on an empty one, which it leaves behind. */
void displaced_delete(Displaced *displaced);
#endif
