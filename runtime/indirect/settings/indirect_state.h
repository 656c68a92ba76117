/* State of indirect light: of its rays, and of what is accumulated over frames. */
#ifndef MATC_INDIRECT_INDIRECT_STATE_H
#define MATC_INDIRECT_INDIRECT_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/indirect/settings/indirect_method.h"

typedef struct {
    /* by object: where it stood when rays were kept last; NULL: nothing is kept */
    SceneMatrix *kept;
    int first, end;   /* objects of these may have moved since */
    Material number;  /* draws them */
    Framebuffer seen; /* whole numbers: 0, or which motion; made when something has moved */
} IndirectMotion;

/* Results of rays in previous frames: pass_history.c. */
typedef struct {
    ScreenPass blend, place;
    Framebuffer values[2], places[2]; /* one is kept, the other drawn to */
    int last;                         /* the one that is kept */
    int sets;                         /* of rays that are in it, since something changed */
    unsigned number;                  /* of all sets */
    /* something is kept; nothing has changed since; it is as exact as is wanted */
    bool there, still, exact;
    unsigned doubts;           /* a sum of IndirectDoubt */
    double eye_from_world[16]; /* of the view that it was seen in */
    float ray[4], depth[4];
} IndirectHistory;

/* Passes of fewer pixels, while something moves, in a part of the same targets. */
typedef struct {
    bool on; /* something is another than in the frame before */
    ScreenPass rays, again, smooth, spread;
    Framebuffer found, smoothed; /* the targets rays and smooth */
} IndirectMoving;

/* State of the passes. */
struct FrameIndirect {
    const IndirectMethod *method; /* NULL: the scene has none */
    IndirectHistory history;
    IndirectMoving moving;
    Framebuffer between; /* of levels of the filter atrous: the target open, or a part of it */
    IndirectMotion motion;
    ScreenPass rays, again, smooth, spread, combine; /* again: rays of further bounces */
};
#endif
