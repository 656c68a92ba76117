/* A triangle that covers the whole target, drawn by full-screen passes. */
#ifndef MATC_GL_SCREEN_H
#define MATC_GL_SCREEN_H
#include "runtime/gl/context.h"

typedef struct {
    GLuint array, buffer;
} Screen;

/* Makes the triangle. Returns false on failure, with *made empty; see gl->error. */
bool screen_make(GlContext *gl, Screen *made);
/* Draws with the current program. Its vertex program is one of the texts below, or computes from
 * gl_VertexID, or reads attribute 0. */
void screen_draw(const GlContext *gl, const Screen *screen);
void screen_delete(const GlContext *gl, Screen *screen);

/* The vertex program after its #version line: for GLSL 1.10, and from 1.40 on. It has no outputs
 * besides the position. */
extern const char screen_text_old[], screen_text[];
#endif
