/* Maps as means over the pixel's footprint. Without filtering, each function returns the plain
 * map. */
#ifndef MATC_AREA_H
#define MATC_AREA_H
#include "compiler/lower/footprint.h"

/* Lowers a volume map as a function of a position and its parameters. */
MapValue area_volume(Lower *l, Kind kind, MapValue p, const Ref *args, int count);
/* Lowers turbulence and vectorTurbulence: functions of a position and (octaves, frequencyRatio,
 * noiseRatio). */
MapValue area_turbulence(Lower *l, MapValue p, const Ref args[3]);
MapValue area_vector_turbulence(Lower *l, MapValue p, const Ref args[3]);
/* Returns the share of the footprint where an odd number of components of q is in the upper half
 * of its period 1; q has two or three components. 0: no footprint, and the point alone decides. */
Ref area_odd_share(Lower *l, MapValue q);
/* An image and the function that reads it (sampler, uv, size). */
typedef struct {
    Function function;
    Ref sampler, size;
    /* Addressing that the shader computes; repeat: the function or the sampler does all. */
    Keyword address;
} Picture;
/* Selects the library function that reads an ImageMap at uv; `smooth`: texels are mixed. */
Function area_picture_function(const Lower *l, Ref uv, bool smooth);
/* Returns the image's filtered value at uv. */
Ref area_picture(Lower *l, const Picture *picture, Ref uv);
/* Returns the value at a point near uv, filtered with uv's footprint: for finite differences. */
Ref area_picture_near(Lower *l, const Picture *picture, Ref point, Ref uv);
/* Returns the change of one component over one texel along u and v, a vec2. Magnified images
 * use the texels themselves; otherwise `shown`, the differences of area_picture_near(), is
 * returned. 0: use `shown` in any case. */
Ref area_picture_rise(Lower *l, const Picture *picture, Ref uv, int component, Ref shown);
/* Returns 1 / (high - low) of known numbers, computed in double here or when the buffer is
 * filled; 0 if they are equal. */
Ref area_known_inverse(Lower *l, Ref low, Ref high);
/* Returns a linear ramp from 0 at `low` to 1 at `high`, as a mean over a box of t; equal bounds
 * make a step. */
Ref area_ramp(Lower *l, Ref t, Ref edge, Ref low, Ref high);
#endif
