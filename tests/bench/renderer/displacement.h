/* Tables of matbench displacement. */
#ifndef MATBENCH_DISPLACEMENT_H
#define MATBENCH_DISPLACEMENT_H
#include <stdbool.h>

typedef struct GlContext GlContext;
/* Returns false after a message. */
bool displacement_speed(GlContext *gl, bool timed, int triangles);
bool displacement_programs(GlContext *gl, bool timed, int triangles);
/* plot: name of an SVG file, without ".svg", for charts of the thesis' figures 23 and 24; or
 * NULL. */
bool displacement_table(GlContext *gl, bool timed, int most, const char *plot);
bool displacement_bisection(GlContext *gl, bool timed, int triangles);
bool displacement_silhouettes(GlContext *gl);
bool displacement_slopes(void);
#endif
