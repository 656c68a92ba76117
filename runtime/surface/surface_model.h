/* Surface models: the reflection of light toward the eye. Lighting uses a model only through these
 * GLSL functions, in eye space. m.normal is a unit vector that faces the eye, directions are unit
 * vectors, and the factor pi is left out, so that a white surface reflects what arrives along its
 * normal:
 *
 *     struct Lit { vec3 normal; ... };               values made from a Surface, once for all
 *                                                    lights; a Surface may lack any slot
 *     Lit surfaceLit(Surface s, vec3 toEye)
 *     vec3 surfaceOwn(Lit m)                         emission
 *     vec3 surfaceAmbient(Lit m, vec3 ambient)       reflected ambient light
 *     vec3 surfaceEven(Lit m)                        diffuse reflectance for light from surrounding
 *                                                    surfaces; for indirect light
 *     Lit surfaceMatt(Lit m)                         m without specular reflection; for indirect
 *                                                    light
 *     vec3 surfaceLobe(Lit m, vec3 l)                the share of light from the direction l,
 *                                                    including the cosine
 *     vec3 surfaceThrough(Surface s, vec3 toEye)     the transmittance for light behind the surface
 *     vec3 surfaceSky(Lit m)                         reflected light of the sky, by light_sky.glsl;
 *                                                    under #ifdef LIGHT_HAS_SKY
 *     vec3 surfaceHemisphere(Lit m)                  of hemispheres, by light_hemisphere.glsl;
 *                                                    under #ifdef LIGHT_HAS_HEMISPHERE
 *     vec3 surfaceArea(Lit m, Area light)            of a polygon of radiance 1, by
 *                                                    light_area.glsl; under #ifdef LIGHT_HAS_AREAS
 *
 * A model that is combined with another gives its area light by sides, AreaSide of light_area.glsl,
 * so that a program contains the integrals' code once; compilers take seconds for each copy:
 *
 *     int surfaceAreaSides(Lit m)
 *     AreaSide surfaceAreaSide(Lit m, int i)   Phong: the eye's side, and the back if it transmits;
 *                                              Principled: the base's lobes, the coat
 *
 * With many lights, distant lights are summed for many pixels at once if the model has `parts`. Its
 * lobe must then be, for light from the side of the eye, the cosine times E + G max(w.l, 0)^n, and
 * 0 for light from the other side, unless the surface transmits:
 *
 *     vec3 surfaceEven(Lit m)         E, as above
 *     vec3 surfaceSpecular(Lit m)        G
 *     vec3 surfaceMirror(Lit m)       w, of length 1
 *     float surfaceExponent(Lit m)    n
 *     bool surfaceLetsThrough(Lit m)
 *
 * A new model takes a text, a row here, and a number of its own (slots.def);
 * tests/frame_reference/reference_light.c has the sum that its light is compared with. */
#ifndef MATC_SURFACE_MODEL_H
#define MATC_SURFACE_MODEL_H
#include "grammar/layout_tables.h"
#include "grammar/lobe_table.h"

enum { SURFACE_MODEL_MORE = 8, SURFACE_MODEL_DEFINITIONS = 48 * LOBE_COUNT + 1 };
typedef struct {
    const char *name;
    const char *text;
    bool parts;
    const char *more[SURFACE_MODEL_MORE]; /* texts that follow `text`; NULL ends the list */
} SurfaceModel;

extern const SurfaceModel surface_model_phong, surface_model_principled;
/* Returns the model of the surfaces in a layout; a model with both if the layout has several and
 * `models`, bits 1 << Model, too. Phong without a layout. */
const SurfaceModel *surface_model_of(const LayoutRow *layout, unsigned models);
/* Defines SURFACE_MISSING_<lobe> for each lobe that no material has, by bits as above and
 * MODEL_LOBE, so that programs omit it. */
void surface_model_define(unsigned models, char text[SURFACE_MODEL_DEFINITIONS]);
#endif
