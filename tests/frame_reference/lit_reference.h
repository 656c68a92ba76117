/* Reflection of a surface point in double, for tests: the surface models from their published
 * definitions, given the slots' values. Nothing of the renderer takes part.
 *
 * Phong: semantics.md 4.1. Principled: GGX with Smith's height-correlated masking (Heitz 2014) and
 * Schlick's Fresnel term, multiple scattering by Kulla and Conty (2017), F82 tint (Hoffman 2019),
 * films by Airy's sum over wavelengths, a rough diffuse base by Fujii (2012), fuzz by Estevez and
 * Kulla (2017). Layers are scaled by albedo: a diffuse base under a layer loses the layer's albedo
 * toward the light and the eye, specular reflection loses the geometric mean of both. The renderer
 * models layers over rough reflections more finely; the bounds of light_cells.def allow for
 * that. */
#ifndef MATC_LIT_REFERENCE_H
#define MATC_LIT_REFERENCE_H
#include "compiler/oracle/oracle.h"

/* Parts of the light that leaves a surface: EVEN diffuse and fuzz, SPECULAR specular reflection,
 * COAT reflection by the coat, BEHIND diffuse transmission, STRAIGHT unscattered transmission. */
enum { LIT_EVEN, LIT_SPECULAR, LIT_COAT, LIT_BEHIND, LIT_STRAIGHT, LIT_PARTS };
enum { LIT_STEPS = 32 }; /* steps of tables over the square root of the cosine */

typedef struct {
    double by[LIT_STEPS + 1][3];
    double mean[3]; /* mean over all directions, weighted by the cosine */
} LitTable;

typedef struct {
    SlotValues slots;
    double eye[3], normal[3], coat_normal[3], mirrored[3];
    double widths[2], along[3], across[3]; /* GGX widths along and across the tangent */
    double kept;                           /* coverage: 1 - the share of holes */
    LitTable fresnel[2];                   /* Fresnel term of a microfacet: dielectric, metal */
    /* albedo of single scattering; 1 - it for a white mirror */
    LitTable once[2], loss;
    LitTable coat, fuzz;            /* transmittance of these layers */
    LitTable grain;                 /* albedo of single scattering by a rough diffuse base */
    double again[2][3];             /* multiple scattering, relative to a white mirror */
    double base_mean[3], loss_mean; /* means below the layers: 1 - specular albedo, loss */
} LitReference;

/* `eye` is the unit direction to the eye in the world; the normal is flipped toward the eye. */
void lit_reference_open(const SlotValues *slots, const double eye[3], LitReference *lit);
/* pi times the BSDF and the cosine, for light from `way`. */
void lit_reference_lobe(const LitReference *lit, const double way[3], double parts[LIT_PARTS][3]);
/* Directional albedos toward the eye; LIT_STRAIGHT is the transmittance for light behind the
 * pixel. */
void lit_reference_albedos(const LitReference *lit, double parts[LIT_PARTS][3]);
/* Emission toward the eye. */
void lit_reference_emission(const LitReference *lit, double rgb[3]);
#endif
