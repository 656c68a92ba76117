/* Cached radiance: light that surfaces send evenly, kept by voxel for what the picture does not
 * show. Of each voxel that something opaque crosses there is a node for each of six sides from
 * which it is seen in it, seen by parallel rays through the voxels' middles along an axis; of
 * several surfaces in one voxel the nearest. Nodes are found by voxel:
 *
 *     buffer faces  four words; then for each voxel, x first, the number of its first node times
 *                   64, and a bit for each side that has one
 *     buffer nodes  for each node the voxel times 8 and the side, whether it is kept, whether it is
 *                   of a body; how near it is; what its material packs for the G-buffer, normals
 *                   along the world's axes
 *     buffer light  for each node texels of four floats: the light of lamps that it sends, its
 *                   normal in 24 bits, or -1 where it lies within a body, or is cut away; light of
 *                   further bounces, how far its plane is from the grid's corner; where light
 *                   bounces on: the share of light from its surroundings that it sends; light of
 *                   one bounce more
 *
 * Made when objects, materials or lights are others; it does not know the camera. */
#ifndef MATC_INDIRECT_RADIANCE_H
#define MATC_INDIRECT_RADIANCE_H
#include "gen/radiance_layout.h"
#include "runtime/frame/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/frame/render_options.h"

enum { RADIANCE_SIZE_MOST = 256, RADIANCE_SIDES = 6 };

struct FrameRadiance {
    Material *keepers; /* by kind of the cache: its program, which ends in nodes */
    int keeper_count;
    unsigned char *casts; /* by place */
    Material number;      /* gives the nodes of a voxel their numbers */
    /* what lamps have nodes send; what these have each other send */
    ScreenPass light, bounce;
    GLuint faces, nodes, kept;       /* buffers */
    GLuint faces_words, kept_texels; /* the first and the last as rays read them */
    GLuint framebuffer;
    /* voxels along an edge: those of the map, or RADIANCE_SIZE_MOST; half as often as nodes do not
     * find room */
    int size;
    GLuint room; /* nodes that the buffers have room for */
    GLuint count;
    bool drawn; /* it holds the scene */
};

/* How a place of the cache is drawn: from both sides; its fronts alone, as it is closed; these, as
 * a body of the voxels. */
typedef enum { RADIANCE_surface, RADIANCE_closed, RADIANCE_body, RADIANCE_CASTS } RadianceCast;

/* Rays take it: through voxels, for light. */
bool radiance_needed(const Render *render);
/* Programs and buffers. radiance.c */
bool radiance_make(Render *render);
/* Room for so many nodes. False: there may not be so much. */
bool radiance_make_room(Render *render, GLuint nodes);
/* Fills casts: objects may have moved. */
void radiance_sort(Render *render);
int radiance_texels(const Render *render); /* of a node in the buffer light */
void radiance_delete(Render *render);
/* Tells a pass that has radiance.glsl in its text where it is: two units from `unit` on. Binds it
 * to these before a run. */
enum { RADIANCE_UNITS = 2, RADIANCE_DEFINITIONS = 128 };
void radiance_define(const Render *render, char text[RADIANCE_DEFINITIONS]);
void radiance_set(const Render *render, int unit, ScreenPass *pass);
void radiance_bind(const Render *render, int unit);
/* A line on it. */
void radiance_put(Text *out, const Render *render);
/* Sets a uniform of an object's material. */
bool radiance_param(Render *render, int material, const MaterialValue *value);
/* Emission depends on the time. */
bool radiance_by_time(const Render *render);

/* The rows of the frame graph. */
extern const FramePass pass_radiance;
#endif
