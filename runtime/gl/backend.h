/* Interface of a way to open a context. context.c lists them; no other file includes this. */
#ifndef MATC_GL_BACKEND_H
#define MATC_GL_BACKEND_H
#include <stdbool.h>
#include <stddef.h>

typedef void (*GlProc)(void);

typedef struct {
    /* its state, the context being current; NULL: see error */
    void *(*open)(bool core, char *error, size_t room);
    bool (*use)(void *state); /* makes it current on this thread */
    /* the function "glName", NULL when the driver has none */
    GlProc (*load)(void *state, const char *name);
    void (*close)(void *state);
} GlBackend;

extern const GlBackend gl_backend_osmesa, gl_backend_egl;
#endif
