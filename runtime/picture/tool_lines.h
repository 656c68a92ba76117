/* Tools as lines: a grid, axes, where lights are and how they shine. Without GL. */
#ifndef MATC_RENDER_TOOL_LINES_H
#define MATC_RENDER_TOOL_LINES_H
#include "runtime/cache/view_space.h"

typedef struct {
    float
        /* in the eye's space; w: 1 where the line lies in the world's plane z = 0, whose depth it
         * then has */
        point[4];
    float color[3]; /* linear light of the screen */
} ToolVertex;

/* Two vertices a line; where two lines meet, the first is in front. */
typedef struct {
    ToolVertex *vertices; /* from malloc */
    int count, room;
} ToolLines;

/* False: memory ran out, and nothing is made. */
bool tool_lines_make(const Scene *scene, const ViewSpace *space, ToolLines *made);
void tool_lines_free(ToolLines *lines);
#endif
