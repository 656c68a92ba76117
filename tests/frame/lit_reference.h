/* Reflection of a surface point in double, for tests: the surface models from their published
 * definitions, given the slots' values. Nothing of the renderer takes part.
 *
 * Phong: semantics.md 4.1. Principled: GGX with Smith's height-correlated masking (Heitz 2014) and
 * Schlick's Fresnel term, multiple scattering by Kulla and Conty (2017), F82 tint (Hoffman 2019),
 * films by Airy's sum over wavelengths, a rough diffuse base by Fujii (2012), fuzz by Estevez and
 * Kulla (2017). Layers are scaled by albedo: a diffuse base under a layer loses the layer's albedo
 * toward the light and the eye, a mirror the geometric mean of both. The renderer's layers are
 * finer for rough mirrors, which is what the bounds of the cells allow. */
#ifndef MATC_LIT_REFERENCE_H
#define MATC_LIT_REFERENCE_H
#include "compiler/oracle/oracle.h"

/* What leaves the surface: diffusely, by its facets, by the coat's, of light from behind, and
 * straight on. */
enum { LIT_EVEN, LIT_GLOSS, LIT_COAT, LIT_BEHIND, LIT_STRAIGHT, LIT_PARTS };
enum { LIT_STEPS = 32 }; /* of tables over the root of the cosine */

typedef struct {
    double by[LIT_STEPS + 1][3];
    double mean[3]; /* over all directions, weighted by the cosine */
} LitTable;

typedef struct {
    SlotValues slots;
    double eye[3], normal[3], coat_normal[3], mirrored[3];
    double widths[2], along[3], across[3]; /* GGX along and across the tangent */
    double kept;                           /* what is not a hole */
    LitTable fresnel[2];                   /* dielectric, metal: of single facets */
    LitTable once[2], loss;                /* directional albedos of single scattering, 1 - that */
    LitTable coat, fuzz;                   /* what these layers let through */
    LitTable grain;                        /* what a rough base sends at once */
    double again[2][3];                    /* multiple scattering, over that of mirrors */
    double base_mean[3], loss_mean;        /* below the layers */
} LitReference;

/* `eye` is the direction to the eye, of unit length, in the world; the normal faces it. */
void lit_reference_open(const SlotValues *slots, const double eye[3], LitReference *lit);
/* pi times the BSDF and the cosine, for light from `way`. */
void lit_reference_lobe(const LitReference *lit, const double way[3], double parts[LIT_PARTS][3]);
/* Directional albedos toward the eye; LIT_STRAIGHT is what passes of the light behind the pixel. */
void lit_reference_albedos(const LitReference *lit, double parts[LIT_PARTS][3]);
/* Emission as the eye sees it. */
void lit_reference_emission(const LitReference *lit, double rgb[3]);
#endif
