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
    CALL_ARGUMENTS = 16,                /* of a function, at most */
    CALL_COMPONENTS = 4,
    CALL_TEXTURES = 2,   /* what a sampler argument may be: 0 a picture, 1 a relief */
    CALL_TEXT = 1 << 17, /* of a program */
};

typedef float Tuple[CALL_ARGUMENTS][CALL_COMPONENTS];

typedef struct {
    Target target;
    GlContext *gl;
    Store *store;
    Screen screen;
    Framebuffer floats, words;
    char text[CALL_TEXT]; /* of the last function that was gathered */
    char error[4096];
} Caller;

/* False: see error. Close it in any case. */
bool caller_open(Caller *caller, Target target);
void caller_close(Caller *caller);
/* Texels of the textures, for the references. */
extern const ReferenceTexture call_textures[CALL_TEXTURES];

/* The function and what it needs, for the job's choices, into `text`: what call_draw will
 * compile. */
bool call_gather(Caller *caller, int function, const Job *job);
/* CALL_COUNT results, a word as its number. A sampler argument is the texture's number in the first
 * tuple. */
bool call_draw(Caller *caller, int function, Tuple *tuples, double (*results)[CALL_COMPONENTS]);
#endif
