/* What a frame's light should be, in double, for tests: Embree finds the triangle that a pixel's ray meets, the point on it is computed in double,
 * the material there is the C oracle's, the light is summed by the formulas of semantics.md 4.1 and scene.def. It shares the triangles
 * with the renderer, and nothing else: no matrix, no shader, no compiler. */
#ifndef MATC_FRAME_REFERENCE_H
#define MATC_FRAME_REFERENCE_H
#include "area_reference.h"
#include "compiler/evaluate.h"
#include "runtime/scene/scene.h"
#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    double light[3]; /* linear */
    bool edge;       /* something else is within a pixel of it */
    bool nothing;    /* no object is there */
} Sample;

typedef struct {
    double at[3], way[3]; /* at + t way */
} Ray;

/* What a ray meets first. */
typedef struct {
    double distance; /* infinite: nothing */
    int object;
    double world[3], local[3], uv[2], normal[3], tangents[2][3];
    double facet[3]; /* the normal of the triangle, or of the plane */
    bool front;
} Hit;

static double reference_dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void reference_cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void reference_normalize(double v[3])
{
    const double length = sqrt(reference_dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* Of a point (w 1) or a vector (w 0). */
static void reference_image(const SceneMatrix *m, const double v[3], double w, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m->m[i] * v[0] + m->m[4 + i] * v[1] + m->m[8 + i] * v[2] + m->m[12 + i] * w;
}

/* The preimage, by Cramer's rule. */
static void reference_preimage(const SceneMatrix *m, const double v[3], double w, double out[3])
{
    double moved[3], cross[3];
    for (int i = 0; i < 3; i++)
        moved[i] = v[i] - m->m[12 + i] * w;
    const double *c[3] = {m->m, m->m + 4, m->m + 8};
    reference_cross(c[1], c[2], cross);
    const double determinant = reference_dot(c[0], cross);
    for (int i = 0; i < 3; i++) {
        reference_cross(c[(i + 1) % 3], c[(i + 2) % 3], cross);
        out[i] = reference_dot(moved, cross) / determinant;
    }
}

/* A normal's image: the inverse's transpose, up to length; its columns are cross products of the matrix's. */
static void reference_normal(const SceneMatrix *m, const double n[3], double out[3])
{
    const double *c[3] = {m->m, m->m + 4, m->m + 8};
    double cross[3], determinant[3];
    reference_cross(c[1], c[2], determinant);
    const double sign = reference_dot(c[0], determinant) < 0 ? -1 : 1;
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < 3; i++) {
        reference_cross(c[(i + 1) % 3], c[(i + 2) % 3], cross);
        for (int lane = 0; lane < 3; lane++)
            out[lane] += sign * n[i] * cross[lane];
    }
    reference_normalize(out);
}

static Ray reference_ray(const Scene *scene, double x, double y)
{
    const SceneCamera *c = &scene->camera;
    const double shorter = scene->width < scene->height ? scene->width : scene->height;
    const double right = (2 * x - scene->width) / shorter * c->half, up = (2 * y - scene->height) / shorter * c->half;
    Ray ray;
    for (int i = 0; i < 3; i++) {
        const double aside = right * c->right[i] + up * c->up[i];
        const bool far = c->kind == SCENE_Orthographic;
        ray.at[i] = c->position[i] + (far ? aside : 0);
        ray.way[i] = -c->back[i] + (far ? 0 : aside);
    }
    return ray;
}

/* What rays are traced in; geometry i is object i, but for planes, which have none. */
typedef struct {
    const Scene *scene;
    Shape *shapes; /* of each object */
    RTCDevice device;
    RTCScene traced;
} Tracer;

/* Moeller and Trumbore: corner + s a + t b = at + d way, in the object's space. The triangle is known to be met. */
static double reference_meets(const ShapeVertex *corner[3], const Ray *ray, double st[2])
{
    double a[3], b[3], from[3], p[3], q[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (double)corner[1]->position[i] - corner[0]->position[i];
        b[i] = (double)corner[2]->position[i] - corner[0]->position[i];
        from[i] = ray->at[i] - corner[0]->position[i];
    }
    reference_cross(ray->way, b, p);
    const double determinant = reference_dot(a, p);
    st[0] = reference_dot(from, p) / determinant;
    reference_cross(from, a, q);
    st[1] = reference_dot(ray->way, q) / determinant;
    return reference_dot(b, q) / determinant;
}

static double reference_mix(const ShapeVertex *corner[3], const double st[2], size_t offset, int lane)
{
    float value[3];
    for (int k = 0; k < 3; k++)
        memcpy(&value[k], (const char *)corner[k] + offset + (size_t)lane * sizeof(float), sizeof(float));
    return value[0] + st[0] * ((double)value[1] - value[0]) + st[1] * ((double)value[2] - value[0]);
}

static void reference_fill(const SceneObject *object, const ShapeVertex *corner[3], const double st[2], Hit *hit)
{
    double normal[3], tangent[2][3];
    for (int i = 0; i < 3; i++) {
        hit->local[i] = reference_mix(corner, st, offsetof(ShapeVertex, position), i);
        normal[i] = reference_mix(corner, st, offsetof(ShapeVertex, normal), i);
        tangent[0][i] = reference_mix(corner, st, offsetof(ShapeVertex, tangentU), i);
        tangent[1][i] = reference_mix(corner, st, offsetof(ShapeVertex, tangentV), i);
    }
    for (int i = 0; i < 2; i++) {
        hit->uv[i] = reference_mix(corner, st, offsetof(ShapeVertex, uv), i);
        reference_image(&object->world_from_local, tangent[i], 0, hit->tangents[i]);
    }
    reference_image(&object->world_from_local, hit->local, 1, hit->world);
    reference_normal(&object->world_from_local, normal, hit->normal);
}

/* The point on a triangle; `way` was not normalised, so that the distance is the same in both spaces. */
static void reference_triangle(const SceneObject *object, const Shape *shape, unsigned triangle, const Ray *world,
                               Hit *hit)
{
    const ShapeVertex *corner[3];
    double st[2], a[3], b[3], face[3];
    Ray ray;
    reference_preimage(&object->world_from_local, world->at, 1, ray.at);
    reference_preimage(&object->world_from_local, world->way, 0, ray.way);
    for (int k = 0; k < 3; k++)
        corner[k] = &shape->vertices[shape->indices[3 * triangle + (unsigned)k]];
    hit->distance = reference_meets(corner, &ray, st);
    for (int k = 0; k < 3; k++) {
        a[k] = (double)corner[1]->position[k] - corner[0]->position[k];
        b[k] = (double)corner[2]->position[k] - corner[0]->position[k];
    }
    reference_cross(a, b, face);
    hit->front = reference_dot(face, ray.way) < 0;
    reference_normal(&object->world_from_local, face, hit->facet);
    reference_fill(object, corner, st, hit);
}

/* z = 0 of the object's space. */
static void reference_plane(const SceneObject *object, const Ray *world, double behind, Hit *hit)
{
    static const double z[3] = {0, 0, 1}, axes[2][3] = {{1, 0, 0}, {0, 1, 0}};
    Ray ray;
    reference_preimage(&object->world_from_local, world->at, 1, ray.at);
    reference_preimage(&object->world_from_local, world->way, 0, ray.way);
    const double distance = -ray.at[2] / ray.way[2];
    if (!(distance > behind) || distance >= hit->distance)
        return;
    hit->distance = distance;
    hit->front = ray.way[2] < 0;
    for (int i = 0; i < 3; i++)
        hit->local[i] = i < 2 ? ray.at[i] + distance * ray.way[i] : 0;
    for (int i = 0; i < 2; i++) {
        hit->uv[i] = hit->local[i];
        reference_image(&object->world_from_local, axes[i], 0, hit->tangents[i]);
    }
    reference_image(&object->world_from_local, hit->local, 1, hit->world);
    reference_normal(&object->world_from_local, z, hit->normal);
    memcpy(hit->facet, hit->normal, sizeof hit->facet);
}

/* Behind a distance, as multiples of the ray's direction. */
static Hit reference_hit(const Tracer *tracer, const Ray *ray, double behind)
{
    const Scene *scene = tracer->scene;
    Hit hit = {.distance = INFINITY, .object = -1};
    struct RTCIntersectContext context;
    struct RTCRayHit found = {.ray = {.org_x = (float)ray->at[0],
                                      .org_y = (float)ray->at[1],
                                      .org_z = (float)ray->at[2],
                                      .dir_x = (float)ray->way[0],
                                      .dir_y = (float)ray->way[1],
                                      .dir_z = (float)ray->way[2],
                                      .tnear = (float)behind,
                                      .tfar = INFINITY,
                                      .mask = ~0u},
                              .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    rtcInitIntersectContext(&context);
    rtcIntersect1(tracer->traced, &context, &found);
    if (found.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        hit.object = (int)found.hit.geomID;
        reference_triangle(&scene->objects[hit.object], &tracer->shapes[hit.object], found.hit.primID, ray, &hit);
    }
    for (int i = 0; i < scene->object_count; i++) {
        const double before = hit.distance;
        if (scene->objects[i].kind == SCENE_Plane)
            reference_plane(&scene->objects[i], ray, behind, &hit);
        hit.object = hit.distance < before ? i : hit.object;
    }
    return hit;
}

static Surface reference_surface(const Hit *hit)
{
    Surface surface;
    oracle_surface_default(&surface);
    surface.front = hit->front;
    for (int i = 0; i < 3; i++) {
        surface.root[channel_id(GROUP_P, i)] = hit->world[i];
        surface.root[channel_id(GROUP_X, i)] = hit->local[i];
        surface.root[channel_id(GROUP_N, i)] = hit->normal[i];
        surface.root[channel_id(GROUP_DU, i)] = hit->tangents[0][i];
        surface.root[channel_id(GROUP_DV, i)] = hit->tangents[1][i];
        surface.root[channel_id(GROUP_U, i)] = i < 2 ? hit->uv[i] : 0;
    }
    return surface;
}

/* What a light sends to a point, and the way to it. scene.def has the formulas. */
static double reference_arrives(const SceneLight *light, const double point[3], double l[3])
{
    double square = 1, cosine;
    for (int i = 0; i < 3; i++)
        l[i] = light->kind == SCENE_Directional ? -light->direction[i] : light->position[i] - point[i];
    if (light->kind != SCENE_Directional)
        square = reference_dot(l, l);
    reference_normalize(l);
    if (light->kind != SCENE_Spot)
        return 1 / square;
    cosine = -reference_dot(l, light->direction);
    const double s = (cosine - light->outer_cosine) / (light->inner_cosine - light->outer_cosine);
    return s <= 0 ? 0 : s >= 1 ? 1 / square : s * s * (3 - 2 * s) / square;
}

/* What transparency leaves of diffuse and specular. */
static double reference_kept(const SlotValues *slots, int lane)
{
    return slots->lane[SLOT_interpolatedTransparency][0] != 0 ? 1 - slots->lane[SLOT_transparency][lane] : 1;
}

/* Light of a parallelogram: what its radiance is times for each lane. What comes straight through has no cosine but its power's, and comes
 * from a parallelogram that is all behind the surface. */
static void reference_area(const SceneLight *light, const Hit *hit, const double reflected[3], const SlotValues *slots,
                           double shares[3])
{
    AreaCase c = {.both_sides = light->both_sides}, behind, on;
    const double *n = slots->lane[SLOT_normal];
    for (int i = 0; i < 3; i++) {
        c.corner[i] = light->position[i] - hit->world[i];
        c.u[i] = light->edges[0][i];
        c.v[i] = light->edges[1][i];
        c.normal[i] = slots->lane[SLOT_normal][i];
        c.w[i] = reflected[i];
    }
    behind = c;
    for (int i = 0; i < 3; i++)
        behind.normal[i] = -c.normal[i];
    on = behind;
    for (int i = 0; i < 3; i++)
        on.normal[i] = on.w[i] = reflected[i] - 2 * reference_dot(reflected, n) * n[i];
    on.exponent = fmax(slots->lane[SLOT_transparencyShininess][0] - 1, 0);
    c.exponent = slots->lane[SLOT_shininess][0];
    const double front = area_lambert(&c), back = area_lambert(&behind);
    const double lobe = slots->lane[SLOT_specular][0] <= 0 ? 0
                        : c.exponent == floor(c.exponent)  ? area_moment(&c)
                                                           : area_integral(&c);
    const double straight =
        slots->lane[SLOT_transparency][0] <= 0 || area_lambert(&behind) <= 0 ? 0 : area_integral(&on);
    for (int i = 0; i < 3; i++)
        shares[i] =
            reference_kept(slots, i) * (slots->lane[SLOT_diffuse][i] * front + slots->lane[SLOT_specular][i] * lobe) +
            slots->lane[SLOT_diffuseTransparency][i] * back + slots->lane[SLOT_transparency][i] * straight;
}

/* semantics.md 4.1, with a ratio of indices of 1: nothing is refracted, and r is 0. k_d and k_s are what transparency leaves of diffuse and
 * specular where it is interpolated. emissive, ambient L; (k_d + k_s max(R.l, 0)^n) |n.l| L on the eye's side; on the other |n.l| k L, and
 * t max(T.l, 0)^m L, where T is the way on and m the exponent of transparencyShininess: the greatest one is Dirac's, 0 the ray tracer's sum. */
static void reference_shade(const Scene *scene, const Hit *hit, const Ray *ray, const SlotValues *slots, double sum[3])
{
    double view[3], n[3], reflected[3], l[3];
    memcpy(view, ray->way, sizeof view);
    reference_normalize(view);
    memcpy(n, slots->lane[SLOT_normal], sizeof n); /* it faces the eye */
    for (int i = 0; i < 3; i++) {
        reflected[i] = view[i] - 2 * reference_dot(view, n) * n[i];
        sum[i] = slots->lane[SLOT_emissive][i];
    }
    for (int k = 0; k < scene->light_count; k++) {
        const SceneLight *light = &scene->lights[k];
        double shares[3];
        if (light->kind == SCENE_Area) {
            reference_area(light, hit, reflected, slots, shares);
            for (int i = 0; i < 3; i++)
                sum[i] += light->light[i] * shares[i];
            continue;
        }
        const double arrives = reference_arrives(light, hit->world, l), cosine = reference_dot(n, l);
        const double lobe = pow(fmax(reference_dot(reflected, l), 0), slots->lane[SLOT_shininess][0]);
        const double on = pow(fmax(reference_dot(view, l), 0), slots->lane[SLOT_transparencyShininess][0]);
        for (int i = 0; i < 3; i++) {
            const double t = slots->lane[SLOT_transparency][i];
            const double front =
                reference_kept(slots, i) * (slots->lane[SLOT_diffuse][i] + slots->lane[SLOT_specular][i] * lobe);
            const double back = slots->lane[SLOT_diffuseTransparency][i] * fabs(cosine) + t * on;
            if (light->kind == SCENE_Ambient)
                sum[i] += slots->lane[SLOT_ambient][i] * light->light[i];
            else
                sum[i] += (cosine > 0 ? cosine * front : back) * light->light[i] * arrives;
        }
    }
}

/* A sky of light along the ray: diffuse and emissive of its material. */
static void reference_sky(const Scene *scene, const Ray *ray, const MatcOptions *options, double sum[3])
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
        sum[i] = slots.lane[SLOT_diffuse][i] + slots.lane[SLOT_emissive][i];
}

/* A surface's light, [0], and the share of what is behind it that passes, [1]. */
static void reference_layer(const Scene *scene, const Hit *hit, const Ray *ray, const MatcOptions *options,
                            double layer[2][3])
{
    SlotValues slots;
    const SceneMaterial *material = &scene->materials[scene->objects[hit->object].material];
    const Surface surface = reference_surface(hit);
    evaluate_material(material->document, material->index, options, (SurfacePoints){&surface, 1}, &slots);
    reference_shade(scene, hit, ray, &slots, layer[0]);
    memcpy(layer[1], slots.lane[SLOT_transparency], sizeof layer[1]);
}

enum { REFERENCE_LAYERS = 64 };

/* Front to back, until nothing passes, the sky last. Returns how many surfaces count, and behind them what ends it. */
static int reference_pixel(const Tracer *tracer, const Ray *ray, const MatcOptions *options, double sum[3],
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
            reference_layer(scene, hit, ray, options, layer);
        else if (scene->sky >= 0)
            reference_sky(scene, ray, options, layer[0]);
        for (int i = 0; i < 3; i++) {
            sum[i] += passes[i] * layer[0][i];
            passes[i] *= layer[1][i];
        }
    }
    return count;
}

/* Another object, or another face of it. */
static bool reference_differs(const Hit *a, const Hit *b)
{
    return a->object != b->object ||
           (a->object >= 0 && (reference_dot(a->normal, b->normal) < 0.9 || a->front != b->front));
}

/* Triangles in the world. */
static void reference_add(const Tracer *tracer, int number)
{
    const SceneObject *object = &tracer->scene->objects[number];
    const Shape *shape = &tracer->shapes[number];
    RTCGeometry geometry = rtcNewGeometry(tracer->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                              (size_t)shape->vertex_count);
    void *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t),
                                            (size_t)shape->index_count / 3);
    for (int i = 0; i < shape->vertex_count; i++) {
        const float *p = shape->vertices[i].position;
        double world[3];
        reference_image(&object->world_from_local, (double[]){p[0], p[1], p[2]}, 1, world);
        for (int k = 0; k < 3; k++)
            vertices[3 * i + k] = (float)world[k];
    }
    memcpy(indices, shape->indices, (size_t)shape->index_count * sizeof *shape->indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(tracer->traced, geometry, (unsigned)number);
    rtcReleaseGeometry(geometry);
}

static Tracer reference_open(const Scene *scene)
{
    Tracer tracer = {scene, calloc((size_t)scene->object_count + 1, sizeof *tracer.shapes), rtcNewDevice("threads=1"),
                     NULL};
    if (!tracer.shapes || !tracer.device)
        abort();
    tracer.traced = rtcNewScene(tracer.device);
    rtcSetSceneFlags(tracer.traced, RTC_SCENE_FLAG_ROBUST);
    for (int i = 0; i < scene->object_count; i++) {
        const SceneObject *object = &scene->objects[i];
        if (object->kind == SCENE_Mesh)
            tracer.shapes[i] = scene->meshes[object->mesh].shape;
        else if (!scene_solid(object, &tracer.shapes[i]))
            abort();
        if (object->kind != SCENE_Plane)
            reference_add(&tracer, i);
    }
    rtcCommitScene(tracer.traced);
    return tracer;
}

static void reference_close(Tracer *tracer)
{
    for (int i = 0; i < tracer->scene->object_count; i++)
        if (tracer->scene->objects[i].kind != SCENE_Mesh)
            shape_free(&tracer->shapes[i]);
    free(tracer->shapes);
    rtcReleaseScene(tracer->traced);
    rtcReleaseDevice(tracer->device);
}

/* Whether a pixel's neighbours meet something else, in any layer that counts. */
static bool reference_is_edge(const Tracer *tracer, int x, int y, const Hit *hits, int count)
{
    for (int k = 0; k < 9; k++) {
        const Ray ray = reference_ray(tracer->scene, x + k % 3 - .5, y + k / 3 - .5);
        double behind = 0;
        for (int i = 0; i < count; i++) {
            const Hit other = reference_hit(tracer, &ray, behind);
            if (reference_differs(&hits[i], &other))
                return true;
            behind = other.distance * (1 + 1e-5);
        }
    }
    return false;
}

/* What pixel x, y should be. */
static inline Sample reference_sample(const Tracer *tracer, int x, int y, const MatcOptions *options)
{
    Sample sample;
    Hit hits[REFERENCE_LAYERS];
    const Ray ray = reference_ray(tracer->scene, x + .5, y + .5);
    const int count = reference_pixel(tracer, &ray, options, sample.light, hits);
    sample.nothing = hits[0].object < 0;
    sample.edge = reference_is_edge(tracer, x, y, hits, count);
    return sample;
}
#endif
