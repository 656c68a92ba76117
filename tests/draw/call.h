/* Calls a GLSL library function with many tuples of arguments at once: one fragment per tuple,
 * the arguments from a texture. */
#ifndef MATC_VALUE_CALL_H
#define MATC_VALUE_CALL_H
#include "compiler/base/session.h"
#include "compiler/ir/job.h"
#include "runtime/gpu_material/material.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/screen.h"
#include "compiler/library/reference.h"

enum {
    CALL_SIDE = 32,
    CALL_COUNT = CALL_SIDE * CALL_SIDE, /* tuples of a draw */
    CALL_ARGUMENTS = 16,                /* max arguments of a function */
    CALL_COMPONENTS = 4,
    CALL_TEXTURES = 2,   /* textures for sampler arguments: 0 a picture, 1 a relief */
    CALL_TEXT = 1 << 17, /* capacity of a program's text */
};

typedef float Tuple[CALL_ARGUMENTS][CALL_COMPONENTS];

typedef struct {
    Target target;
    GlContext *gl;
    Store *store;
    Screen screen;
    Framebuffer floats, words;
    char text[CALL_TEXT]; /* text of the function gathered last */
    char error[4096];
} Caller;

/* Returns false with a message in `error`. Close it in any case. */
bool caller_open(Caller *caller, Target target);
void caller_close(Caller *caller);
/* Texels of the textures, for the references. */
extern const ReferenceTexture call_textures[CALL_TEXTURES];

/* Gathers the function and its dependencies, for the job's choices, into `text`, which call_draw
 * compiles. */
bool call_gather(Caller *caller, int function, const Job *job);
/* Computes CALL_COUNT results, with words converted to numbers. A sampler argument is the
 * texture's number in the first tuple. */
bool call_draw(Caller *caller, int function, Tuple *tuples, double (*results)[CALL_COMPONENTS]);
#endif
