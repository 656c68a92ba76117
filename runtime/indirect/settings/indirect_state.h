/* State of indirect light: rays, and temporal accumulation. */
#ifndef MATC_INDIRECT_INDIRECT_STATE_H
#define MATC_INDIRECT_INDIRECT_STATE_H
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/settings/indirect_method.h"

typedef struct {
    /* Indexed by object: its matrix at the last accumulated frame; NULL: frames do not
     * accumulate. */
    SceneMatrix *kept;
    int first, end;   /* range of objects that may have moved since the last accumulated frame */
    Material number;  /* program that draws motion ids */
    Framebuffer seen; /* motion ids, integers, 0 for none; made on the first move */
} IndirectMotion;

/* State of temporal accumulation: pass_temporal.c. */
typedef struct {
    ScreenPass blend, place;
    Framebuffer values[2], places[2]; /* double buffers: a frame reads one and writes the other */
    int last;                         /* index of the buffer written last */
    int sets;                         /* sets of rays accumulated since the last change */
    unsigned number;                  /* number of sets since the start */
    /* History exists; nothing has changed since; the wanted error is reached. */
    bool there, still, exact;
    unsigned dirty;            /* bit set of IndirectDirty: samples that may be out of date */
    double eye_from_world[16]; /* view of the accumulated frame */
    float ray[4], depth[4];
} IndirectHistory;

/* Passes at lower resolution, used while something moves, in parts of the same targets. */
typedef struct {
    bool on; /* something has changed since the previous frame */
    ScreenPass rays, again, smooth, spread;
    Framebuffer found, smoothed; /* parts of the targets rays and denoise */
} IndirectMoving;

/* State of the passes. */
struct FrameIndirect {
    const IndirectMethod *method; /* method of the rays; NULL: the scene has no indirect light */
    IndirectHistory history;
    IndirectMoving moving;
    Framebuffer between; /* intermediate à-trous levels: the target ao, or a part of it */
    IndirectMotion motion;
    /* `again` traces the rays of further bounces */
    ScreenPass rays, again, smooth, spread, combine;
};
#endif
