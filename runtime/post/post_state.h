/* State of the passes in runtime/post. */
#ifndef MATC_POST_POST_STATE_H
#define MATC_POST_POST_STATE_H
#include "runtime/frame_graph/frame.h"
#include "runtime/gpu_material/measure.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/gl/framebuffer.h"

/* State of the pass edge. */
typedef struct {
    Material material;
    GLuint lines; /* texture of lines, laid out as in edge_list.h */
    int count;    /* number of lines */
} FrameEdge;

/* State of pass_tools.c. */
typedef struct {
    Material material;
    GLuint array, buffer; /* vertex array and vertex buffer of ToolVertex */
    int count;            /* number of vertices */
    /* `lines`: light and tools target with depth; `colors`: tools target only */
    Framebuffer lines, colors;
    /* attenuates tools behind transparent surfaces by their transmittance */
    ScreenPass veil;
} FrameTools;

struct FramePost {
    ScreenPass tone;
    /* Reductions over the picture for tone mapping: of the light, and of the adapted colors. */
    Measure measured, adapted;
    /* Results of both reductions merged over all tiles, as textures; 0: the picture is one tile. */
    GLuint whole[2];
    float whole_texels[2][MEASURE_TEXELS][4]; /* copy of the texels of `whole` */
    FrameEdge edge;
    FrameTools tools;
};
#endif
