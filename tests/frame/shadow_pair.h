/* Two renderers for all pictures of a shadow test: with shadows, and without. */
#ifndef MATC_SHADOW_PAIR_H
#define MATC_SHADOW_PAIR_H
#include "tests/frame/frame_draw.h"

typedef struct {
    GlContext *gl;
    MatcOptions options;
    RendererOptions how[2];
    Renderer *renders[2]; /* [1] casts none; views of light */
} ShadowPair;

/* It stays where it is, as renderers point to its options. */
void shadow_pair_open(GlKind kind, ShadowPair *pair);
void shadow_pair_close(ShadowPair *pair);
/* Four floats a pixel, from malloc. */
float *shadow_pair_draw(const ShadowPair *pair, int which, const Scene *scene);
/* Light that arrives at each pixel, as a share of all of it; -1 where none would. From malloc. */
float *shadow_pair_shares(const ShadowPair *pair, const Scene *scene);
#endif
