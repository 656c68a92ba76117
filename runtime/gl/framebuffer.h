/* Framebuffers: colour textures, of floats or of whole numbers, with or without depth. */
#ifndef MATC_GL_FRAMEBUFFER_H
#define MATC_GL_FRAMEBUFFER_H
#include "runtime/gl/context.h"

enum { FRAMEBUFFER_COLORS = 8 };

typedef struct {
    int width, height;
    int color_count;     /* 0 to FRAMEBUFFER_COLORS */
    GLenum color_format; /* GL_RGBA8, GL_RGBA16F, GL_RGBA32F, GL_RGBA32UI, ... */
    bool depth;          /* GL_DEPTH_COMPONENT32F */
} FramebufferSpec;

typedef struct {
    FramebufferSpec spec;
    GLuint name;
    GLuint colors[FRAMEBUFFER_COLORS];  /* textures, nearest filter */
    GLuint depth;                       /* texture, 0 without depth; reads as plain red */
    GLenum formats[FRAMEBUFFER_COLORS]; /* of the colours */
    bool borrowed;                      /* the textures are the caller's */
    bool stencil;                       /* as is a stencil, in that of depth */
} Framebuffer;

/* A part of one colour target. */
typedef struct {
    int color;
    int x, y, width, height;
} FramebufferPart;

/* Makes the textures and checks completeness; the framebuffer is bound afterwards. On false *made
 * is empty. */
bool framebuffer_make(GlContext *gl, const FramebufferSpec *spec, Framebuffer *made);

/* Makes a framebuffer with a format for each color target by its name, such as "RGBA16F" or
 * "RG32UI"; color_format is not read. */
bool framebuffer_make_named(GlContext *gl, const FramebufferSpec *spec, const char *const *names,
                            Framebuffer *made);
/* Targets by themselves, for framebuffers that share them: nearest filter. 0: see gl->error. Delete
 * with gl->DeleteTextures. */
typedef struct {
    int width, height;
    const char
        /* "RGBA16F", "RGBA32UI", ...; "DEPTH32F", "DEPTH32F_STENCIL8": depth, which reads as plain
         * red */
        *format;
} TargetSpec;
GLuint framebuffer_target(GlContext *gl, const TargetSpec *spec);
/* The driver can show a target's memory as one of another format (OpenGL 4.3), of as many bits a
 * pixel, none of them depth; that one. */
bool framebuffer_has_views(const GlContext *gl);
GLuint framebuffer_view(GlContext *gl, GLuint target, const char *format);
/* Such textures, the first spec->color_count of them, and depth, or 0. */
typedef struct {
    GLuint colors[FRAMEBUFFER_COLORS], depth;
    bool stencil; /* depth has one, which is drawn to */
    const char *formats[FRAMEBUFFER_COLORS];
} FramebufferTextures;
/* Draws to textures that the caller keeps. */
bool framebuffer_make_around(GlContext *gl, const FramebufferSpec *spec,
                             const FramebufferTextures *textures, Framebuffer *made);
/* The target holds whole numbers. */
bool framebuffer_has_words(const Framebuffer *framebuffer, int color);

/* Sets every pixel: targets of floats to a colour, those of whole numbers to 0, the depth to 1. */
void framebuffer_clear(const GlContext *gl, const Framebuffer *framebuffer, const float color[4]);

/* Draws go to all its targets from now on; the viewport is the whole of it. */
void framebuffer_use(const GlContext *gl, const Framebuffer *framebuffer);

/* Four floats a texel, row 0 is the bottom row, nothing is clamped. */
bool framebuffer_read(GlContext *gl, const Framebuffer *framebuffer, int color, float *rgba);
bool framebuffer_read_part(GlContext *gl, const Framebuffer *framebuffer,
                           const FramebufferPart *part, float *rgba);

/* Four whole numbers a texel; lanes that the format lacks are 0, 0, 1. */
bool framebuffer_read_words(GlContext *gl, const Framebuffer *framebuffer, int color, GLuint *rgba);

/* Safe on an empty one, which it leaves behind. */
void framebuffer_delete(const GlContext *gl, Framebuffer *framebuffer);
#endif
