/* Addressing beyond the edges of a picture that no sampler does: another texel to read, and how
 * much of the picture is there. */
#ifndef MATC_ADDRESS_H
#define MATC_ADDRESS_H
#include "compiler/ir/ir.h"

/* A picture of `size` texels, a vec2, whose function repeats it. */
typedef struct {
    Word address; /* an Address of words.def */
    bool smooth;  /* four texels are mixed; else the one at the point is taken */
    Ref size;
} Addressed;

/* Where the repeated picture has what this one has at uv. Of a border that is the nearest edge:
 * address_share knows the rest. */
Ref address_place(Ir *ir, const Addressed *picture, Ref uv);
/* The coordinate before it is wrapped: it moves as uv does, reversed where the picture is mirrored.
 * */
Ref address_unfolded(Ir *ir, const Addressed *picture, Ref uv);
/* How much of what is read at uv is the picture, in [0, 1]; the rest is transparent black. `wide`:
 * a box of so many texels stands for the four that are mixed, by lane; 0: none. 0 but for a
 * border. */
Ref address_share(Ir *ir, const Addressed *picture, Ref uv, Ref wide);
/* Replaces a call of the sampler below one texel a pixel by fetches; 0: it is no such call, or only
 * repeats. */
Ref address_texels(Ir *ir, Ref call);
#endif
