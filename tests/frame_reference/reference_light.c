#include "tests/frame_reference/reference_light.h"
#include "compiler/evaluate.h"
#include "tests/area_reference.h"
#include <math.h>
#include <string.h>

static Surface reference_surface(const Hit *hit)
{
    Surface surface;
    oracle_surface_default(&surface);
    surface.front = hit->front;
    for (int i = 0; i < 3; i++) {
        surface.root[channel_id(GROUP_P, i)] = hit->base[i];
        surface.root[channel_id(GROUP_X, i)] = hit->local[i];
        surface.root[channel_id(GROUP_N, i)] = hit->normal[i];
        surface.root[channel_id(GROUP_DU, i)] = hit->tangents[0][i];
        surface.root[channel_id(GROUP_DV, i)] = hit->tangents[1][i];
        surface.root[channel_id(GROUP_U, i)] = i < 2 ? hit->uv[i] : 0;
        surface.local_u[i] = hit->local_tangents[0][i];
        surface.local_v[i] = hit->local_tangents[1][i];
        surface.normal_u[i] = hit->normal_slopes[0][i];
        surface.normal_v[i] = hit->normal_slopes[1][i];
    }
    memcpy(surface.tangent_slopes, hit->tangent_slopes, sizeof surface.tangent_slopes);
    return surface;
}

/* Light that arrives at a point, and its direction, by the formulas of scene.def. */
static double reference_arrives(const SceneLight *light, const double point[3], double l[3])
{
    double square = 1, cosine;
    for (int i = 0; i < 3; i++)
        l[i] =
            light->kind == SCENE_Directional ? -light->direction[i] : light->position[i] - point[i];
    if (light->kind != SCENE_Directional)
        square = reference_dot(l, l);
    reference_normalize(l);
    if (light->kind != SCENE_Spot)
        return 1 / square;
    cosine = -reference_dot(l, light->direction);
    const double s = (cosine - light->outer_cosine) / (light->inner_cosine - light->outer_cosine);
    return s <= 0 ? 0 : s >= 1 ? 1 / square : s * s * (3 - 2 * s) / square;
}

/* Share of diffuse and specular light left by transparency. */
static double reference_kept(const SlotValues *slots, int component)
{
    return slots->component[SLOT_interpolatedTransparency][0] != 0
               ? 1 - slots->component[SLOT_transparency][component]
               : 1;
}

/* Factors of a parallelogram's radiance for each component. Straight transmission has no cosine
 * except that of its power, and its light comes from the part of the parallelogram behind the
 * surface. */
static void reference_area(const SceneLight *light, const Hit *hit, const double reflected[3],
                           const SlotValues *slots, double shares[3])
{
    AreaCase c = {.both_sides = light->both_sides}, behind, on;
    const double *n = slots->component[SLOT_normal];
    for (int i = 0; i < 3; i++) {
        c.corner[i] = light->position[i] - hit->world[i];
        c.u[i] = light->edges[0][i];
        c.v[i] = light->edges[1][i];
        c.normal[i] = slots->component[SLOT_normal][i];
        c.w[i] = reflected[i];
    }
    behind = c;
    for (int i = 0; i < 3; i++)
        behind.normal[i] = -c.normal[i];
    on = behind;
    for (int i = 0; i < 3; i++)
        on.normal[i] = on.w[i] = reflected[i] - 2 * reference_dot(reflected, n) * n[i];
    on.exponent = fmax(slots->component[SLOT_transparencyShininess][0] - 1, 0);
    c.exponent = slots->component[SLOT_shininess][0];
    const double front = area_lambert(&c), back = area_lambert(&behind);
    const double lobe = slots->component[SLOT_specular][0] <= 0 ? 0
                        : c.exponent == floor(c.exponent)       ? area_moment(&c)
                                                                : area_integral(&c);
    const double straight =
        slots->component[SLOT_transparency][0] <= 0 || area_lambert(&behind) <= 0
            ? 0
            : area_integral(&on);
    for (int i = 0; i < 3; i++)
        shares[i] = reference_kept(slots, i) * (slots->component[SLOT_diffuse][i] * front +
                                                slots->component[SLOT_specular][i] * lobe) +
                    slots->component[SLOT_diffuseTransparency][i] * back +
                    slots->component[SLOT_transparency][i] * straight;
}

/* Ambient light from a direction of height z, diffuse or mirrored. */
static double reference_around(const SceneLight *light, int component, double z, bool mirror)
{
    const double s = fmin(fmax((z + .3) / .8, 0), 1),
                 ground = mirror ? .6 * light->ground[component] : light->ground[component];
    return ground +
           (light->light[component] - ground) * (mirror ? s * s * (3 - 2 * s) : (1 + z) / 2);
}

/* Light of a Hemisphere; `normal` and `reflected` are in world space. */
static double reference_hemisphere(const SceneLight *light, const SlotValues *slots, int component,
                                   const double reflected[3])
{
    const double z = slots->component[SLOT_normal][2], kept = reference_kept(slots, component);
    return (kept * slots->component[SLOT_diffuse][component] +
            slots->component[SLOT_ambient][component]) *
               reference_around(light, component, z, false) +
           kept * slots->component[SLOT_specular][component] *
               reference_around(light, component, reflected[2], true) +
           slots->component[SLOT_diffuseTransparency][component] *
               reference_around(light, component, -z, false);
}

/* semantics.md 4.1 with a relative index of 1: no refraction, and r is 0. k_d and k_s are the
 * shares of diffuse and specular left by interpolated transparency. Ambient and emissive give L;
 * light on the eye's side (k_d + k_s max(R.l, 0)^n) |n.l| L; light on the other side |n.l| k L,
 * and t max(T.l, 0)^m L, with T the straight direction and m the exponent of
 * transparencyShininess: the greatest exponent is a Dirac lobe, 0 the ray tracer's sum. */
static void reference_shade(const Tracer *tracer, const Hit *hit, const Ray *ray,
                            const SlotValues *slots, double sum[3])
{
    const Scene *scene = tracer->scene;
    double view[3], n[3], reflected[3], l[3];
    memcpy(view, ray->way, sizeof view);
    reference_normalize(view);
    memcpy(n, slots->component[SLOT_normal], sizeof n); /* faces the eye */
    for (int i = 0; i < 3; i++) {
        reflected[i] = view[i] - 2 * reference_dot(view, n) * n[i];
        sum[i] = slots->component[SLOT_emissive][i];
    }
    for (int k = 0; k < scene->light_count; k++) {
        const SceneLight *light = &scene->lights[k];
        double shares[3], passes[3] = {1, 1, 1};
        if (light->kind == SCENE_Area) {
            reference_area(light, hit, reflected, slots, shares);
            for (int i = 0; i < 3; i++)
                sum[i] += light->light[i] * shares[i];
            continue;
        }
        if (light->kind == SCENE_Hemisphere) {
            for (int i = 0; i < 3; i++)
                sum[i] += reference_hemisphere(light, slots, i, reflected);
            continue;
        }
        if (tracer->shares && light->kind != SCENE_Ambient)
            tracer->shares(tracer, light, hit, passes);
        const double arrives = reference_arrives(light, hit->world, l),
                     cosine = reference_dot(n, l);
        const double lobe =
            pow(fmax(reference_dot(reflected, l), 0), slots->component[SLOT_shininess][0]);
        const double on =
            pow(fmax(reference_dot(view, l), 0), slots->component[SLOT_transparencyShininess][0]);
        for (int i = 0; i < 3; i++) {
            const double t = slots->component[SLOT_transparency][i];
            const double front =
                reference_kept(slots, i) *
                (slots->component[SLOT_diffuse][i] + slots->component[SLOT_specular][i] * lobe);
            const double back =
                slots->component[SLOT_diffuseTransparency][i] * fabs(cosine) + t * on;
            if (light->kind == SCENE_Ambient)
                sum[i] += slots->component[SLOT_ambient][i] * light->light[i];
            else
                sum[i] +=
                    (cosine > 0 ? cosine * front : back) * light->light[i] * arrives * passes[i];
        }
    }
}

/* Light of the sky along a ray: diffuse and emissive of the sky's material. */
static void reference_sky(const Scene *scene, const Ray *ray, const MatcOptions *options,
                          double sum[3])
{
    SlotValues slots;
    Surface surface;
    double way[3];
    memcpy(way, ray->way, sizeof way);
    reference_normalize(way);
    oracle_surface_default(&surface);
    for (int i = 0; i < 3; i++)
        surface.root[channel_id(GROUP_P, i)] = surface.root[channel_id(GROUP_X, i)] = way[i];
    const SceneMaterial *sky = &scene->materials[scene->sky];
    evaluate_material(sky->document, sky->index, options, (SurfacePoints){&surface, 1}, &slots);
    for (int i = 0; i < 3; i++)
        sum[i] = slots.component[SLOT_diffuse][i] + slots.component[SLOT_emissive][i];
}

/* A surface's light, [0], and its transmittance, [1]. */
static void reference_layer(const Tracer *tracer, const Hit *hit, const Ray *ray,
                            const MatcOptions *options, double layer[2][3])
{
    SlotValues slots;
    const Scene *scene = tracer->scene;
    const SceneMaterial *material = &scene->materials[scene->objects[hit->object].material];
    const Surface surface = reference_surface(hit);
    evaluate_material(material->document, material->index, options, (SurfacePoints){&surface, 1},
                      &slots);
    reference_shade(tracer, hit, ray, &slots, layer[0]);
    memcpy(layer[1], slots.component[SLOT_transparency], sizeof layer[1]);
}

void reference_surface_light(const Tracer *tracer, const Hit *hit, const Ray *ray,
                             const MatcOptions *options, double light[3])
{
    double layer[2][3];
    reference_layer(tracer, hit, ray, options, layer);
    memcpy(light, layer[0], sizeof layer[0]);
}

void reference_surface_diffuse(const Tracer *tracer, const Hit *hit, const MatcOptions *options,
                               double diffuse[3])
{
    SlotValues slots;
    const SceneMaterial *material =
        &tracer->scene->materials[tracer->scene->objects[hit->object].material];
    const Surface surface = reference_surface(hit);
    evaluate_material(material->document, material->index, options, (SurfacePoints){&surface, 1},
                      &slots);
    for (int i = 0; i < 3; i++)
        diffuse[i] = reference_kept(&slots, i) * slots.component[SLOT_diffuse][i];
}

int reference_pixel(const Tracer *tracer, const Ray *ray, const MatcOptions *options, double sum[3],
                    Hit hits[REFERENCE_LAYERS])
{
    const Scene *scene = tracer->scene;
    double passes[3] = {1, 1, 1}, layer[2][3], behind = 0;
    int count = 0;
    memset(sum, 0, 3 * sizeof *sum);
    while (passes[0] + passes[1] + passes[2] > 0 && count < REFERENCE_LAYERS) {
        const Hit *hit = &hits[count];
        hits[count++] = reference_hit(tracer, ray, behind);
        behind = hit->distance * (1 + 1e-5);
        memset(layer, 0, sizeof layer);
        if (hit->object >= 0)
            reference_layer(tracer, hit, ray, options, layer);
        else if (scene->sky >= 0)
            reference_sky(scene, ray, options, layer[0]);
        for (int i = 0; i < 3; i++) {
            sum[i] += passes[i] * layer[0][i];
            passes[i] *= layer[1][i];
        }
    }
    return count;
}

Sample reference_sample(const Tracer *tracer, int x, int y, const MatcOptions *options)
{
    Sample sample;
    Hit hits[REFERENCE_LAYERS];
    const Ray ray = reference_ray(tracer->scene, x + .5, y + .5);
    const int count = reference_pixel(tracer, &ray, options, sample.light, hits);
    sample.nothing = hits[0].object < 0;
    sample.edge = reference_is_edge(tracer, x, y, hits, count);
    return sample;
}
