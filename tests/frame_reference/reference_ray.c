#include "runtime/tessellate/scene_solid.h"
#include "tests/frame_reference/reference_ray.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

Ray reference_ray(const Scene *scene, double x, double y)
{
    const SceneCamera *c = &scene->camera;
    const double shorter = scene->width < scene->height ? scene->width : scene->height;
    const double right = (2 * x - scene->width) / shorter * c->half,
                 up = (2 * y - scene->height) / shorter * c->half;
    Ray ray;
    for (int i = 0; i < 3; i++) {
        const double aside = right * c->right[i] + up * c->up[i];
        const bool far = c->kind == SCENE_Orthographic;
        ray.at[i] = c->position[i] + (far ? aside : 0);
        ray.way[i] = -c->back[i] + (far ? 0 : aside);
    }
    return ray;
}

/* Moeller and Trumbore: corner + s a + t b = at + d way, in the object's space, for a triangle
 * that is known to be hit. */
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

static double reference_mix(const ShapeVertex *corner[3], const double st[2], size_t offset,
                            int component)
{
    float value[3];
    for (int k = 0; k < 3; k++)
        memcpy(&value[k], (const char *)corner[k] + offset + (size_t)component * sizeof(float),
               sizeof(float));
    return value[0] + st[0] * ((double)value[1] - value[0]) + st[1] * ((double)value[2] - value[0]);
}

/* Position and texture coordinates before displacement. */
static double reference_base(const Shape *shape, const ShapeVertex *corner[3], const double st[2],
                             int component)
{
    double value[3];
    for (int k = 0; k < 3; k++)
        value[k] = (double)shape->base[corner[k] - shape->vertices][component];
    return value[0] + st[0] * (value[1] - value[0]) + st[1] * (value[2] - value[0]);
}

/* Along the triangle's sides the normal n changes by n_s and n_t, and u and v likewise: n_u =
 * (n_s v_t - n_t v_s) / (u_s v_t - u_t v_s), and n_v correspondingly. The transformed normal has
 * the derivatives of a normalized vector. */
static void reference_bend(const SceneObject *object, const ShapeVertex *corner[3],
                           const double normal[3], double slopes[2][3])
{
    double n[2][3], uv[2][2], whole[3];
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < 3; i++)
            n[side][i] = (double)corner[side + 1]->normal[i] - (double)corner[0]->normal[i];
        for (int i = 0; i < 2; i++)
            uv[side][i] = (double)corner[side + 1]->uv[i] - (double)corner[0]->uv[i];
    }
    const double d = uv[0][0] * uv[1][1] - uv[1][0] * uv[0][1];
    reference_across(&object->world_from_local, normal, whole);
    const double square = reference_dot(whole, whole);
    for (int by = 0; by < 2; by++) {
        double local[3], world[3];
        for (int i = 0; i < 3; i++)
            local[i] = d == 0 ? 0 : (n[by][i] * uv[!by][!by] - n[!by][i] * uv[by][!by]) / d;
        reference_across(&object->world_from_local, local, world);
        const double along = reference_dot(world, whole) / square;
        for (int i = 0; i < 3; i++)
            slopes[by][i] = (world[i] - along * whole[i]) / sqrt(square);
    }
}

/* Derivatives of a tangent, given by its offset in a vertex, transformed to the world. */
static void reference_swing(const SceneObject *object, const ShapeVertex *corner[3], size_t tangent,
                            double slopes[2][3])
{
    double t[2][3], uv[2][2];
    for (int side = 0; side < 2; side++) {
        const float *here = (const float *)(const void *)((const char *)corner[side + 1] + tangent),
                    *first = (const float *)(const void *)((const char *)corner[0] + tangent);
        for (int i = 0; i < 3; i++)
            t[side][i] = (double)here[i] - (double)first[i];
        for (int i = 0; i < 2; i++)
            uv[side][i] = (double)corner[side + 1]->uv[i] - (double)corner[0]->uv[i];
    }
    const double d = uv[0][0] * uv[1][1] - uv[1][0] * uv[0][1];
    for (int by = 0; by < 2; by++) {
        double local[3];
        for (int i = 0; i < 3; i++)
            local[i] = d == 0 ? 0 : (t[by][i] * uv[!by][!by] - t[!by][i] * uv[by][!by]) / d;
        reference_image(&object->world_from_local, local, 0, slopes[by]);
    }
}

static void reference_fill(const SceneObject *object, const Shape *shape,
                           const ShapeVertex *corner[3], const double st[2], Hit *hit)
{
    double normal[3], position[3], (*tangent)[3] = hit->local_tangents;
    for (int i = 0; i < 3; i++) {
        position[i] = reference_mix(corner, st, offsetof(ShapeVertex, position), i);
        hit->local[i] = shape->base ? reference_base(shape, corner, st, i) : position[i];
        normal[i] = reference_mix(corner, st, offsetof(ShapeVertex, normal), i);
        tangent[0][i] = reference_mix(corner, st, offsetof(ShapeVertex, tangentU), i);
        tangent[1][i] = reference_mix(corner, st, offsetof(ShapeVertex, tangentV), i);
    }
    for (int i = 0; i < 2; i++) {
        hit->uv[i] = reference_mix(corner, st, offsetof(ShapeVertex, uv), i);
        reference_image(&object->world_from_local, tangent[i], 0, hit->tangents[i]);
    }
    reference_image(&object->world_from_local, position, 1, hit->world);
    reference_image(&object->world_from_local, hit->local, 1, hit->base);
    reference_normal(&object->world_from_local, normal, hit->normal);
    reference_bend(object, corner, normal, hit->normal_slopes);
    reference_swing(object, corner, offsetof(ShapeVertex, tangentU), hit->tangent_slopes[0]);
    reference_swing(object, corner, offsetof(ShapeVertex, tangentV), hit->tangent_slopes[1]);
}

/* The hit point on a triangle; `way` is not normalized, so that the distance is equal in both
 * spaces. */
static void reference_triangle(const SceneObject *object, const Shape *shape, unsigned triangle,
                               const Ray *world, Hit *hit)
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
    reference_normal(&object->world_from_local, face, hit->microfacet);
    reference_fill(object, shape, corner, st, hit);
}

void reference_plane(const SceneObject *object, const Ray *world, double behind, Hit *hit)
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
        memcpy(hit->local_tangents[i], axes[i], sizeof axes[i]);
        reference_image(&object->world_from_local, axes[i], 0, hit->tangents[i]);
    }
    reference_image(&object->world_from_local, hit->local, 1, hit->world);
    memcpy(hit->base, hit->world, sizeof hit->base);
    reference_normal(&object->world_from_local, z, hit->normal);
    memset(hit->normal_slopes, 0, sizeof hit->normal_slopes);
    memset(hit->tangent_slopes, 0, sizeof hit->tangent_slopes);
    memcpy(hit->microfacet, hit->normal, sizeof hit->microfacet);
}

bool reference_is_blocked(const Tracer *tracer, const double from[3], const double way[3],
                          double far)
{
    struct RTCIntersectContext context;
    struct RTCRay ray = {.org_x = (float)from[0],
                         .org_y = (float)from[1],
                         .org_z = (float)from[2],
                         .dir_x = (float)way[0],
                         .dir_y = (float)way[1],
                         .dir_z = (float)way[2],
                         .tfar = (float)far,
                         .mask = ~0u};
    rtcInitIntersectContext(&context);
    rtcOccluded1(tracer->traced, &context, &ray);
    return ray.tfar < 0;
}

Hit reference_hit(const Tracer *tracer, const Ray *ray, double behind)
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
        reference_triangle(&scene->objects[hit.object], &tracer->shapes[hit.object],
                           found.hit.primID, ray, &hit);
    }
    for (int i = 0; i < scene->object_count; i++) {
        const double before = hit.distance;
        if (scene->objects[i].kind == SCENE_Plane)
            reference_plane(&scene->objects[i], ray, behind, &hit);
        hit.object = hit.distance < before ? i : hit.object;
    }
    return hit;
}

/* True for different objects, or different faces of one object. */
static bool reference_differs(const Hit *a, const Hit *b)
{
    return a->object != b->object ||
           (a->object >= 0 && (reference_dot(a->normal, b->normal) < 0.9 || a->front != b->front));
}

bool reference_is_edge(const Tracer *tracer, int x, int y, const Hit *hits, int count)
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

/* Adds an object's triangles, in world space. */
static void reference_add(const Tracer *tracer, int number)
{
    const SceneObject *object = &tracer->scene->objects[number];
    const Shape *shape = &tracer->shapes[number];
    RTCGeometry geometry = rtcNewGeometry(tracer->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), (size_t)shape->vertex_count);
    void *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(uint32_t), (size_t)shape->index_count / 3);
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

Tracer reference_open(const Scene *scene)
{
    Tracer tracer = {.scene = scene,
                     .shapes = calloc((size_t)scene->object_count + 1, sizeof *tracer.shapes),
                     .device = rtcNewDevice("threads=1")};
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

void reference_close(Tracer *tracer)
{
    for (int i = 0; i < tracer->scene->object_count; i++)
        if (tracer->scene->objects[i].kind != SCENE_Mesh)
            shape_free(&tracer->shapes[i]);
    free(tracer->shapes);
    rtcReleaseScene(tracer->traced);
    rtcReleaseDevice(tracer->device);
}
