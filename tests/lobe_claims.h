/* Properties that every lobe must have, checked at pixels that a program drew: reciprocity, and
 * a white furnace. */
#ifndef MATC_LOBE_CLAIMS_H
#define MATC_LOBE_CLAIMS_H
#include <math.h>

#define LOBE_PI 3.14159265358979323846

/* grid of visible microfacet normals that albedos are summed over */
enum { LOBE_RINGS = 96, LOBE_TURNS = 64 };

/* GLSL for a picture of 20 x 20 pixels: a roughness by row, a cosine of at least 0.1 by column,
 * a direction, and numbers in [0, 1) that vary from pixel to pixel. */
#define LOBE_PIXELS                                                                                \
    "const float SIDE = 20.0;\n"                                                                   \
    "float roughOf(ivec2 p) { return 0.0316227766 + 0.9683772 * float(p.y) / (SIDE - 1.0); }\n"    \
    "float cosineOf(ivec2 p) { return 0.1 + 0.9 * float(p.x) / (SIDE - 1.0); }\n"                  \
    "vec3 toward(float cosine, float turn) { float s = sqrt(max(1.0 - cosine * cosine, 0.0)); "    \
    "return vec3(s * cos(turn), s * sin(turn), cosine); }\n"                                       \
    "float varied(ivec2 p, float step) { return fract(0.5 + step * float(p.x + 20 * p.y)); }\n"

/* GLSL: samples a GGX normal visible from v (Heitz 2018), by two numbers in [0, 1). */
#define LOBE_MICROFACET                                                                            \
    "vec3 facet(vec3 v, float a, vec2 u) {\n"                                                      \
    "    vec3 w = normalize(vec3(a * v.xy, v.z)), t = w.z < 0.9999 ? normalize(vec3(-w.y, w.x, "   \
    "0.0)) : vec3(1.0, 0.0, 0.0), s = cross(w, t);\n"                                              \
    "    float r = sqrt(u.x), f = 6.2831853 * u.y, x = r * cos(f), y = r * sin(f), k = 0.5 + 0.5 " \
    "* w.z;\n"                                                                                     \
    "    y = mix(sqrt(max(1.0 - x * x, 0.0)), y, k);\n"                                            \
    "    vec3 n = x * t + y * s + sqrt(max(1.0 - x * x - y * y, 0.0)) * w;\n"                      \
    "    return normalize(vec3(a * n.xy, max(n.z, 1e-6)));\n}\n"

/* GLSL: the density of light direction l under that sampling, times pi. */
#define LOBE_SEEN                                                                                  \
    "float seen(vec3 v, vec3 l, float a) {\n"                                                      \
    "    vec3 h = normalize(v + l), c = cross(vec3(0.0, 0.0, 1.0), h);\n"                          \
    "    float d = a * a * h.z * h.z + dot(c, c), g = 2.0 * v.z / (v.z + sqrt(a * a + (1.0 - a * " \
    "a) * v.z * v.z));\n"                                                                          \
    "    return g * a * a / (d * d * 4.0 * v.z);\n}\n"

/* Directional albedos of GGX with height-correlated Smith masking, by sampling visible normals:
 * 1 - E, and the albedo of Schlick's term (1 - cosine)^5 relative to E. */
static inline void lobe_albedo(double cosine, double alpha, double found[2])
{
    enum { RINGS = LOBE_RINGS, TURNS = LOBE_TURNS };
    const double vx = sqrt(fmax(1 - cosine * cosine, 0)), size = hypot(alpha * vx, cosine),
                 wx = alpha * vx / size, wz = cosine / size;
    const double eye = sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
    double all = 0, fresnel = 0;
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double r = sqrt((i / TURNS + .5) / RINGS),
                     turn = 2 * LOBE_PI * (i % TURNS + .5) / TURNS, t = r * cos(turn),
                     k = .5 + .5 * wz;
        const double s = (1 - k) * sqrt(fmax(1 - t * t, 0)) + k * r * sin(turn),
                     up = sqrt(fmax(1 - t * t - s * s, 0));
        double h[3] = {alpha * (s * -wz + up * wx), alpha * t, fmax(s * wx + up * wz, 0)};
        const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]),
                     facing = (vx * h[0] + cosine * h[2]) / length;
        const double l = 2 * facing * h[2] / length - cosine;
        if (l <= 0 || facing <= 0)
            continue;
        const double light = sqrt(alpha * alpha + (1 - alpha * alpha) * l * l);
        /* G2 / G1: the weight of a sampled visible normal */
        const double share = l * (cosine + eye) / (cosine * light + l * eye);
        all += share;
        fresnel += share * pow(1 - facing, 5);
    }
    found[0] = 1 - all / (RINGS * TURNS);
    found[1] = fresnel / (RINGS * TURNS);
}

/* Cosine-weighted means over all directions: 2 cosine d cosine. */
static inline void lobe_mean(double alpha, double found[2])
{
    enum { STEPS = 24 };
    found[0] = found[1] = 0;
    for (int i = 0; i < STEPS; i++) {
        const double t = (i + .5) / STEPS;
        double one[2];
        lobe_albedo(t * t, alpha, one);
        for (int k = 0; k < 2; k++)
            found[k] += one[k] * 4 * t * t * t / STEPS;
    }
}

/* Checks reciprocity: the first three components of a pixel are the difference of both
 * directions relative to their sum. */
static inline void lobe_changes_places(float (*reported)[4], int count)
{
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, fmax((double)reported[i][0],
                                 fmax((double)reported[i][1], (double)reported[i][2])));
    print_message("changed places: within %.1e\n", worst);
    assert_true(worst < 2e-5);
}

/* Checks the white furnace: component 0 is the reflection of uniform light of radiance 1. */
static inline void lobe_is_white_around(float (*reported)[4], int count)
{
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, fabs((double)reported[i][0] - 1));
    print_message("from all around: within %.4f\n", worst);
    assert_true(worst < .01);
}
#endif
