/* Framebuffers: color textures of floats or integers, with or without depth. */
#ifndef MATC_GL_FRAMEBUFFER_H
#define MATC_GL_FRAMEBUFFER_H
#include "runtime/gl/context.h"

enum { FRAMEBUFFER_COLORS = 8 };

typedef struct {
    int width, height;
    int color_count;     /* number of color targets, 0 to FRAMEBUFFER_COLORS */
    GLenum color_format; /* format such as GL_RGBA8, GL_RGBA16F, GL_RGBA32F or GL_RGBA32UI */
    bool depth;          /* has a depth texture, GL_DEPTH_COMPONENT32F */
} FramebufferSpec;

typedef struct {
    FramebufferSpec spec;
    GLuint name;
    GLuint colors[FRAMEBUFFER_COLORS]; /* color textures with nearest filtering */
    /* depth texture, sampled as the red component; 0: no depth */
    GLuint depth;
    GLenum formats[FRAMEBUFFER_COLORS]; /* formats of the color targets */
    bool borrowed;                      /* the caller owns the textures */
    /* the depth texture has a stencil, even if the caller owns the texture */
    bool stencil;
} Framebuffer;

/* A rectangle of one color target. */
typedef struct {
    int color;
    int x, y, width, height;
} FramebufferPart;

/* Makes the textures, checks completeness, and leaves the framebuffer bound. Returns false on
 * failure, with *made empty. */
bool framebuffer_make(GlContext *gl, const FramebufferSpec *spec, Framebuffer *made);

/* Makes a framebuffer with a named format for each color target, such as "RGBA16F" or "RG32UI";
 * color_format is ignored. */
bool framebuffer_make_named(GlContext *gl, const FramebufferSpec *spec, const char *const *names,
                            Framebuffer *made);
/* A texture that several framebuffers can share as a target, with nearest filter.
 * framebuffer_target() returns 0 on failure; see gl->error. Delete with gl->DeleteTextures. */
typedef struct {
    int width, height;
    /* "RGBA16F", "RGBA32UI", ...; "DEPTH32F", "DEPTH32F_STENCIL8": depth, sampled as the red
     * component. */
    const char *format;
} TargetSpec;
GLuint framebuffer_target(GlContext *gl, const TargetSpec *spec);
/* Texture views (OpenGL 4.3): the first function reports whether the driver supports them. The
 * second returns a target's memory as a texture of another format, with equal bits per pixel,
 * neither of them depth. */
bool framebuffer_has_views(const GlContext *gl);
GLuint framebuffer_view(GlContext *gl, GLuint target, const char *format);
/* Textures of a framebuffer: the first spec->color_count of `colors`, and depth; 0: no depth. */
typedef struct {
    GLuint colors[FRAMEBUFFER_COLORS], depth;
    bool stencil; /* the depth texture includes a stencil, which is attached, too */
    const char *formats[FRAMEBUFFER_COLORS];
} FramebufferTextures;
/* Makes a framebuffer of textures that the caller owns. */
bool framebuffer_make_around(GlContext *gl, const FramebufferSpec *spec,
                             const FramebufferTextures *textures, Framebuffer *made);
/* Reports whether the color target holds integers. */
bool framebuffer_has_words(const Framebuffer *framebuffer, int color);

/* Clears all pixels: targets of floats to a color, targets of integers to 0, depth to 1. */
void framebuffer_clear(const GlContext *gl, const Framebuffer *framebuffer, const float color[4]);

/* Binds the framebuffer with all its targets; the viewport covers all of it. */
void framebuffer_use(const GlContext *gl, const Framebuffer *framebuffer);

/* Reads four floats per texel, row 0 at the bottom, without clamping. */
bool framebuffer_read(GlContext *gl, const Framebuffer *framebuffer, int color, float *rgba);
bool framebuffer_read_part(GlContext *gl, const Framebuffer *framebuffer,
                           const FramebufferPart *part, float *rgba);

/* Reads four integers per texel; components that the format lacks are 0, 0, 1. */
bool framebuffer_read_words(GlContext *gl, const Framebuffer *framebuffer, int color, GLuint *rgba);

/* Frees the framebuffer and leaves it empty; safe on an empty one. */
void framebuffer_delete(const GlContext *gl, Framebuffer *framebuffer);
#endif
