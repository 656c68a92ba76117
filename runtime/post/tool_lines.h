/* Geometry of the tools as lines: grid, axes, outlines of lights. Does not use GL. */
#ifndef MATC_RENDER_TOOL_LINES_H
#define MATC_RENDER_TOOL_LINES_H
#include "runtime/gpu_scene/view_space.h"

typedef struct {
    /* Position in view space; w is 1 for lines in the world's plane z = 0, which get that
     * plane's depth. */
    float point[4];
    float color[3]; /* color in linear sRGB */
} ToolVertex;

/* Two vertices per line. At intersections, earlier lines are in front. */
typedef struct {
    ToolVertex *vertices; /* array from malloc */
    int count, capacity;
} ToolLines;

/* Builds the lines of a scene's tools. Returns false if memory runs out; *made is then empty. */
bool tool_lines_make(const Scene *scene, const ViewSpace *space, ToolLines *made);
void tool_lines_free(ToolLines *lines);
#endif
