/* Voxel grids of scenes, for tests. */
#ifndef MATC_FRAME_VOXELS_H
#define MATC_FRAME_VOXELS_H
#include "runtime/frame_graph/frame.h"

/* Objects, as lines of a document's list: closed meshes, disjoint, one of them mirrored; */
#define FRAME_VOXELS_BODIES                                                                        \
    "- { object: Sphere, detail: 24, material: m, transform: { translation: [0, 0, 1.013] } }\n"   \
    "- { object: Box, material: m, size: [1, 1, .5], transform: { translation: [1.3, .8, .25], "   \
    "rotation: [.2, .3, "                                                                          \
    ".4] } }\n"                                                                                    \
    "- { object: Box, material: m, size: [.6, .5, .6], transform: { translation: [1.3, -1.2, "     \
    ".4], rotation: [.5, .3, "                                                                     \
    ".4], scale: [-1, 1, 1] } }\n"                                                                 \
    "- { object: Cone, detail: 17, material: m, transform: { translation: [-1.3, -.6, 0], "        \
    "rotation: [0, .3, 0] } }\n"                                                                   \
    "- { object: Cylinder, detail: 13, material: m, transform: { translation: [-1.1, .9, .3], "    \
    "rotation: [1, .3, 0] } "                                                                      \
    "}\n"
/* sheets along the axes, and one oblique to all axes. */
#define FRAME_VOXELS_SHEETS                                                                        \
    "- { object: Parallelogram, material: m, u: [4, 0, 0], v: [0, 4, 0], transform: { "            \
    "translation: [-2, -2, -.0213] "                                                               \
    "} }\n"                                                                                        \
    "- { object: Parallelogram, material: m, u: [0, 1.5, 0], v: [0, 0, 1], transform: { "          \
    "translation: [-1.617, .2, "                                                                   \
    ".1] } }\n"                                                                                    \
    "- { object: Parallelogram, material: m, u: [.5, 1.5, .3], v: [.4, -.2, 1], transform: { "     \
    "translation: [.9, -1.4, "                                                                     \
    ".3] } }\n"
/* Small triangles: two objects of one mesh, the second mirrored. */
#define FRAME_VOXELS_FINE                                                                          \
    "- { object: Sphere, detail: 32, material: m, transform: { translation: [.2, 0, 1.013] } }\n"  \
    "- { object: Sphere, detail: 32, material: m, transform: { translation: [1.3, -1.2, .4], "     \
    "rotation: [.5, .3, .4], "                                                                     \
    "scale: [-.6, .3, .5] } }\n"

/* A scene drawn once with the view voxels. */
typedef struct {
    GlContext *gl;
    MatcDocument *document;
    Scene *scene;
    Renderer *renderer;
    uint32_t *words; /* finest level: columns of size / 32 words */
    int size;
} FrameVoxelsDrawn;

FrameVoxelsDrawn frame_voxels_drawn(const char *objects, int size);
void frame_voxels_forget(FrameVoxelsDrawn *drawn);
/* Words of the columns of a level. From malloc. */
uint32_t *frame_voxels_level(const FrameVoxelsDrawn *drawn, int level);
bool frame_voxels_bit(const FrameVoxelsDrawn *drawn, const int at[3]);
#endif
