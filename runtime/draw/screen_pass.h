/* A pass over all pixels of a target: one body of GLSL, passPixel() or passOver(), with two
 * entries: compute, where there is GL 4.3, or a fragment program. */
#ifndef MATC_DRAW_SCREEN_PASS_H
#define MATC_DRAW_SCREEN_PASS_H
#include "runtime/draw/material.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/screen.h"

enum { SCREEN_PASS_PIECES = 62 };
_Static_assert((int)SCREEN_PASS_PIECES + 2 <= (int)PROGRAM_PIECES,
               "a head before them, an entry behind");

typedef struct {
    const char *body[SCREEN_PASS_PIECES]; /* GLSL, read one after the other; NULL ends the list */
    const char *format;                   /* of the target: "RGBA16F", ... */
    bool compute;                         /* wanted; there must be GL 4.3 then */
    /* the body is passOver(): what it gives is laid over what is in the target */
    bool over;
    int block; /* 0, or the body has a compute entry of its own, for squares of so many pixels */
} ScreenPassText;
/* Behind the body that is there; of NULL and "" nothing is added. There must be room. */
void screen_pass_add(ScreenPassText *text, const char *piece);
void screen_pass_add_all(ScreenPassText *text, const char *const *pieces, int count);

typedef struct {
    Material material;
    bool compute, over;
    int block;  /* the edge, in pixels, of what a group of invocations draws */
    int layers; /* groups of invocations for the same pixels: 1 when it's made */
    GLenum format;
} ScreenPass;

/* False: see the context's error; *made is empty then. */
bool screen_pass_make(Store *store, const ScreenPassText *text, ScreenPass *made);
/* The unit that a sampler reads from, at which a texture is bound before every run. */
void screen_pass_sampler(ScreenPass *pass, const char *name, int unit);
/* Runs over all pixels of the framebuffer's only target. */
void screen_pass_run(ScreenPass *pass, const Framebuffer *target, const Screen *screen);
void screen_pass_delete(ScreenPass *pass);
#endif
