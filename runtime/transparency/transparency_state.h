/* State of transparent surfaces: data of the passes in runtime/transparency. */
#ifndef MATC_TRANSPARENCY_TRANSPARENCY_STATE_H
#define MATC_TRANSPARENCY_TRANSPARENCY_STATE_H
#include "runtime/frame_graph/frame.h"
#include "runtime/gpu_material/screen_pass.h"

/* State of pass_lists.c: per-pixel linked lists. */
typedef struct {
    GLuint buffer;
    GLuint fragments; /* capacity in fragments: the number of existing ones */
    size_t bytes;
    int depth_unit; /* texture unit of the opaque surfaces' depth, for planes' programs */
    bool full;      /* the lists exceed the memory limit */
} FrameLists;

/* Transparent surfaces: per-pixel linked lists of fragments, or peeled layers. */
struct FrameTransparency {
    ScreenPass blend, peel; /* lighting of lists; of a layer */
    FrameLists lists;
    Framebuffer layers[2]; /* two layers, peeled alternately */
    int layer_count;
    int peel_units[2]; /* texture units of the opaque surfaces' depth, and of the keys */
};
#endif
