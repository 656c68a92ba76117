/* Tests boxes against half spaces. A box is transformed to a parallelepiped: its center, and
 * half an edge along each axis. Its farthest point in the direction n is the sum of all |n edge|
 * away from the center.
 *
 *     n = (1, 0, 0), d = 0: the half space right of x = 0. A box from (-3, 0, 0) to (-1, 2, 2)
 *         has its center at x = -2, half an edge is 1: -2 + 1 < 0, the box is culled. Rotated by
 *         45 degrees about z, half edges are 0.7 and 0.7: -2 + 1.4 < 0, still culled */
#include "runtime/gpu_scene/cull.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

/* Bound on rounding errors: vertices are transformed by two matrices in floats, with errors of
 * 6e-8 of the largest term; 1e-5 of the sum of terms is far more. */
static const double slack = 1e-5;
enum { NEAREST = 4 /* index of the near plane, after the four sides */ };

/* Adds the plane with the normal eye[0] right + eye[1] up + eye[2] back, at `distance` from the
 * camera's position. */
static void add_plane(const SceneCamera *c, const double eye[3], double distance, CullVolume *made)
{
    double *plane = made->planes[made->count], normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = eye[0] * c->right[i] + eye[1] * c->up[i] + eye[2] * c->back[i];
    const double length = sqrt(vec3_dot(normal, normal));
    for (int i = 0; i < 3; i++)
        plane[i] = normal[i] / length;
    plane[3] = distance / length - vec3_dot(plane, c->position);
    made->terms[made->count] = fabs(distance / length);
    for (int i = 0; i < 3; i++)
        made->terms[made->count] += fabs(plane[i] * c->position[i]);
    made->count++;
}

void cull_volume(const SceneCamera *camera, const int size[2], CullVolume *made)
{
    const double shorter = size[0] < size[1] ? size[0] : size[1];
    const bool far = camera->kind == SCENE_Orthographic;
    made->count = 0;
    for (int axis = 0; axis < 2; axis++)
        for (int side = -1; side <= 1; side += 2) {
            const double half = camera->half * size[axis] / shorter;
            const double eye[3] = {axis ? 0 : side, axis ? side : 0, far ? 0 : -half};
            add_plane(camera, eye, far ? half : 0, made);
        }
    add_plane(camera, (const double[]){0, 0, -1}, far ? 0 : -camera->near, made);
    if (far)
        add_plane(camera, (const double[]){0, 0, 1}, camera->depth, made);
}

CullBox cull_box(const Shape *shape)
{
    CullBox box = {{0}, {0}};
    for (int i = 0; i < shape->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            const double at = shape->vertices[i].position[k];
            box.low[k] = i && box.low[k] < at ? box.low[k] : at;
            box.high[k] = i && box.high[k] > at ? box.high[k] : at;
        }
    return box;
}

/* A transformed box. */
typedef struct {
    double center[3], edges[3][3]; /* center, and half edges */
    double terms[3];               /* sums of the center's absolute terms */
} BoxImage;

static BoxImage image_of(const CullBox *box, const double m[16])
{
    BoxImage image;
    for (int i = 0; i < 3; i++) {
        image.center[i] = m[12 + i];
        image.terms[i] = fabs(m[12 + i]);
        for (int axis = 0; axis < 3; axis++) {
            const double middle = m[4 * axis + i] * (box->high[axis] + box->low[axis]) / 2;
            image.edges[axis][i] = m[4 * axis + i] * (box->high[axis] - box->low[axis]) / 2;
            image.center[i] += middle;
            image.terms[i] += fabs(middle) + fabs(image.edges[axis][i]);
        }
    }
    return image;
}

/* Tests a box against a plane; NaN counts as inside. */
static bool is_inside(const double plane[4], double terms, const BoxImage *image)
{
    double reach = vec3_dot(plane, image->center) + plane[3];
    for (int i = 0; i < 3; i++) {
        reach += fabs(vec3_dot(plane, image->edges[i]));
        terms += fabs(plane[i]) * image->terms[i];
    }
    return !(reach + slack * terms < 0);
}

bool cull_sees(const CullVolume *volume, const CullBox *box, const SceneMatrix *world_from_local)
{
    const BoxImage image = image_of(box, world_from_local->m);
    for (int i = 0; i < volume->count; i++)
        if (!is_inside(volume->planes[i], volume->terms[i], &image))
            return false;
    return true;
}

bool cull_is_outside(const CullVolume *volume, const CullBox *box,
                     const SceneMatrix *world_from_local)
{
    const BoxImage image = image_of(box, world_from_local->m);
    const double *plane = volume->planes[NEAREST];
    double reach = vec3_dot(plane, image.center) + plane[3], terms = volume->terms[NEAREST];
    for (int i = 0; i < 3; i++) {
        reach -= fabs(vec3_dot(plane, image.edges[i]));
        terms += fabs(plane[i]) * image.terms[i];
    }
    return reach > slack * terms;
}
