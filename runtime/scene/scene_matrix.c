/* Matrix products, and matrices of transformations in documents. */
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

SceneMatrix scene_matrix_identity(void)
{
    return (SceneMatrix){{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
}

SceneMatrix scene_matrix_multiply(const SceneMatrix *a, const SceneMatrix *b)
{
    SceneMatrix result;
    for (int i = 0; i < 16; i++) {
        result.m[i] = 0;
        for (int k = 0; k < 4; k++)
            result.m[i] += a->m[4 * k + i % 4] * b->m[i / 4 * 4 + k];
    }
    return result;
}

static SceneMatrix scaling(const double by[3])
{
    return (SceneMatrix){{by[0], 0, 0, 0, 0, by[1], 0, 0, 0, 0, by[2], 0, 0, 0, 0, 1}};
}

static SceneMatrix translation(const double by[3])
{
    SceneMatrix result = scene_matrix_identity();
    memcpy(result.m + 12, by, 3 * sizeof *by);
    return result;
}

/* Right-handed rotation about an axis: about z, x turns toward y. */
static SceneMatrix rotation(int axis, double angle)
{
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    SceneMatrix result = scene_matrix_identity();
    result.m[4 * i + i] = result.m[4 * j + j] = cos(angle);
    result.m[4 * i + j] = sin(angle);
    result.m[4 * j + i] = -sin(angle);
    return result;
}

/* H: x gains shear.x y + shear.y z, y gains shear.z z. */
static SceneMatrix shearing(const double by[3])
{
    SceneMatrix result = scene_matrix_identity();
    result.m[4] = by[0];
    result.m[8] = by[1];
    result.m[9] = by[2];
    return result;
}

/* M = T Rz Ry Rx S H (semantics of XYZTransform): the rightmost factor is applied first. */
SceneMatrix scene_matrix_place(const ScenePlace *place)
{
    const SceneMatrix parts[] = {translation(place->translation), rotation(2, place->rotation[2]),
                                 rotation(1, place->rotation[1]), rotation(0, place->rotation[0]),
                                 scaling(place->scale),           shearing(place->shear)};
    SceneMatrix result = parts[0];
    for (size_t i = 1; i < sizeof parts / sizeof *parts; i++)
        result = scene_matrix_multiply(&result, &parts[i]);
    return result;
}

static SceneMatrix of_components(const Transform *transform)
{
    const Value *const values[] = {&transform->translation, &transform->rotation, &transform->scale,
                                   &transform->shear};
    ScenePlace place;
    double *const parts[] = {place.translation, place.rotation, place.scale, place.shear};
    for (int i = 0; i < 4; i++) {
        double components[4];
        value_number(values[i], TYPE_vec3, components);
        memcpy(parts[i], components, 3 * sizeof *components);
    }
    return scene_matrix_place(&place);
}

SceneMatrix scene_matrix_of(const Transform *transform)
{
    if (transform->kind != TRANSFORM_matrix)
        return of_components(transform); /* omitted components have neutral defaults */
    SceneMatrix result;
    for (int i = 0; i < 16; i++)
        /* transposes, since documents write matrices by rows */
        result.m[i] = transform->matrix[i % 4 * 4 + i / 4];
    return result;
}

double scene_matrix_determinant(const SceneMatrix *m)
{
    double cross[3];
    vec3_cross(m->m + 4, m->m + 8, cross);
    return vec3_dot(m->m, cross);
}

void scene_vector_axes(const double along[3], double x[3], double y[3])
{
    const int least = fabs(along[0]) <= fabs(along[1]) && fabs(along[0]) <= fabs(along[2]) ? 0
                      : fabs(along[1]) <= fabs(along[2])                                   ? 1
                                                                                           : 2;
    double helper[3] = {0};
    helper[least] = 1;
    vec3_cross(helper, along, x);
    vec3_normalize(x);
    vec3_cross(along, x, y);
}

bool scene_matrix_invert(const SceneMatrix *m, SceneMatrix *inverse)
{
    const double determinant = scene_matrix_determinant(m);
    if (!isfinite(1 / determinant))
        return false;
    *inverse = scene_matrix_identity();
    for (int i = 0; i < 3; i++) {
        double row[3];
        vec3_cross(&m->m[4 * ((i + 1) % 3)], &m->m[4 * ((i + 2) % 3)], row);
        for (int k = 0; k < 3; k++)
            inverse->m[4 * k + i] = row[k] / determinant;
        inverse->m[12 + i] = -vec3_dot(row, &m->m[12]) / determinant;
    }
    return true;
}
