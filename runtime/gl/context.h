/* An offscreen GL context and the driver's functions, called as gl->DrawArrays(...). A context
 * belongs to one thread at a time and draws into framebuffers only; it has no window worth speaking
 * of. */
#ifndef MATC_GL_CONTEXT_H
#define MATC_GL_CONTEXT_H
#include "runtime/gl/functions.h"
#include <GL/glcorearb.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum {
    GL_KIND_osmesa, /* Mesa's software renderer, loaded when it is asked for */
    /* EGL without a window: a GPU where there is one; loaded when it is asked for */
    GL_KIND_egl,
    GL_KIND_count,
    GL_KIND_host = GL_KIND_count /* of the caller: gl_adopt */
} GlKind;

/* A context that the caller made, and that is current. */
typedef struct {
    /* the function of that name; NULL: there is none */
    void (*(*load)(void *user, const char *name))(void);
    void *user;
} GlHost;

typedef struct GlContext {
    GlKind kind;
    /* a core profile: VAOs compulsory, GLSL from 1.40 on; false: compatibility, GLSL from 1.10
     * on */
    bool core;
    int major, minor;      /* of the GL version */
    const char *version;   /* GL_VERSION; the driver's text */
    const char *renderer;  /* GL_RENDERER */
    const char *language;  /* GL_SHADING_LANGUAGE_VERSION: the greatest there is */
    bool hardware;         /* the renderer is none of Mesa's software ones */
    int max_texture_size;  /* edge of a texture or framebuffer, texels */
    int max_texture_units; /* samplers in a fragment program */
    /* of a sampler, GL_EXT_texture_filter_anisotropic or OpenGL 4.6; 1: there is none that is
     * good */
    int max_anisotropy;
    int max_draw_buffers; /* colour targets of one draw */
    void *state;          /* of the backend */
    /* what failed last; functions of the GL layer that return false or 0 leave it here */
    char error[4096];
#define F(NAME, Name) PFNGL##NAME##PROC Name;
    GL_FUNCTIONS(F)
    GL_OPTIONAL_FUNCTIONS(F) /* NULL where the driver has none */
#undef F
} GlContext;

/* The name of a kind ("osmesa") and back; false for a name that is none. */
const char *gl_kind_name(GlKind kind);
bool gl_kind_find(const char *name, GlKind *kind);

/* Opens a context and makes it current: core is 4.5, or 3.3 where there is no more; otherwise the
 * highest compatibility profile there is. NULL: see `error`. */
GlContext *gl_open(GlKind kind, bool core, char *error, size_t room);

/* Takes a context of OpenGL 3.3 core or later as it is. gl_close leaves it to its owner. NULL: see
 * `error`. */
GlContext *gl_adopt(const GlHost *host, char *error, size_t room);

/* Needed only where a thread has several contexts. */
bool gl_use(GlContext *gl);

/* Releases the context and all that was made in it. NULL is nothing. */
void gl_close(GlContext *gl);

/* Writes gl->error and returns false. */
__attribute__((format(printf, 2, 3))) bool gl_fail(GlContext *gl, const char *format, ...);

/* True when no GL error stands; otherwise gl->error is "<doing>: GL_..." and all standing errors
 * are dropped. */
bool gl_check(GlContext *gl, const char *doing);
#endif
