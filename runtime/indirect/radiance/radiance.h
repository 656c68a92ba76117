/* Radiance cache: light that surfaces reflect diffusely, stored by voxel for hits that are not
 * on screen. A voxel crossed by opaque surfaces has up to six nodes, one for each side from
 * which the surface is visible along an axis, by parallel rays through the voxels' centers. If a
 * voxel holds several surfaces, a node stores the nearest. Nodes are found by voxel:
 *
 *     buffer faces  four words; then for each voxel, x first, the number of its first node times
 *                   64, and a bit for each side that has a node
 *     buffer nodes  for each node: the voxel times 8 plus the side, with flags (stored; of a
 *                   closed mesh); its depth; the words that its material packs for the G-buffer,
 *                   with normals in world space
 *     buffer light  for each node texels of four floats: the direct light that it reflects, and
 *                   its normal in 24 bits, or -1 if it lies within a closed mesh or is cut away;
 *                   light of further bounces, and the distance of its plane from the grid's
 *                   corner. With several bounces also: its diffuse albedo; light of one bounce
 *                   more
 *
 * Rebuilt when objects, materials or lights change; independent of the camera. */
#ifndef MATC_INDIRECT_RADIANCE_H
#define MATC_INDIRECT_RADIANCE_H
#include "gen/radiance_layout.h"
#include "runtime/frame_graph/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/frame_graph/renderer_options.h"

enum { RADIANCE_SIZE_MAX = 256, RADIANCE_SIDES = 6 };

struct FrameRadiance {
    Material *keepers; /* indexed by surface kind of the GPU scene: a program that writes nodes */
    int keeper_count;
    unsigned char *casts; /* indexed by place of the GPU scene: a RadianceCast */
    Material number;      /* program that numbers the nodes of each voxel */
    /* Passes over nodes: direct light that they reflect; light of further bounces. */
    ScreenPass light, bounce;
    GLuint faces, nodes, kept;       /* GL buffers of the cache */
    GLuint faces_words, kept_texels; /* buffer textures of `faces` and `kept`, for rays */
    GLuint framebuffer;
    /* Voxels along an edge: the map's size, at most RADIANCE_SIZE_MAX, halved until the nodes
     * fit into the buffers. */
    int size;
    GLuint capacity; /* capacity of the buffers in nodes */
    GLuint count;
    bool drawn; /* the buffers hold the current scene */
};

/* How a place of the GPU scene is drawn: both sides; front faces only, since the mesh is closed;
 * front faces of a closed mesh that fills voxels. */
typedef enum { RADIANCE_surface, RADIANCE_closed, RADIANCE_body, RADIANCE_CASTS } RadianceCast;

/* Reports whether rays read the radiance cache: they trace voxels and look for light. */
bool radiance_needed(const Renderer *renderer);
/* Makes programs and buffers. radiance.c */
bool radiance_make(Renderer *renderer);
/* Allocates buffers for a number of nodes. False if the driver's limits forbid that size. */
bool radiance_make_capacity(Renderer *renderer, GLuint nodes);
/* Fills `casts`; call after objects have moved. */
void radiance_sort(Renderer *renderer);
/* Returns the texels per node in the buffer light. */
int radiance_texels(const Renderer *renderer);
void radiance_delete(Renderer *renderer);
/* Inputs of a pass with radiance.glsl in its text: definitions; uniforms, with two texture units
 * from `unit` on; binding of these units before a run. */
enum { RADIANCE_UNITS = 2, RADIANCE_DEFINITIONS = 128 };
void radiance_define(const Renderer *renderer, char text[RADIANCE_DEFINITIONS]);
void radiance_set(const Renderer *renderer, int unit, ScreenPass *pass);
void radiance_bind(const Renderer *renderer, int unit);
/* Writes a line for --stats. */
void radiance_put(Text *out, const Renderer *renderer);
/* Sets a uniform of an object's material. */
bool radiance_param(Renderer *renderer, int material, const MaterialValue *value);
/* Reports whether emission depends on the time. */
bool radiance_by_time(const Renderer *renderer);

/* The rows of the frame graph. */
extern const FramePass pass_radiance;
#endif
