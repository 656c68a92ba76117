/* Run time of commands, by the driver's timer queries. On a GPU the wall clock between two calls
 * says little, since commands start and end later than their calls. */
#ifndef MATC_GL_CLOCK_H
#define MATC_GL_CLOCK_H
#include "runtime/gl/context.h"

/* Reports whether the driver has useful timer queries; those of a software renderer are the wall
 * clock at best. */
bool gl_clock_is(const GlContext *gl);
/* Starts a timer query over the commands up to gl_clock_stop(), which deletes the query. Queries
 * do not nest. */
GLuint gl_clock_start(const GlContext *gl);
/* Waits until the commands are done. Returns the seconds from the start of the first to the end
 * of the last. */
double gl_clock_stop(const GlContext *gl, GLuint query);
#endif
