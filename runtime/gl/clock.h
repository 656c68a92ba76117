/* How long commands take, by the driver's clock where there is one: on a GPU time between two calls
 * says little, as it begins later and ends later than they do. */
#ifndef MATC_GL_CLOCK_H
#define MATC_GL_CLOCK_H
#include "runtime/gl/context.h"

/* The driver has a clock of its own. That of a software renderer is the wall clock, at best. */
bool gl_clock_is(const GlContext *gl);
/* Starts it: commands until gl_clock_stop are timed. There is none within another. The query, which
 * that deletes. */
GLuint gl_clock_start(const GlContext *gl);
/* Waits until they are done. Seconds from the first's start to the last's end. */
double gl_clock_stop(const GlContext *gl, GLuint query);
#endif
