/* Interface of a backend that opens contexts. context.c lists the backends; no other file
 * includes this header. */
#ifndef MATC_GL_BACKEND_H
#define MATC_GL_BACKEND_H
#include <stdbool.h>
#include <stddef.h>

typedef void (*GlProc)(void);

typedef struct {
    /* Opens a context, makes it current, and returns its state; NULL on failure, with a reason
     * in `error`. */
    void *(*open)(bool core, char *error, size_t capacity);
    bool (*use)(void *state); /* makes the context current on this thread */
    /* Returns the address of a function such as "glClear"; NULL if the driver lacks it. */
    GlProc (*load)(void *state, const char *name);
    void (*close)(void *state);
} GlBackend;

extern const GlBackend gl_backend_osmesa, gl_backend_egl;
#endif
