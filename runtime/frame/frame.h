/* State of a renderer that all passes share. Each folder of passes defines a state of its own,
 * which is opaque to the others; runtime/render/render_state.h composes them. */
#ifndef MATC_FRAME_FRAME_H
#define MATC_FRAME_FRAME_H
#include "runtime/cache/cache.h"
#include "runtime/cache/view_space.h"
#include "runtime/draw/measure.h"
#include "runtime/draw/reader.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/frame/frame_targets.h"
#include "runtime/scene/scene.h"

/* A param of a material that was set. */
typedef struct {
    int material, count;
    char *name;
    float lanes[4];
} RenderParam;

/* The properties of a light that decide on programs, maps and targets: a change rebuilds them. */
typedef struct {
    SceneKind kind;
    Word shadows;
    bool both_sides;
} RenderLight;

/* A debug view of the picture: how it draws the scene, and what is made for shadows. */
typedef enum { FRAME_LOOK_none, FRAME_LOOK_faces, FRAME_LOOK_lines } FrameLookHow;

typedef struct {
    const char *name;
    FrameLookHow scene, shadows;
} FrameLook;

typedef struct FrameLight FrameLight;         /* light/light_state.h */
typedef struct ShadowMaps ShadowMaps;         /* shadow/shadow_state.h */
typedef struct FrameVoxels FrameVoxels;       /* indirect/voxels/voxels.h */
typedef struct FrameRadiance FrameRadiance;   /* indirect/radiance/radiance.h */
typedef struct FrameIndirect FrameIndirect;   /* indirect/settings/indirect_state.h */
typedef struct FramePositions FramePositions; /* indirect/screen/pass_positions.h */
typedef struct FramePicture FramePicture;     /* picture/picture_state.h */
typedef struct FrameGlass FrameGlass;         /* glass/glass_state.h */

enum { FRAME_RETIRED_MAX = 32 };

struct Render {
    GlContext *gl;
    Store *store;
    MatcOptions compile;
    RenderOptions options;
    const SurfaceModel *surface;
    char surface_lacks[SURFACE_MODEL_DEFINITIONS];
    const FrameLook *look; /* the view, if it is one of these; or NULL */
    const Scene *scene;
    RenderParam *params; /* that were set since the scene was given */
    int param_count;
    RenderLight *kept_lights; /* as they were when all was made: render_lights.c */
    int kept_light_count;
    int samples;  /* of a pixel, across and down: what follows counts these */
    int size[2];  /* of the targets: of a tile */
    int whole[2]; /* of the picture */
    int at[2];    /* the targets' lower left corner in it */
    int margin;   /* around a tile, that its edges look at */
    bool compute, zero_to_one;
    const SeenText *seen_text; /* what programs of surfaces write of triangles; or NULL */
    bool triangles;            /* something asks for those that are drawn, wherever they are made */
    bool beside;               /* shadows ask for what is beside the view as for what is in it */
    Transparency transparency;
    bool parted; /* lists of shadows are drawn in parts: shadow_tables.c */
    Set set;
    ViewSpace space;
    CullVolume volume; /* what is in view */
    Cache cache;
    Screen screen;
    bool has_screen;
    FrameTargets targets;
    FrameLight *light;
    ShadowMaps *shadows;
    FrameVoxels *voxels;
    FrameRadiance *radiance;
    FrameIndirect *indirect;
    FramePositions *positions;
    FramePicture *picture;
    FrameGlass *glass;
    /* the scene has changed since passes counted: see FrameCount */
    bool uncounted;
    ScreenPass retired[FRAME_RETIRED_MAX]; /* of the previous scene, for frame_retire() */
    int retired_count;
    Reader reader; /* of a slot that is viewed */
    bool has_reader;
};

/* Moves a screen pass out of *pass and keeps it until the next scene is built, so that a program
 * that both scenes use is not compiled again. frame_retired.c */
void frame_retire(Render *render, ScreenPass *pass);
/* Deletes all retired passes. */
void frame_retired_delete(Render *render);
/* Whether the frame has the target. */
static inline bool frame_has(const Render *render, FrameTarget target)
{
    return render->targets.plan.there >> target & 1;
}
/* Whether the debug view shows what is made for shadows. */
static inline bool frame_look_has_shadows(const Render *render)
{
    return render->look && render->look->shadows != FRAME_LOOK_none;
}
/* Input of the cache. */
CacheSource frame_source(const Render *render);
#endif
