/* Transparent surfaces, exactly: every fragment of them that nothing opaque hides is kept as it was
 * packed for the G-buffer, lit as opaque ones are, and laid over what is behind it, colour channel
 * by colour channel.
 *
 * Two ways give the same picture. Lists, from OpenGL 4.3 on: one pass appends each fragment to its
 * pixel's list in a buffer, a second one sorts, lights and blends a pixel's fragments. The
 * fragments are counted when the scene is made, and the buffer is as large as they need. Peeling,
 * elsewhere and where the lists would not fit: a pass over the surfaces for each layer, from the
 * back. */
#ifndef MATC_CACHE_TRANSPARENCY_H
#define MATC_CACHE_TRANSPARENCY_H
#include "runtime/cache/set.h"
#include "runtime/draw/store.h"

typedef enum { TRANSPARENCY_lists, TRANSPARENCY_peeling } Transparency;

enum {
    TRANSPARENCY_TEXT = 2048, /* bytes of text that are made for a layout */
    /* words of a fragment in a list before what is packed: the next one, the depth */
    TRANSPARENCY_NODE_HEAD = 2,
    TRANSPARENCY_STRIDE = 256, /* triangles of an object that is peeled are counted in so many */
    TRANSPARENCY_LISTS = 2     /* binding point of the lists' storage buffer */
};

/* GLSL around a material's programs, so that they end elsewhere than in the G-buffer. */
typedef struct {
    Transparency way;
    bool instances;                  /* of surfaces */
    char head[TRANSPARENCY_TEXT];    /* in place of its #version */
    char tail[2][TRANSPARENCY_TEXT]; /* for surfaces, for planes: what the body below goes by */
    const char *body;
} TransparencyText;

void transparency_text(const GlContext *gl, const Set *set, Transparency way,
                       TransparencyText *made);
/* Puts a material's programs, each of one piece, between. */
void transparency_wrap(const TransparencyText *text, bool plane, ProgramText *program);

/* Puts a program that gives what a surface lets through before what keeps that for shadow maps
 * (glass_store.glsl). */
void transparency_wrap_caster(const GlContext *gl, ProgramText *program);

/* Puts a program that leaves out what is cut away before what sets bits of voxels
 * (voxel_touch.glsl). */
void transparency_wrap_cut(const GlContext *gl, ProgramText *program);

/* Words that a fragment takes in a list. */
int transparency_stride(const Set *set);
/* GLSL for who reads the lists: LISTS_STRIDE, and LISTS_TEXELS, what unpackTexels takes of the node
 * at `node`. */
void transparency_reader(const Set *set, char text[TRANSPARENCY_TEXT]);
#endif
