/* What a frame is drawn with. */
#ifndef MATC_FRAME_FRAME_H
#define MATC_FRAME_FRAME_H
#include "runtime/draw/measure.h"
#include "runtime/draw/reader.h"
#include "runtime/frame/frame_glass.h"
#include "runtime/frame/frame_indirect.h"
#include "runtime/frame/frame_light.h"
#include "runtime/frame/frame_picture.h"
#include "runtime/frame/frame_shadow.h"
#include "runtime/frame/frame_targets.h"

/* A param of a material that was set. */
typedef struct {
    int material, count;
    char *name;
    float lanes[4];
} RenderParam;

struct Render {
    GlContext *gl;
    Store *store;
    MatcOptions compile;
    RenderOptions options;
    const SurfaceModel *surface;
    char surface_lacks[SURFACE_MODEL_DEFINITIONS];
    const VolumeView *look; /* the view, if it is one of these; or NULL */
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
    ExactNumberWhat number; /* what programs of surfaces write of triangles */
    bool triangles; /* something asks for those that are drawn, wherever they are made */
    Transparency transparency;
    bool parted; /* lists of shadows are drawn in parts: shadow_parts.c */
    Set set;
    ViewSpace space;
    CullVolume volume; /* what is in view */
    Cache cache;
    Screen screen;
    bool has_screen;
    FrameTargets targets;
    FrameLight light;
    FrameGlass glass;
    FramePicture picture;
    FrameVolumes volumes;
    ShadowMaps shadows;
    ExactShadows exact;
    FramePositions positions;
    FrameVoxels voxels;
    FrameIndirect indirect;
    FrameRadiance radiance;
    Reader reader; /* of a slot that is viewed */
    bool has_reader;
};

/* Whether there is something to count; it begins, goes on in each tile, where what the pass reads is drawn then, once more in all tiles where `again`
 * says so, and ends. */
typedef enum { FRAME_COUNT_wanted, FRAME_COUNT_begin, FRAME_COUNT_tile, FRAME_COUNT_again, FRAME_COUNT_end } FrameCount;

/* What the cache is made of. */
CacheSource frame_source(const Render *render);
#endif
