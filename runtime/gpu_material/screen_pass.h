/* A full-screen pass: one body of GLSL, passPixel() or passOver(), with two entry points:
 * compute, from GL 4.3 on, or a fragment program. */
#ifndef MATC_GPU_MATERIAL_SCREEN_PASS_H
#define MATC_GPU_MATERIAL_SCREEN_PASS_H
#include "runtime/gpu_material/material.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/screen.h"

enum { SCREEN_PASS_PIECES = 62 };
_Static_assert((int)SCREEN_PASS_PIECES + 2 <= (int)PROGRAM_PIECES,
               "a head before them, an entry behind");

typedef struct {
    /* pieces of GLSL, which are concatenated; NULL ends the list */
    const char *body[SCREEN_PASS_PIECES];
    const char *format; /* format of the target, such as "RGBA16F" */
    bool compute;       /* use a compute program; needs GL 4.3 */
    /* The body is passOver(): its result is blended over the target. */
    bool over;
    /* edge of a workgroup in pixels if the body has its own compute entry point; 0: it has none */
    int block;
    bool full; /* a piece did not fit: screen_pass_make() fails */
} ScreenPassText;
/* Append a piece of GLSL to the body; NULL and "" are ignored. A piece beyond the capacity sets
 * `full`. */
void screen_pass_add(ScreenPassText *text, const char *piece);
void screen_pass_add_all(ScreenPassText *text, const char *const *pieces, int count);

typedef struct {
    Material material;
    bool compute, over;
    int block;  /* edge in pixels of the square that a work group draws */
    int layers; /* work groups per square; 1 by default */
    GLenum format;
} ScreenPass;

/* Makes a pass. Returns false on failure, with *made empty; see the context's error. */
bool screen_pass_make(Store *store, const ScreenPassText *text, ScreenPass *made);
/* Sets the unit of a sampler; the caller binds its texture before every run. */
void screen_pass_sampler(ScreenPass *pass, const char *name, int unit);
/* Runs over all pixels of the framebuffer's only target. */
void screen_pass_run(ScreenPass *pass, const Framebuffer *target, const Screen *screen);
void screen_pass_delete(ScreenPass *pass);
#endif
