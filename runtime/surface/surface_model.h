/* Surface models: how a surface sends light to the eye. What lights surfaces knows a model by these
 * functions of its GLSL alone, in the eye's space; m.normal is a unit vector that faces the eye,
 * directions are unit vectors, and pi is taken out, so that a white surface sends back what arrives
 * along its normal:
 *
 *     struct Lit { vec3 normal; ... };               what it makes of a Surface, once for all
 *                                                    lights; a Surface may lack any slot
 *     Lit surfaceLit(Surface s, vec3 toEye)
 *     vec3 surfaceOwn(Lit m)                         what it sends without any light: emissive
 *     vec3 surfaceAmbient(Lit m, vec3 ambient)       what it sends of ambient light
 *     vec3 surfaceEven(Lit m)                        the share of light from the surfaces around it
 *                                                    that it sends evenly; for indirect light
 *     Lit surfaceMatt(Lit m)                         the same without light that it does not send
 *                                                    evenly; for indirect light
 *     vec3 surfaceLobe(Lit m, vec3 l)                the share of light from the direction l, the
 *                                                    cosine counted in
 *     vec3 surfaceThrough(Surface s, vec3 toEye)     the share of the light behind it that passes
 *     vec3 surfaceSky(Lit m)                         of the sky all around, by light_sky.glsl;
 *                                                    under #ifdef LIGHT_HAS_SKY
 *     vec3 surfaceHemisphere(Lit m)                  of hemispheres, by light_hemisphere.glsl;
 *                                                    under #ifdef LIGHT_HAS_HEMISPHERE
 *     vec3 surfaceArea(Lit m, Area light)            of a polygon of radiance 1, by
 *                                                    light_area.glsl; under #ifdef LIGHT_HAS_AREAS
 *
 * A model that is asked for together with another gives its area light by sides, AreaSide of
 * light_area.glsl, so that a program has the integrals' code once; compilers take seconds for each:
 *
 *     int surfaceAreaSides(Lit m)
 *     AreaSide surfaceAreaSide(Lit m, int i)   Phong: the eye's side, and behind it what lets light
 *                                              through; Principled: what its base sends, its coat
 *
 * Where there are many lights, a model with `parts` has those that are far summed for many pixels
 * at once. Its lobe is then, for light from the side of the eye, the cosine times E + G max(w.l,
 * 0)^n; light from the other side is nothing, if it lets none through:
 *
 *     vec3 surfaceEven(Lit m)         E, as above
 *     vec3 surfaceGloss(Lit m)        G
 *     vec3 surfaceMirror(Lit m)       w, of length 1
 *     float surfaceExponent(Lit m)    n
 *     bool surfaceLetsThrough(Lit m)
 *
 * A further model is a text and a row here, and a number of its own (slots.def);
 * tests/frame_reference/reference_light.c has the sum that its light is held against. */
#ifndef MATC_SURFACE_MODEL_H
#define MATC_SURFACE_MODEL_H
#include "grammar/layout_tables.h"
#include "grammar/lobe_table.h"

enum { SURFACE_MODEL_MORE = 8, SURFACE_MODEL_DEFINITIONS = 48 * LOBE_COUNT + 1 };
typedef struct {
    const char *name;
    const char *text;
    bool parts;
    const char *more[SURFACE_MODEL_MORE]; /* texts behind that one; NULL where there is none */
} SurfaceModel;

extern const SurfaceModel surface_model_phong, surface_model_principled;
/* The model of surfaces that a layout holds, or one of them all, where it holds several and so do
 * `models`, bits 1 << Model; NULL: of no surface. */
const SurfaceModel *surface_model_of(const LayoutRow *layout, unsigned models);
/* SURFACE_LACKS_<lobe> for each that no material has, by bits as above and MODEL_LOBE: what a scene
 * lacks is not in its programs. */
void surface_model_define(unsigned models, char text[SURFACE_MODEL_DEFINITIONS]);
#endif
