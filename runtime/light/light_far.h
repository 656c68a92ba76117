/* Light clustering for many lights: which lights are far from a block of pixels and summed
 * together (light_bound.c), storage of the results (light_storage.c), and inputs of the passes
 * light_cluster and light (light_far.c). */
#ifndef MATC_RENDER_LIGHT_FAR_H
#define MATC_RENDER_LIGHT_FAR_H
#include "gen/far_layout.h"
#include "runtime/light/light_state.h"
#include "runtime/frame_graph/frame.h"

/* Checks the option `lights`; returns the reason why distant lights are not summed together,
 * NULL if they are; reports whether they are. */
bool light_far_check(GlContext *gl, const RendererOptions *options);
const char *light_far_missing(const Renderer *renderer);
bool light_far_used(const Renderer *renderer);
/* Returns the capacity in lights, a power of two and a multiple of 32. Programs are shared by
 * all numbers of lights up to it. */
int light_far_most(const Renderer *renderer);
/* Returns the error budget of light at exposure 0: relative, and absolute; `linear`: for a
 * picture of light in half floats. False if no error is allowed. */
bool light_far_budget(SceneKind tone, bool linear, double budget[2]);
/* Returns the number of blocks in a row of pixels. */
int light_far_blocks(int pixels);
/* Words of a group of pixels: `tops` words with a bit for each nonzero word of `bits`; `bits`
 * words with a bit for each near light; from `near` to `marks` a bit for each distant light
 * whose specular light is expanded. `block`: words of a block. */
typedef struct {
    int bits, tops, near, marks, block;
} LightFarWords;
LightFarWords light_far_words(const Renderer *renderer);
/* Buffers of light clustering: bytes per pixel, rounded up, or 0 if unused; edge of the blocks
 * in pixels, or 1; max rows of a tile of a given width; a line for --stats; creation and
 * deletion. */
int light_far_bytes(const Renderer *renderer);
int light_far_block(const Renderer *renderer);
int light_far_rows(const Renderer *renderer, int width);
void light_far_put(Text *out, const Renderer *renderer);
bool light_far_make(Renderer *renderer);
void light_far_delete(Renderer *renderer);
/* Sorts lights of two texels, the first of which begins with a position, so that lights close in
 * space are close in the array. False if memory runs out. light_order.c */
bool light_order(float (*lights)[LIGHT_PLAIN_TEXELS][4], int count);
/* Inputs of the passes: constants of the GLSL; uniforms; bindings for the pass light_cluster,
 * and for the pass light. */
enum { LIGHT_FAR_DEFINITIONS = 512 };
/* The programs in the order of a frame. */
typedef enum { LIGHT_FAR_groups, LIGHT_FAR_near, LIGHT_FAR_cluster, LIGHT_FAR_light } LightFarUse;
void light_far_define(const Renderer *renderer, LightFarUse use,
                      char defined[LIGHT_FAR_DEFINITIONS]);
void light_far_set(const Renderer *renderer, ScreenPass *pass);
void light_far_bind(const Renderer *renderer);
void light_far_bind_read(const Renderer *renderer);
#endif
