/* Many lights: which are far from a block of pixels and are taken together (light_bound.c), what is
 * kept of that (light_room.c), and what the passes gather and light go by (light_far.c). */
#ifndef MATC_RENDER_LIGHT_FAR_H
#define MATC_RENDER_LIGHT_FAR_H
#include "gen/far_layout.h"
#include "runtime/light/light_state.h"
#include "runtime/frame/frame.h"

/* The choice can be met; why far ones are not taken together, NULL: they are. */
bool light_far_check(GlContext *gl, const RenderOptions *options);
const char *light_far_lacks(const Render *render);
bool light_far_used(const Render *render);
/* Lights, at most: programs are shared by numbers of lights that are near. A multiple of 32. */
int light_far_most(const Render *render);
/* Error budget of light at exposure 0: relative, and absolute; `linear`: for a picture of light in
 * half floats. False: none is allowed. */
bool light_far_budget(SceneKind tone, bool linear, double budget[2]);
/* Blocks in a row of so many pixels. */
int light_far_blocks(int pixels);
/* Words of a group: a bit for each light that is near, in `bits` words behind `tops` words with a
 * bit for each of them that is not 0; from `near` to `marks` a bit for each far light whose gloss
 * is expanded. `block`: words of a block. */
typedef struct {
    int bits, tops, near, marks, block;
} LightFarWords;
LightFarWords light_far_words(const Render *render);
/* Buffers beside the plan's light: bytes of a pixel, rounded up, or 0; the edge of the blocks of
 * pixels, or 1; the most rows of a tile of that width; a line on them, once they exist. */
int light_far_bytes(const Render *render);
int light_far_block(const Render *render);
int light_far_rows(const Render *render, int width);
void light_far_put(Text *out, const Render *render);
bool light_far_make(Render *render);
void light_far_delete(Render *render);
/* Sorts so many lights of two texels, the first of which begins with a place, so that neighbours in
 * space are neighbours. False: out of memory. light_order.c */
bool light_order(float (*lights)[LIGHT_PLAIN_TEXELS][4], int count);
/* Constants of the GLSL of both passes; uniforms of one; bindings for the pass gather, and for the
 * pass light. */
enum { LIGHT_FAR_DEFINITIONS = 512 };
/* in this order */
typedef enum { LIGHT_FAR_groups, LIGHT_FAR_near, LIGHT_FAR_gather, LIGHT_FAR_light } LightFarUse;
void light_far_define(const Render *render, LightFarUse use, char defined[LIGHT_FAR_DEFINITIONS]);
void light_far_set(const Render *render, ScreenPass *pass);
void light_far_bind(const Render *render);
void light_far_bind_read(const Render *render);
#endif
