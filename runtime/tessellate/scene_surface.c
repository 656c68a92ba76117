/* Random points on surfaces. The first number selects a triangle, by area; the others a point in
 * it: in a triangle (a, b, c) the point (1 - s) a + s (1 - t) b + s t c is uniformly distributed
 * if s is the square root of a uniform number, as a strip at s has a length proportional to s.
 *
 *     a unit square of two triangles, prefix sums 0.5 and 1; numbers 0.75, 0.25, 0.5: the second
 *     one, s = 0.5, t = 0.5 */
#include "runtime/scene/scene_places.h"
#include "runtime/tessellate/scene_solid.h"
#include "runtime/tessellate/scene_surface.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void transformed(const SceneMatrix *m, const float p[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m->m[i] * p[0] + m->m[4 + i] * p[1] + m->m[8 + i] * p[2] + m->m[12 + i];
}

/* Transforms a normal by the cofactor matrix, with the sign of the determinant, so that it keeps
 * pointing outside. */
static void transformed_normal(const SceneMatrix *m, const double n[3], double out[3])
{
    const double sign = scene_matrix_determinant(m) < 0 ? -1 : 1;
    double cross[3][3];
    for (int k = 0; k < 3; k++)
        vec3_cross(m->m + 4 * ((k + 1) % 3), m->m + 4 * ((k + 2) % 3), cross[k]);
    for (int i = 0; i < 3; i++)
        out[i] = sign * (cross[0][i] * n[0] + cross[1][i] * n[1] + cross[2][i] * n[2]);
}

static const ShapeVertex *corner(const SceneSurfacePart *patch, int triangle, int k)
{
    return &patch->shape.vertices[patch->shape.indices[3 * (triangle - patch->first) + k]];
}

static void corners_of(const SceneSurfacePart *patch, int triangle, double corners[3][3])
{
    for (int k = 0; k < 3; k++)
        transformed(&patch->matrix, corner(patch, triangle, k)->position, corners[k]);
}

/* Sets twice the area, as a vector along the normal of the front. */
static void span_of(double corners[3][3], double span[3])
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = corners[1][i] - corners[0][i];
        v[i] = corners[2][i] - corners[0][i];
    }
    vec3_cross(u, v, span);
}

static bool make_patch(const Scene *scene, const SceneObject *object, SceneSurfacePart *patch)
{
    *patch =
        (SceneSurfacePart){.made = object->kind != SCENE_Mesh, .matrix = object->world_from_local};
    if (patch->made)
        return scene_solid(object, &patch->shape);
    patch->shape = scene->meshes[object->mesh].shape;
    return true;
}

static bool sum_areas(SceneSurface *made)
{
    double sum = 0;
    made->sums = malloc(((size_t)made->count + 1) * sizeof *made->sums);
    for (int i = 0, triangle = 0; made->sums && i < made->patch_count; i++)
        for (; triangle < made->patches[i].first + made->patches[i].shape.index_count / 3;
             triangle++) {
            double corners[3][3], span[3];
            corners_of(&made->patches[i], triangle, corners);
            span_of(corners, span);
            made->sums[triangle] = sum += sqrt(vec3_dot(span, span)) / 2;
        }
    return made->sums != NULL;
}

bool scene_surface_make(const Scene *scene, const SceneObject *objects, int count,
                        SceneSurface *made)
{
    *made = (SceneSurface){.patches = calloc((size_t)count + 1, sizeof *made->patches)};
    bool fine = made->patches != NULL;
    for (int i = 0; fine && i < count; i++) {
        fine = make_patch(scene, &objects[i], &made->patches[i]);
        made->patches[i].first = made->count;
        made->patches[i].object = i;
        made->patch_count++;
        made->count += made->patches[i].shape.index_count / 3;
        fine = fine && made->count <= SCENE_SURFACE_TRIANGLES;
    }
    if (fine && sum_areas(made))
        return true;
    scene_surface_free(made);
    return false;
}

void scene_surface_free(SceneSurface *surface)
{
    for (int i = 0; i < surface->patch_count; i++) {
        if (surface->patches[i].made)
            shape_free(&surface->patches[i].shape);
        free(surface->patches[i].joined);
        free(surface->patches[i].place);
    }
    free(surface->patches);
    free(surface->sums);
    *surface = (SceneSurface){0};
}

double scene_surface_area(const SceneSurface *surface)
{
    return surface->count ? surface->sums[surface->count - 1] : 0;
}

/* Returns the first triangle whose prefix sum exceeds that share of the area. */
static int pick(const SceneSurface *surface, double share)
{
    const double wanted = share * scene_surface_area(surface);
    int low = 0, high = surface->count - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (surface->sums[middle] > wanted)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static const SceneSurfacePart *patch_of(const SceneSurface *surface, int triangle)
{
    int low = 0, high = surface->patch_count - 1;
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (surface->patches[middle].first <= triangle)
            low = middle;
        else
            high = middle - 1;
    }
    return &surface->patches[low];
}

static void share(const double numbers[3], double shares[3])
{
    const double s = sqrt(numbers[1]), t = numbers[2];
    shares[0] = 1 - s, shares[1] = s * (1 - t), shares[2] = s * t;
}

void scene_surface_point(const SceneSurface *surface, const double numbers[3], double point[3],
                         double normal[3])
{
    const int triangle = pick(surface, numbers[0]);
    const SceneSurfacePart *patch = patch_of(surface, triangle);
    double shares[3];
    share(numbers, shares);
    double corners[3][3], mixed[3] = {0};
    corners_of(patch, triangle, corners);
    for (int i = 0; i < 3; i++) {
        point[i] =
            shares[0] * corners[0][i] + shares[1] * corners[1][i] + shares[2] * corners[2][i];
        for (int k = 0; k < 3; k++)
            mixed[i] += shares[k] * corner(patch, triangle, k)->normal[i];
    }
    transformed_normal(&patch->matrix, mixed, normal);
    if (vec3_normalize(normal))
        return;
    span_of(corners, normal); /* the corners' normals cancel */
    vec3_normalize(normal);
}

/* Interpolates a triangle's vertices; a vertex consists of floats only. */
static ShapeVertex mix(const SceneSurfacePart *patch, int triangle, const double shares[3])
{
    ShapeVertex mixed;
    enum { NUMBERS = sizeof mixed / sizeof(float) };
    float to[NUMBERS], from[3][NUMBERS];
    for (int k = 0; k < 3; k++)
        memcpy(from[k], corner(patch, triangle, k), sizeof from[k]);
    for (int i = 0; i < NUMBERS; i++)
        to[i] = (float)(shares[0] * from[0][i] + shares[1] * from[1][i] + shares[2] * from[2][i]);
    memcpy(&mixed, to, sizeof mixed);
    return mixed;
}

static void share_around(const double numbers[3], double shares[SCENE_SURFACE_AROUND][3])
{
    static const double steps[SCENE_SURFACE_AROUND][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const double part = 1.0 / 1024; /* step as a fraction of an edge */
    double middle[3];
    share(numbers, middle);
    for (int i = 0; i < SCENE_SURFACE_AROUND; i++) {
        const double u = part * steps[i][0], v = part * steps[i][1];
        shares[i][0] = middle[0] - u - v, shares[i][1] = middle[1] + u,
        shares[i][2] = middle[2] + v;
    }
}

int scene_surface_around(const SceneSurface *surface, const double numbers[3],
                         ShapeVertex around[SCENE_SURFACE_AROUND])
{
    const int triangle = pick(surface, numbers[0]);
    const SceneSurfacePart *patch = patch_of(surface, triangle);
    double shares[SCENE_SURFACE_AROUND][3];
    share_around(numbers, shares);
    for (int i = 0; i < SCENE_SURFACE_AROUND; i++)
        around[i] = mix(patch, triangle, shares[i]);
    return patch->object;
}

bool scene_surface_join(SceneSurface *surface)
{
    bool fine = true;
    for (int i = 0; i < surface->patch_count && fine; i++) {
        SceneSurfacePart *patch = &surface->patches[i];
        if (patch->joined)
            continue;
        patch->place = scene_places(&patch->shape);
        patch->joined = calloc((size_t)patch->shape.vertex_count + 1, sizeof *patch->joined);
        fine = patch->place && patch->joined;
        if (fine)
            scene_places_join(&patch->shape, patch->place, patch->joined);
    }
    return fine;
}

/* Sets a corner's position, and the normalized sum of all normals there. */
static void joined_corner(const SceneSurfacePart *patch, int triangle, int k, double normal[3],
                          double at[3])
{
    const ShapeVertex *v =
        &patch->joined[patch->place[patch->shape.indices[3 * (triangle - patch->first) + k]]];
    for (int i = 0; i < 3; i++) {
        normal[i] = (double)v->normal[i];
        at[i] = (double)v->position[i];
    }
    vec3_normalize(normal);
}

/* Sets the displacement that rounds a point. Let n be the mean of the corners' normals: push (1
 * - |n|) along n, plus bulge times the mean vector to the tangent planes at the corners. */
static void rounded(double normals[3][3], double at[3][3], const double shares[3],
                    const SceneDividing *by, double to[3])
{
    double mean[3] = {0}, toward[3] = {0};
    for (int k = 0; k < 3; k++) {
        double away = 0; /* signed distance of the corner's plane from the point */
        for (int i = 0; i < 3; i++)
            away += normals[k][i] *
                    (at[k][i] - shares[0] * at[0][i] - shares[1] * at[1][i] - shares[2] * at[2][i]);
        for (int i = 0; i < 3; i++) {
            mean[i] += shares[k] * normals[k][i];
            toward[i] += shares[k] * away * normals[k][i];
        }
    }
    const double size = fmax(sqrt(vec3_dot(mean, mean)), 1e-30);
    for (int i = 0; i < 3; i++)
        to[i] = by->push * (1 - size) * mean[i] / size + by->bulge * toward[i];
}

void scene_surface_rounded(const SceneSurface *surface, const double numbers[3],
                           const SceneDividing *by, double to[SCENE_SURFACE_AROUND][3])
{
    const int triangle = pick(surface, numbers[0]);
    const SceneSurfacePart *patch = patch_of(surface, triangle);
    double shares[SCENE_SURFACE_AROUND][3], normals[3][3], at[3][3];
    share_around(numbers, shares);
    for (int k = 0; k < 3; k++)
        joined_corner(patch, triangle, k, normals[k], at[k]);
    for (int i = 0; i < SCENE_SURFACE_AROUND; i++)
        rounded(normals, at, shares[i], by, to[i]);
}
