/* The targets of a frame: their names, what is drawn to together, and the memory that they
 * share. */
#ifndef MATC_FRAME_FRAME_TARGETS_H
#define MATC_FRAME_FRAME_TARGETS_H
#include "runtime/frame/frame_plan.h"
#include "runtime/frame/render_options.h"
#include "runtime/gl/framebuffer.h"

typedef enum {
    FRAME_TARGET_depth,
    FRAME_TARGET_gbuffer,
    FRAME_TARGET_traced,    /* which patch a ray met, and where: a pixel of cache_trace.h */
    FRAME_TARGET_shadow,    /* maps of their own size: pass_shadow.c has them */
    FRAME_TARGET_voxels,    /* of their own size, too: pass_voxels.c */
    FRAME_TARGET_cubes,     /* a view of them */
    FRAME_TARGET_positions, /* a view of depth as a mesh */
    FRAME_TARGET_radiance,  /* buffers: pass_radiance.c */
    FRAME_TARGET_seen,      /* numbers of triangles, or how steep they are */
    FRAME_TARGET_lists,     /* no texture, but a buffer */
    FRAME_TARGET_far,       /* the same: what the pass gather sums */
    FRAME_TARGET_light,
    FRAME_TARGET_rays,    /* the same, of the pixels for which rays go out */
    FRAME_TARGET_history, /* of its own: pass_history.c */
    FRAME_TARGET_smooth,  /* smoothed along rows */
    FRAME_TARGET_open,    /* openness and indirect light */
    FRAME_TARGET_edge,
    FRAME_TARGET_mask,  /* a bit for each light whose shadows are counted: it is kept off */
    FRAME_TARGET_layer, /* a G-buffer of transparent fragments */
    FRAME_TARGET_layer_depth,
    FRAME_TARGET_layer_keys, /* of two layers */
    FRAME_TARGET_tools,      /* their colours, as they are seen through what is before them */
    FRAME_TARGET_shown,
    FRAME_TARGET_COUNT
} FrameTarget;

/* Textures that are drawn to together. */
typedef enum {
    FRAME_DRAW_surface, /* G-buffer and depth */
    FRAME_DRAW_seen,    /* the same and what is seen */
    FRAME_DRAW_traced,  /* what rays meet, and depth */
    FRAME_DRAW_sky,     /* light and depth */
    FRAME_DRAW_cubes,
    FRAME_DRAW_positions,
    FRAME_DRAW_light,
    FRAME_DRAW_rays,
    FRAME_DRAW_smooth,
    FRAME_DRAW_open,
    FRAME_DRAW_edge,
    FRAME_DRAW_mask, /* with depth and stencil */
    FRAME_DRAW_shown,
    FRAME_DRAW_COUNT
} FrameDraw;

/* A piece of the targets' memory: as the first target that lies in it sees it. */
typedef struct {
    GLuint texture;
    const char *format;
} FrameMemory;

/* Textures of a target. */
typedef struct {
    const char *formats[FRAME_PLAN_TEXTURES + 1]; /* "RGBA16F"; NULL behind the last */
    /* pixels of the frame along an edge of one of its own */
    int coarse;
} FrameForm;

typedef struct {
    FrameForm forms[FRAME_TARGET_COUNT];
    FramePlan plan;
    FrameMemory memory[FRAME_PLAN_PIECES];
    /* of targets: the memory's, or views of these */
    GLuint textures[FRAME_TARGET_COUNT][FRAMEBUFFER_COLORS];
    Framebuffer draws[FRAME_DRAW_COUNT];
} FrameTargets;

/* The format of a target's texture, "RGBA16F"; NULL: it has no such texture. */
const char *frame_format(const Render *render, FrameTarget target, int texture);
int frame_bytes(const Render *render, FrameTarget target); /* of a pixel */
/* of its textures: the picture has no samples */
int frame_edge(const Render *render, FrameTarget target, int axis);
/* of these, in memory of targets before it */
int frame_shared_bytes(const Render *render, FrameTarget target);
/* of a pixel, in all of these */
int frame_plan_bytes(const Render *render);
/* How textures of a target can share memory. */
FramePlanTarget frame_plan_target(const Render *render, FrameTarget target);
const char *frame_target_name(FrameTarget target);

/* The texture of a target, and its number among those that are there together. */
GLuint frame_texture(const Render *render, FrameTarget target, int texture);

/* Makes what draws to targets that are there. */
bool frame_make_draw(Render *render, FrameDraw draw);
/* Draws to these targets from now on, by the picture's coordinates. */
void frame_use(const Render *render, const Framebuffer *framebuffer);
#endif
