/* An offscreen GL context and the driver's functions, called as gl->DrawArrays(...). A context
 * belongs to one thread at a time and draws only into framebuffers; it has no visible window. */
#ifndef MATC_GL_CONTEXT_H
#define MATC_GL_CONTEXT_H
#include "runtime/gl/functions.h"
#include <GL/glcorearb.h>
#include <stdbool.h>
#include <stddef.h>

typedef enum {
    GL_KIND_osmesa, /* Mesa's software renderer, loaded on first use */
    /* EGL without a window, on a GPU if available; loaded on first use */
    GL_KIND_egl,
    GL_KIND_count,
    GL_KIND_host = GL_KIND_count /* context adopted from the caller: gl_adopt() */
} GlKind;

/* A context that the caller made and that is current. */
typedef struct {
    /* Returns the address of a function; NULL if the driver lacks it. */
    void (*(*load)(void *user, const char *name))(void);
    void *user;
} GlHost;

typedef struct GlContext {
    GlKind kind;
    /* true: core profile, with mandatory VAOs and GLSL from 1.40 on; false: compatibility
     * profile, with GLSL from 1.10 on */
    bool core;
    int major, minor;      /* version of GL */
    const char *version;   /* string of GL_VERSION */
    const char *renderer;  /* string of GL_RENDERER */
    const char *language;  /* highest version, as GL_SHADING_LANGUAGE_VERSION */
    bool hardware;         /* the renderer is not one of Mesa's software renderers */
    int max_texture_size;  /* max edge of a texture or framebuffer, in texels */
    int max_texture_units; /* max samplers in a fragment program */
    /* Max anisotropy of a sampler, by GL_EXT_texture_filter_anisotropic or OpenGL 4.6; 1: none
     * of good quality. */
    int max_anisotropy;
    int max_draw_buffers; /* max color targets of one draw */
    void *state;          /* state of the backend */
    /* The last error: functions of the GL layer that return false or 0 store it here. */
    char error[4096];
#define F(NAME, Name) PFNGL##NAME##PROC Name;
    GL_FUNCTIONS(F)
    GL_OPTIONAL_FUNCTIONS(F) /* NULL if the driver lacks the function */
#undef F
} GlContext;

/* Convert a kind to its name, such as "osmesa", and back; false for an unknown name. */
const char *gl_kind_name(GlKind kind);
bool gl_kind_find(const char *name, GlKind *kind);

/* Opens a context and makes it current. With `core` the version is 4.5, or 3.3 if the driver has
 * no more; otherwise the highest compatibility profile. NULL on failure, with a reason in
 * `error`. */
GlContext *gl_open(GlKind kind, bool core, char *error, size_t capacity);

/* Adopts the caller's context of OpenGL 3.3 core or later, which gl_close() does not destroy.
 * NULL on failure, with a reason in `error`. */
GlContext *gl_adopt(const GlHost *host, char *error, size_t capacity);

/* Makes the context current; needed only if a thread has several contexts. */
bool gl_use(GlContext *gl);

/* Releases the context and all its objects. Does nothing for NULL. */
void gl_close(GlContext *gl);

/* Formats gl->error and returns false. */
__attribute__((format(printf, 2, 3))) bool gl_fail(GlContext *gl, const char *format, ...);

/* Returns true if no GL error is pending. Otherwise sets gl->error to "<doing>: GL_..." and
 * clears all pending errors. */
bool gl_check(GlContext *gl, const char *doing);
#endif
