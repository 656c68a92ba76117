/* Shadow rays that continue through transparent surfaces, for materials whose transparency is
 * known in closed form. */
#ifndef MATC_GLASS_RAY_H
#define MATC_GLASS_RAY_H
#include "tests/frame_reference/reference_ray.h"

enum { GLASS_COUNT = 8 };
/* A material of a document, "name: { ... }". Scenes whose shares are computed may use no other
 * materials. */
const char *glass_text(int number);
/* The share of a light that reaches a surface point; if the scene's shadows are not colored, a
 * surface transmits everything or nothing. */
void glass_shares(const Tracer *tracer, const SceneLight *light, const double point[3],
                  const double microfacet[3], double shares[3]);
#endif
