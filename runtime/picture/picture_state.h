/* State of edges and tools: data of the passes in runtime/picture. */
#ifndef MATC_PICTURE_PICTURE_STATE_H
#define MATC_PICTURE_PICTURE_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/draw/measure.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/gl/framebuffer.h"

/* State of the pass edge. */
typedef struct {
    Material material;
    GLuint lines; /* texels of edge_list.h */
    int count;    /* of lines */
} FrameEdge;

/* State of pass_tools.c. */
typedef struct {
    Material material;
    GLuint array, buffer;      /* of vertices of tool_lines.h */
    int count;                 /* of vertices */
    Framebuffer lines, colors; /* light and the tools' target with depth; that target alone */
    ScreenPass veil;           /* lays what is transparent over the tools: what it lets through */
} FrameTools;

struct FramePicture {
    ScreenPass tone;
    /* what tone mapping asks of the picture, and of what it makes of that */
    Measure measured, adapted;
    /* textures of the same, of all tiles; 0: there is one tile */
    GLuint whole[2];
    float whole_texels[2][MEASURE_TEXELS][4]; /* what is in them */
    FrameEdge edge;
    FrameTools tools;
};
#endif
