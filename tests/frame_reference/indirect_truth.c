/* Traces many rays at sample places of a picture. */
#include "tests/frame_reference/indirect_truth.h"
#include <math.h>

void indirect_truth_find(const Scene *scene, const OpenRays *rays, const MatcOptions *options,
                         IndirectTruth *truth)
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
                truth->count == INDIRECT_TRUTH_MAX)
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
            const double off = light ? ((double)is[k] - open->light[k]) / truth->light
                                     : (double)is[0] - open->open;
            sum += off * off / 3;
        }
    return sqrt(sum / truth->count);
}
