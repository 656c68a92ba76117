/* A triangle that covers the whole target: what a pass over all pixels draws. */
#ifndef MATC_GL_SCREEN_H
#define MATC_GL_SCREEN_H
#include "runtime/gl/context.h"

typedef struct {
    GLuint array, buffer;
} Screen;

/* On false *made is empty, see gl->error. */
bool screen_make(GlContext *gl, Screen *made);
/* Draws with the current program, whose vertex program is the text below, or goes by gl_VertexID,
 * or reads the attribute 0. */
void screen_draw(const GlContext *gl, const Screen *screen);
void screen_delete(const GlContext *gl, Screen *screen);

/* The vertex program behind a line of #version: in GLSL 1.10, and from 1.40 on. It gives the
 * fragment program nothing. */
extern const char screen_text_old[], screen_text[];
#endif
