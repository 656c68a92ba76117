/* Order-independent transparency, exact: every transparent fragment before the opaque surface is
 * stored as packed for the G-buffer, lit like opaque ones, and blended over the fragments behind
 * it, per color channel.
 *
 * Two techniques give the same picture. Per-pixel linked lists, from OpenGL 4.3 on: one pass
 * appends each fragment to its pixel's list in a buffer, a second one sorts, lights and blends a
 * pixel's fragments. The fragments are counted when the scene is made, and the buffer has
 * exactly that capacity. Depth peeling, for other drivers and if the lists would not fit: a pass
 * over the surfaces for each layer, from back to front. */
#ifndef MATC_GPU_SCENE_TRANSPARENCY_H
#define MATC_GPU_SCENE_TRANSPARENCY_H
#include "runtime/gpu_scene/material_set.h"
#include "runtime/gpu_material/store.h"

typedef enum { TRANSPARENCY_lists, TRANSPARENCY_peeling } Transparency;

enum {
    TRANSPARENCY_TEXT = 2048, /* max bytes of text that is generated for a layout */
    /* Words of a fragment in a list before its packed surface: the next fragment, the depth. */
    TRANSPARENCY_NODE_HEAD = 2,
    /* depth peeling: the size of an object's range of triangle keys is a multiple of the stride */
    TRANSPARENCY_STRIDE = 256,
    TRANSPARENCY_LISTS = 2 /* binding point of the lists' storage buffer */
};

/* GLSL around a material's programs, which redirects their output from the G-buffer to lists or
 * layers. */
typedef struct {
    Transparency way;
    bool instances;               /* programs of surfaces use instancing */
    char head[TRANSPARENCY_TEXT]; /* text that replaces the #version line */
    /* definitions that the body reads, for surfaces and for planes */
    char tail[2][TRANSPARENCY_TEXT];
    const char *body;
} TransparencyText;

void transparency_text(const GlContext *gl, const MaterialSet *set, Transparency way,
                       TransparencyText *made);
/* Wraps a material's programs, each a single text. */
void transparency_wrap(const TransparencyText *text, bool plane, ProgramText *program);

/* Wraps a program of a surface's transmittance with code that stores it for shadow maps
 * (glass_store.glsl). */
void transparency_wrap_caster(const GlContext *gl, ProgramText *program);

/* Wraps an alpha-tested program with code that sets bits of voxels (voxel_touch.glsl). */
void transparency_wrap_cut(const GlContext *gl, ProgramText *program);

/* Returns the words of a fragment in a list. */
int transparency_stride(const MaterialSet *set);
/* Writes GLSL for readers of the lists: LISTS_STRIDE, and LISTS_TEXELS, the arguments of
 * unpackTexels for the node at `node`. */
void transparency_reader(const MaterialSet *set, char text[TRANSPARENCY_TEXT]);
#endif
