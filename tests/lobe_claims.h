/* What any lobe keeps, of pixels that a program drew: light and eye may change places, and white stays white in light from all around. */
#ifndef MATC_LOBE_CLAIMS_H
#define MATC_LOBE_CLAIMS_H
#include <math.h>

/* GLSL: a facet of GGX that is seen from v (Heitz 2018), by two numbers in [0, 1). */
#define LOBE_FACET                                                                                                     \
    "vec3 facet(vec3 v, float a, vec2 u) {\n"                                                                          \
    "    vec3 w = normalize(vec3(a * v.xy, v.z)), t = w.z < 0.9999 ? normalize(vec3(-w.y, w.x, 0.0)) : vec3(1.0, 0.0, 0.0), s = cross(w, t);\n" \
    "    float r = sqrt(u.x), f = 6.2831853 * u.y, x = r * cos(f), y = r * sin(f), k = 0.5 + 0.5 * w.z;\n"               \
    "    y = mix(sqrt(max(1.0 - x * x, 0.0)), y, k);\n"                                                                \
    "    vec3 n = x * t + y * s + sqrt(max(1.0 - x * x - y * y, 0.0)) * w;\n"                                          \
    "    return normalize(vec3(a * n.xy, max(n.z, 1e-6)));\n}\n"

/* Three lanes of a pixel are by how much both ways differ, of their sum. */
static inline void lobe_changes_places(float (*said)[4], int count)
{
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, fmax((double)said[i][0], fmax((double)said[i][1], (double)said[i][2])));
    print_message("changed places: within %.1e\n", worst);
    assert_true(worst < 2e-5);
}

/* Lane 0 is what comes of light 1 from all around. */
static inline void lobe_is_white_around(float (*said)[4], int count)
{
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, fabs((double)said[i][0] - 1));
    print_message("from all around: within %.4f\n", worst);
    assert_true(worst < .01);
}
#endif
