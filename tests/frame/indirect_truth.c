/* Places of a picture, each with many rays. */
#include "tests/frame/indirect_truth.h"
#include <math.h>

const char indirect_truth_box[] =
    "camera: { camera: Perspective, position: [0, -4.25, 1], target: [0, 0, 1], angle: 39 }\n"
    "lights: [{ light: Point, position: [.1, -.4, 1.5], intensity: 1, shadows: none }]\nmaterials:\n"
    "  white: { material: Phong, diffuse: .75, specular: 0 }\n  red: { material: Phong, diffuse: [.63, .06, .05], "
    "specular: 0 }\n"
    "  green: { material: Phong, diffuse: [.15, .48, .09], specular: 0 }\nobjects:\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, -.05] } }\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, 2.05] } }\n"
    "- { object: Box, size: [2.2, .1, 2.2], material: white, transform: { translation: [0, 1.05, 1] } }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: red, transform: { translation: [-1.05, 0, 1] } }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: green, transform: { translation: [1.05, 0, 1] } }\n"
    "- { object: Box, size: [.6, .6, 1.2], material: white, transform: { translation: [-.35, .3, .6], rotation: [0, 0, "
    ".3] } }\n"
    "- { object: Box, size: [.6, .6, .6], material: white, transform: { translation: [.37, -.35, .3], rotation: [0, 0, "
    "-.3] } }\n";

void indirect_truth_find(const Scene *scene, const OpenRays *rays, const MatcOptions *options, IndirectTruth *truth)
{
    Tracer tracer = reference_open(scene);
    truth->count = 0;
    truth->light = 0;
    for (int y = INDIRECT_TRUTH_APART / 2; y < scene->height; y += INDIRECT_TRUTH_APART)
        for (int x = INDIRECT_TRUTH_APART / 2; x < scene->width; x += INDIRECT_TRUTH_APART) {
            const Ray ray = reference_ray(scene, x + .5, y + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            OpenRays own = *rays;
            own.state = (uint64_t)(y * scene->width + x);
            if (!isfinite(hit.distance) || reference_is_edge(&tracer, x, y, &hit, 1) ||
                truth->count == INDIRECT_TRUTH_MOST)
                continue;
            IndirectPlace *place = &truth->places[truth->count++];
            *place = (IndirectPlace){y * scene->width + x, open_ray(&tracer, &hit, &own, options)};
            for (int k = 0; k < 3; k++)
                truth->light += place->open.light[k] / 3;
        }
    truth->light /= truth->count;
    reference_close(&tracer);
}

double indirect_truth_more(const IndirectTruth *truth, const float *rgba)
{
    double mean = 0;
    for (int i = 0; i < 3 * truth->count; i++)
        mean += rgba[4 * truth->places[i / 3].pixel + i % 3] / (3. * truth->count);
    return mean / truth->light - 1;
}

double indirect_truth_off(const IndirectTruth *truth, const float *rgba, bool light)
{
    double sum = 0;
    for (int i = 0; i < truth->count; i++)
        for (int k = 0; k < 3; k++) {
            const float *is = rgba + 4 * truth->places[i].pixel;
            const Open *open = &truth->places[i].open;
            const double off = light ? ((double)is[k] - open->light[k]) / truth->light : (double)is[0] - open->open;
            sum += off * off / 3;
        }
    return sqrt(sum / truth->count);
}
