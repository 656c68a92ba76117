/* The targets of a frame: their names, their framebuffers, and the memory that they share. */
#ifndef MATC_FRAME_GRAPH_FRAME_TARGETS_H
#define MATC_FRAME_GRAPH_FRAME_TARGETS_H
#include "runtime/frame_graph/frame_plan.h"
#include "runtime/frame_graph/renderer_options.h"
#include "runtime/gl/framebuffer.h"

typedef enum {
    FRAME_TARGET_depth,
    FRAME_TARGET_gbuffer,
    /* ray-marched displacement: patch and position of a hit, a pixel of gpu_scene_trace.h */
    FRAME_TARGET_traced,
    FRAME_TARGET_shadow,      /* shadow maps, of their own sizes: pass_shadow.c owns them */
    FRAME_TARGET_voxels,      /* voxel grid, of its own size: pass_voxels.c owns it */
    FRAME_TARGET_cubes,       /* picture of the voxels, a debug view */
    FRAME_TARGET_positions,   /* picture of the depth buffer as a mesh, a debug view */
    FRAME_TARGET_radiance,    /* radiance cache, in buffers: pass_radiance.c owns them */
    FRAME_TARGET_triangle_id, /* triangle ids, or slopes of triangles */
    FRAME_TARGET_lists,       /* per-pixel linked lists, in a buffer */
    FRAME_TARGET_far,         /* far-field light in a buffer: sums of the pass light_cluster */
    FRAME_TARGET_light,
    FRAME_TARGET_rays,     /* ambient occlusion at the resolution of the rays */
    FRAME_TARGET_temporal, /* temporal accumulation: pass_temporal.c owns its textures */
    FRAME_TARGET_denoise,  /* results of the rays, denoised along rows */
    FRAME_TARGET_ao,       /* ambient occlusion and indirect light */
    FRAME_TARGET_edge,
    FRAME_TARGET_mask,  /* a bit per light with shadow volumes: set where it is occluded */
    FRAME_TARGET_layer, /* G-buffer of one layer of transparent fragments */
    FRAME_TARGET_layer_depth,
    FRAME_TARGET_layer_keys, /* depth peeling: sort keys of two layers */
    FRAME_TARGET_tools,      /* colors of the tools, dimmed by the surfaces before them */
    FRAME_TARGET_final,
    FRAME_TARGET_COUNT
} FrameTarget;

/* Framebuffers: sets of targets that are drawn to together. */
typedef enum {
    FRAME_DRAW_surface,     /* G-buffer and depth */
    FRAME_DRAW_triangle_id, /* G-buffer, depth and triangle ids */
    FRAME_DRAW_traced,      /* framebuffer of ray-marched hits and depth */
    FRAME_DRAW_sky,         /* framebuffer of light and depth */
    FRAME_DRAW_cubes,
    FRAME_DRAW_positions,
    FRAME_DRAW_light,
    FRAME_DRAW_rays,
    FRAME_DRAW_denoise,
    FRAME_DRAW_ao,
    FRAME_DRAW_edge,
    FRAME_DRAW_mask, /* framebuffer with depth and stencil */
    FRAME_DRAW_final,
    FRAME_DRAW_COUNT
} FrameDraw;

/* A piece of memory that targets share: the texture and format of the first target that uses the
 * piece. */
typedef struct {
    GLuint texture;
    const char *format;
} FrameMemory;

/* Formats and resolution of a target's textures. */
typedef struct {
    /* texture formats such as "RGBA16F"; NULL ends the list */
    const char *formats[FRAME_PLAN_TEXTURES + 1];
    /* Resolution divisor per axis. */
    int coarse;
} FrameForm;

typedef struct {
    FrameForm forms[FRAME_TARGET_COUNT];
    FramePlan plan;
    FrameMemory memory[FRAME_PLAN_PIECES];
    /* Textures of each target: those of `memory`, or views of them. */
    GLuint textures[FRAME_TARGET_COUNT][FRAMEBUFFER_COLORS];
    Framebuffer draws[FRAME_DRAW_COUNT];
} FrameTargets;

/* Returns the format of a target's texture, such as "RGBA16F"; NULL if the target has no texture
 * of that number. */
const char *frame_format(const Renderer *renderer, FrameTarget target, int texture);
/* Returns the bytes per pixel of a target. */
int frame_bytes(const Renderer *renderer, FrameTarget target);
/* Returns the size of the target's textures along an axis, in texels. */
int frame_edge(const Renderer *renderer, FrameTarget target, int axis);
/* Returns the bytes per pixel of the target that lie in memory of earlier targets. */
int frame_shared_bytes(const Renderer *renderer, FrameTarget target);
/* Returns the bytes per pixel of all targets, shared memory counted once. */
int frame_plan_bytes(const Renderer *renderer);
/* Returns the target's textures and their memory classes for frame_plan(). */
FramePlanTarget frame_plan_target(const Renderer *renderer, FrameTarget target);
const char *frame_target_name(FrameTarget target);

/* Returns texture number `texture` of a target. */
GLuint frame_texture(const Renderer *renderer, FrameTarget target, int texture);

/* Makes a framebuffer of targets that exist; does nothing if one of them is missing. */
bool frame_make_draw(Renderer *renderer, FrameDraw draw);
/* Binds a framebuffer and sets the viewport to the coordinates of the whole picture. */
void frame_use(const Renderer *renderer, const Framebuffer *framebuffer);
#endif
