/* Rays from points to lights, and positions of lights, for tests of shadows. */
#ifndef MATC_SHADOW_RAY_H
#define MATC_SHADOW_RAY_H
#include "tests/frame_reference/reference_ray.h"
#include "tests/vectors.h"

/* Towards a light; its length is the distance, or infinite. */
double shadow_way_to(const SceneLight *light, const double point[3], double way[3]);
/* How far a texel of a light's map reaches at a point: what the documents say of maps, and no code
 * of the renderer's. `reach` is across all that a directional light's map holds. */
double shadow_texel(const Scene *scene, const SceneLight *light, const double point[3],
                    double reach);
/* An infinite plane is between: it is met before the light. */
bool shadow_is_behind_plane(const Scene *scene, const double from[3], const double way[3],
                            double distance);
/* Whether nothing is between a light and a point a little off a surface, on the light's side of
 * it. */
bool shadow_is_lit(const Tracer *tracer, const SceneLight *light, const double point[3],
                   const double microfacet[3]);
/* A step on the tangent plane that is `step` across the light's way, at an angle around it. */
void shadow_beside(const Hit *hit, const double way[3], double step, double angle, double moved[3]);

/* Degrees over the ground, and around. */
enum { SHADOW_ANGLES = 7 };
extern const double shadow_angles[SHADOW_ANGLES][2];
/* So far from the origin. */
void shadow_place(const double angle[2], double distance, double at[3]);
/* Both normals are on one side of the light, which is not the case where a triangle stands for a
 * round surface at its terminator. */
bool shadow_sides_agree(const SceneLight *light, const Hit *hit);
#endif
