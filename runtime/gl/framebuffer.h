/* Framebuffers: colour textures of one format, with or without depth. */
#ifndef MATC_GL_FRAMEBUFFER_H
#define MATC_GL_FRAMEBUFFER_H
#include "context.h"

enum { FRAMEBUFFER_COLORS = 8 };

typedef struct {
    int width, height;
    int color_count;     /* 0 to FRAMEBUFFER_COLORS */
    GLenum color_format; /* GL_RGBA8, GL_RGBA16F, GL_RGBA32F */
    bool depth;          /* GL_DEPTH_COMPONENT32F */
} FramebufferSpec;

typedef struct {
    FramebufferSpec spec;
    GLuint name;
    GLuint colors[FRAMEBUFFER_COLORS]; /* textures, nearest filter */
    GLuint depth;                      /* texture, 0 without depth; reads as plain red */
} Framebuffer;

/* A part of one colour target. */
typedef struct {
    int color;
    int x, y, width, height;
} FramebufferPart;

/* Makes the textures and checks completeness; the framebuffer is bound afterwards. On false *made is empty. */
bool framebuffer_make(GlContext *gl, const FramebufferSpec *spec, Framebuffer *made);

/* Draws go to all its targets from now on; the viewport is the whole of it. */
void framebuffer_use(const GlContext *gl, const Framebuffer *framebuffer);

/* Four floats a texel, row 0 is the bottom row, nothing is clamped. */
bool framebuffer_read(GlContext *gl, const Framebuffer *framebuffer, int color, float *rgba);
bool framebuffer_read_part(GlContext *gl, const Framebuffer *framebuffer, const FramebufferPart *part, float *rgba);

/* Safe on an empty one, which it leaves behind. */
void framebuffer_delete(const GlContext *gl, Framebuffer *framebuffer);
#endif
