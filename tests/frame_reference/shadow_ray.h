/* Rays from points to lights, and positions of lights, for tests of shadows. */
#ifndef MATC_SHADOW_RAY_H
#define MATC_SHADOW_RAY_H
#include "tests/frame_reference/reference_ray.h"
#include "tests/vectors.h"

/* Direction to a light; its length is the distance, or infinite. */
double shadow_way_to(const SceneLight *light, const double point[3], double way[3]);
/* Width of a light's shadow map texel at a point, from the documentation and without the
 * renderer's code. `reach` is the width of a directional light's map. */
double shadow_texel(const Scene *scene, const SceneLight *light, const double point[3],
                    double reach);
/* True if the ray hits an infinite plane before the light. */
bool shadow_is_behind_plane(const Scene *scene, const double from[3], const double way[3],
                            double distance);
/* True if no object is between a light and a point offset slightly from a surface to the light's
 * side. */
bool shadow_is_lit(const Tracer *tracer, const SceneLight *light, const double point[3],
                   const double microfacet[3]);
/* Moves a hit on its tangent plane by `step`, measured across the light's direction, at an angle
 * around that direction. */
void shadow_beside(const Hit *hit, const double way[3], double step, double angle, double moved[3]);

/* Elevation over the ground and azimuth, in degrees. */
enum { SHADOW_ANGLES = 7 };
extern const double shadow_angles[SHADOW_ANGLES][2];
/* Position in a direction, at a distance from the origin. */
void shadow_place(const double angle[2], double distance, double at[3]);
/* True if the geometric and the shading normal are on one side of the light; they differ at the
 * terminator of a round surface made of triangles. */
bool shadow_sides_agree(const SceneLight *light, const Hit *hit);
#endif
