#include "tests/frame/shadow_band.h"

int shadow_band_expected(const Tracer *tracer, const Hit *hit, double step)
{
    enum { AROUND = 8, RINGS = 3 };
    const SceneLight *light = &tracer->scene->lights[0];
    double way[3], moved[3];
    const bool lit = shadow_is_lit(tracer, light, hit->world, hit->microfacet);
    shadow_way_to(light, hit->world, way);
    for (int i = 0; i < AROUND * RINGS; i++) {
        const int ring = i / AROUND;
        shadow_beside(hit, way, step * (ring + 1) / RINGS, PI / 4 * i + ring, moved);
        if (shadow_is_lit(tracer, light, moved, hit->microfacet) != lit)
            return -1;
    }
    return lit;
}
