/* What stands beyond the edges of a picture, where no sampler does it: another place to read, and
 * how much of the picture is there. */
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
/* The same before it is kept between the edges: it moves as uv does, turned round where the picture
 * is mirrored. */
Ref address_unfolded(Ir *ir, const Addressed *picture, Ref uv);
/* How much of what is read at uv is the picture, in [0, 1]; the rest is transparent black. `wide`:
 * a box of so many texels stands for the four that are mixed, by lane; 0: none. 0 but for a
 * border. */
Ref address_share(Ir *ir, const Addressed *picture, Ref uv, Ref wide);
/* What a call of the sampler means below a texel a pixel, without the sampler; 0: it is no call of
 * one that does more than repeat. */
Ref address_texels(Ir *ir, Ref call);
#endif
