/* State of a renderer that all passes share. Each folder of passes defines a state of its own,
 * which is opaque to the others; runtime/renderer/renderer_state.h composes them. */
#ifndef MATC_FRAME_GRAPH_FRAME_H
#define MATC_FRAME_GRAPH_FRAME_H
#include "runtime/gpu_scene/gpu_scene.h"
#include "runtime/gpu_scene/view_space.h"
#include "runtime/gpu_material/measure.h"
#include "runtime/gpu_material/reader.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/frame_graph/frame_targets.h"
#include "runtime/scene/scene.h"

/* A material's parameter that the caller has set. */
typedef struct {
    int material, count;
    char *name;
    float components[4];
} RendererParam;

/* The properties of a light that decide on programs, maps and targets: a change rebuilds them. */
typedef struct {
    SceneKind kind;
    Keyword shadows;
    bool both_sides;
} RendererLight;

/* Drawing style of a debug view: none, filled or as lines; for the scene and for shadow
 * geometry. */
typedef enum { FRAME_LOOK_none, FRAME_LOOK_faces, FRAME_LOOK_lines } FrameLookHow;

typedef struct {
    const char *name;
    FrameLookHow scene, shadows;
} FrameLook;

typedef struct FrameLight FrameLight;       /* defined in light/light_state.h */
typedef struct ShadowMaps ShadowMaps;       /* defined in shadow/shadow_state.h */
typedef struct FrameVoxels FrameVoxels;     /* defined in indirect/voxels/voxels.h */
typedef struct FrameRadiance FrameRadiance; /* defined in indirect/radiance/radiance.h */
/* defined in indirect/settings/indirect_state.h */
typedef struct FrameIndirect FrameIndirect;
/* defined in indirect/screen/pass_positions.h */
typedef struct FramePositions FramePositions;
typedef struct FramePost FramePost; /* defined in post/post_state.h */
/* defined in transparency/transparency_state.h */
typedef struct FrameTransparency FrameTransparency;

enum { FRAME_RETIRED_MAX = 32 };

struct Renderer {
    GlContext *gl;
    Store *store;
    MatcOptions compile;
    RendererOptions options;
    const SurfaceModel *surface;
    char surface_missing[SURFACE_MODEL_DEFINITIONS];
    const FrameLook *look; /* the debug view in use; NULL: none */
    const Scene *scene;
    RendererParam *params; /* parameters set since the scene was loaded */
    int param_count;
    RendererLight *kept_lights; /* the lights at the last rebuild: renderer_lights.c */
    int kept_light_count;
    int samples;  /* samples per pixel along each axis; the sizes below count samples */
    int size[2];  /* size of the targets: that of a tile */
    int whole[2]; /* size of the whole picture */
    int at[2];    /* lower left corner of the targets in the picture */
    int margin;   /* width of the guard band around a tile */
    bool compute, zero_to_one;
    const TriangleIdText
        *triangle_id_text; /* outputs of surface programs that identify triangles; NULL: none */
    /* a pass needs the triangles that are drawn, even tessellated ones */
    bool triangles;
    bool beside; /* shadows also need objects outside the view */
    Transparency transparency;
    bool tiled; /* shadow lists are tiled: shadow_tables.c */
    MaterialSet set;
    ViewSpace space;
    CullVolume volume; /* the view frustum */
    GpuScene gpu_scene;
    Screen screen;
    bool has_screen;
    FrameTargets targets;
    FrameLight *light;
    ShadowMaps *shadows;
    FrameVoxels *voxels;
    FrameRadiance *radiance;
    FrameIndirect *indirect;
    FramePositions *positions;
    FramePost *post;
    FrameTransparency *transparent;
    /* The scene has changed since passes last counted their work: FrameCount. */
    bool uncounted;
    /* passes of the previous scene, until frame_retired_delete() */
    ScreenPass retired[FRAME_RETIRED_MAX];
    int retired_count;
    Reader reader; /* reads the slot that the view shows */
    bool has_reader;
};

/* Moves a screen pass out of *pass and keeps it until the next scene is built, so that a program
 * that both scenes use is not compiled again. frame_retired.c */
void frame_retire(Renderer *renderer, ScreenPass *pass);
/* Deletes all retired passes. */
void frame_retired_delete(Renderer *renderer);
/* Reports whether the frame has the target. */
static inline bool frame_has(const Renderer *renderer, FrameTarget target)
{
    return renderer->targets.plan.there >> target & 1;
}
/* Reports whether the debug view shows shadow geometry. */
static inline bool frame_look_has_shadows(const Renderer *renderer)
{
    return renderer->look && renderer->look->shadows != FRAME_LOOK_none;
}
/* Returns the input of the GPU scene. */
GpuSceneSource frame_source(const Renderer *renderer);
#endif
