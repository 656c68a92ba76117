/* Maps as means over the pixel's footprint. Each function is the plain map where nothing is
 * filtered. */
#ifndef MATC_AREA_H
#define MATC_AREA_H
#include "compiler/lower/footprint.h"

/* A volume map's function of a position and its parameters. */
Answer area_volume(Lower *l, Kind kind, Answer p, const Ref *args, int count);
/* turbulence and vectorTurbulence of a position and (octaves, frequencyRatio, noiseRatio). */
Answer area_turbulence(Lower *l, Answer p, const Ref args[3]);
Answer area_vector_turbulence(Lower *l, Answer p, const Ref args[3]);
/* The share of the footprint where an odd number of lanes of q lie in the upper half of their
 * period 1; q has two or three. 0: it is everywhere the same, and only the point decides. */
Ref area_odd_share(Lower *l, Answer q);
/* A picture and its function (sampler, uv, size). */
typedef struct {
    Function function;
    Ref sampler, size;
    /* what the shader does beyond the edges; repeat: the function or the sampler does all */
    Word address;
} Picture;
/* Selects the library function that reads an ImageMap at uv; `smooth`: texels are mixed. */
Function area_picture_function(const Lower *l, Ref uv, bool smooth);
/* A picture at uv. */
Ref area_picture(Lower *l, const Picture *picture, Ref uv);
/* At a point near uv, as it would be shown at uv: for differences. */
Ref area_picture_near(Lower *l, const Picture *picture, Ref point, Ref uv);
/* How a lane of what is shown rises over one texel along u and along v, a vec2, by the texels
 * themselves where the picture is magnified, else as `shown`, by differences of area_picture_near;
 * 0: nothing but these can tell. */
Ref area_picture_rise(Lower *l, const Picture *picture, Ref uv, int lane, Ref shown);
/* 1 / (high - low) of known numbers, computed in double here or where the buffer is filled; 0 where
 * they are equal. */
Ref area_known_inverse(Lower *l, Ref low, Ref high);
/* The share of the way from `low` to `high` that t has gone, in [0, 1], as a mean over a box of t;
 * equal ones make a step. */
Ref area_ramp(Lower *l, Ref t, Ref edge, Ref low, Ref high);
#endif
