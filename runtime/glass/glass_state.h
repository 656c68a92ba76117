/* State of transparent surfaces: data of the passes in runtime/glass. */
#ifndef MATC_GLASS_GLASS_STATE_H
#define MATC_GLASS_GLASS_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/draw/screen_pass.h"

/* State of pass_lists.c. */
typedef struct {
    GLuint buffer;
    GLuint fragments; /* that it has room for: as many as there are */
    size_t bytes;
    int depth_unit; /* where the programs of planes find the depth of what is opaque */
    bool full;      /* they would take more than there may be */
} FrameLists;

/* Transparent surfaces: per-pixel lists of fragments, or peeled layers. */
struct FrameGlass {
    ScreenPass blend, peel; /* of lists; of a layer */
    FrameLists lists;
    Framebuffer layers[2]; /* that are peeled, in turns */
    int layer_count;
    int peel_units[2]; /* where their programs find the depth of what is opaque, and the keys */
};
#endif
