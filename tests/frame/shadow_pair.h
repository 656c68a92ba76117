/* Two renderers for all pictures of a shadow test: with shadows, and without. */
#ifndef MATC_SHADOW_PAIR_H
#define MATC_SHADOW_PAIR_H
#include "tests/frame/frame_draw.h"

typedef struct {
    GlContext *gl;
    MatcOptions options;
    RendererOptions how[2];
    Renderer *renders[2]; /* [1] without shadows; views of the light */
} ShadowPair;

/* Opens a pair, which must not be moved, because renderers point to its options. */
void shadow_pair_open(GlKind kind, ShadowPair *pair);
void shadow_pair_close(ShadowPair *pair);
/* Draws four floats per pixel, from malloc. */
float *shadow_pair_draw(const ShadowPair *pair, int which, const Scene *scene);
/* Share of the light that arrives at each pixel; -1 where no light would arrive without shadows.
 * From malloc. */
float *shadow_pair_shares(const ShadowPair *pair, const Scene *scene);
#endif
