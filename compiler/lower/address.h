/* Texture addressing outside the image that no sampler provides: replaces the coordinate to
 * read, and computes the share of the image in the result. */
#ifndef MATC_ADDRESS_H
#define MATC_ADDRESS_H
#include "compiler/ir/ir.h"

/* An image of `size` texels, a vec2, whose read function repeats it. */
typedef struct {
    Keyword address; /* a keyword of the list Address in words.def */
    bool smooth;     /* bilinear: four texels are mixed; else nearest */
    Ref size;
} Addressed;

/* Returns the coordinate in the repeated image whose value the addressed image has at uv. For
 * `border` it is the nearest edge; address_share() gives the weight. */
Ref address_place(Ir *ir, const Addressed *picture, Ref uv);
/* Returns the coordinate before wrapping: it changes as uv does, reversed where the image is
 * mirrored. */
Ref address_unfolded(Ir *ir, const Addressed *picture, Ref uv);
/* Returns the share in [0, 1] of the image in the value read at uv; the rest is transparent
 * black. `wide`: edges, in texels per component, of a box that replaces the four mixed texels;
 * 0: none. Returns 0 unless the address is `border`. */
Ref address_share(Ir *ir, const Addressed *picture, Ref uv, Ref wide);
/* Replaces a sampler call at less than one texel per pixel by texel fetches; 0: not a sampler
 * call, or plain repeat. */
Ref address_texels(Ir *ir, Ref call);
#endif
