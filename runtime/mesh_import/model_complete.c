/* Validates a mesh and computes missing data: position and size, texture coordinates, normals,
 * tangents. */
#include "runtime/mesh_import/model_sides.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

static const char *find_fault(const Shape *shape)
{
    if (shape->vertex_count < 3 || shape->index_count < 3)
        return "it has no triangle";
    if (shape->index_count % 3)
        return "its last triangle lacks corners";
    for (int i = 0; i < shape->index_count; i++)
        if (shape->indices[i] >= (uint32_t)shape->vertex_count)
            return "a triangle has a corner that is not there";
    for (int i = 0; i < shape->vertex_count; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabsf(shape->vertices[i].position[k]) < 1e18f))
                return "a position is no number, or not below 1e18";
    return NULL;
}

static void subtract(const float a[3], const float b[3], float out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

static void cross(const float a[3], const float b[3], float out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Normalizes *v. Returns false and leaves *v unchanged if the vector is zero or not finite. */
static bool normalize(float v[3])
{
    float length = sqrtf(dot(v, v));
    if (!(length > 1e-20f) || !isfinite(length))
        return false;
    for (int k = 0; k < 3; k++)
        v[k] /= length;
    return true;
}

/* Fits the mesh into the unit sphere around the origin. Returns the factor that restores the
 * original size; 0 if all points coincide. */
static float fit(Shape *shape)
{
    float low[3], high[3];
    memcpy(low, shape->vertices[0].position, sizeof low);
    memcpy(high, low, sizeof high);
    for (int i = 1; i < shape->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fminf(low[k], shape->vertices[i].position[k]);
            high[k] = fmaxf(high[k], shape->vertices[i].position[k]);
        }
    float size[3];
    subtract(high, low, size);
    const float half = sqrtf(dot(size, size)) / 2;
    for (int i = 0; i < shape->vertex_count && half > 0; i++)
        for (int k = 0; k < 3; k++)
            shape->vertices[i].position[k] =
                (shape->vertices[i].position[k] - (low[k] / 2 + high[k] / 2)) / half;
    return half;
}

/* Computes spherical texture coordinates: longitude and latitude as seen from the origin. */
static void make_coordinates(ShapeVertex *vertices, int count)
{
    for (int i = 0; i < count; i++) {
        ShapeVertex *vertex = &vertices[i];
        const float *p = vertex->position;
        float turn = atan2f(p[1], p[0]) / (float)(2 * PI);
        vertex->uv[0] = turn < 0 ? turn + 1 : turn;
        vertex->uv[1] = atan2f(p[2], hypotf(p[0], p[1])) / (float)PI + 0.5f;
    }
}

/* Computes area-weighted vertex normals, which are 0 before: sums the cross products of the edges
 * of all faces at a vertex. */
static void make_normals(ShapeVertex *vertices, const uint32_t *indices, int count)
{
    for (int i = 0; i < count; i += 3) {
        ShapeVertex *corner[3];
        float a[3], b[3], normal[3];
        for (int k = 0; k < 3; k++)
            corner[k] = &vertices[indices[i + k]];
        subtract(corner[1]->position, corner[0]->position, a);
        subtract(corner[2]->position, corner[0]->position, b);
        cross(a, b, normal);
        for (int k = 0; k < 9; k++)
            corner[k / 3]->normal[k % 3] += normal[k % 3];
    }
}

/* Normalizes all normals; degenerate ones become (0, 0, 1). */
static void mend_normals(Shape *shape)
{
    static const float up[3] = {0, 0, 1};
    for (int i = 0; i < shape->vertex_count; i++)
        if (!normalize(shape->vertices[i].normal))
            memcpy(shape->vertices[i].normal, up, sizeof up);
}

/* Per vertex: number of triangles that contributed tangents, and the signed area sum of their
 * orientation around the normal (positive: right-handed). */
typedef struct {
    int faces;
    float turn;
} Tally;

/* Adds dP/du and dP/dv of a triangle to its corners. Edges a and b have the steps (s, t) and (p,
 * q) in (u, v):
 *     a = s Pu + t Pv, b = p Pu + q Pv   so   Pu = (q a - t b) / D, Pv = (s b - p a) / D
 *     with D = s q - t p
 * Worked example: a = (2, 0, 0) with (s, t) = (1, 0) and b = (0, 2, 0) with (0, 1): D = 1, Pu =
 * a, Pv = b. */
static void add_tangents(ShapeVertex *corner[3], Tally *tally[3])
{
    float a[3], b[3], out[3];
    subtract(corner[1]->position, corner[0]->position, a);
    subtract(corner[2]->position, corner[0]->position, b);
    cross(a, b, out);
    const float s = corner[1]->uv[0] - corner[0]->uv[0], t = corner[1]->uv[1] - corner[0]->uv[1];
    const float p = corner[2]->uv[0] - corner[0]->uv[0], q = corner[2]->uv[1] - corner[0]->uv[1];
    const float d = model_area(corner[0]->uv, corner[1]->uv, corner[2]->uv);
    if (d == 0)
        return;
    for (int i = 0; i < 9; i++) {
        const int c = i / 3, k = i % 3;
        corner[c]->tangentU[k] += (q * a[k] - t * b[k]) / d;
        corner[c]->tangentV[k] += (s * b[k] - p * a[k]) / d;
    }
    for (int c = 0; c < 3; c++) {
        tally[c]->faces++;
        tally[c]->turn += copysignf(1, d) * dot(out, corner[c]->normal);
    }
}

/* Averages the tangents and projects them into the normal's plane. Degenerate tangents, and
 * tangents with the opposite orientation of their triangles (possible at a pole), are replaced
 * by a frame built from the normal. */
static void mend_tangents(ShapeVertex *vertex, const Tally *tally)
{
    const float *n = vertex->normal, side = tally->turn < 0 ? -1 : 1;
    float *tangents[2] = {vertex->tangentU, vertex->tangentV};
    for (int i = 0; i < 6; i++)
        tangents[i / 3][i % 3] /= (float)(tally->faces ? tally->faces : 1);
    for (int i = 0; i < 2; i++) {
        const float along = dot(tangents[i], n);
        for (int k = 0; k < 3; k++)
            tangents[i][k] -= along * n[k];
    }
    float out[3];
    cross(vertex->tangentU, vertex->tangentV, out);
    if (side * dot(out, n) > 1e-8f && isfinite(dot(out, out)))
        return;
    const float *axis = fabsf(n[2]) < 0.9f ? (const float[3]){0, 0, 1} : (const float[3]){1, 0, 0};
    cross(axis, n, vertex->tangentU);
    normalize(vertex->tangentU);
    cross(n, vertex->tangentU, vertex->tangentV);
    for (int k = 0; k < 3; k++)
        vertex->tangentV[k] *= side;
}

static bool make_tangents(Shape *shape)
{
    Tally *tallies = calloc((size_t)shape->vertex_count, sizeof *tallies);
    if (!tallies)
        return false;
    for (int i = 0; i < shape->index_count; i += 3) {
        ShapeVertex *corner[3];
        Tally *tally[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = &shape->vertices[shape->indices[i + k]];
            tally[k] = &tallies[shape->indices[i + k]];
        }
        add_tangents(corner, tally);
    }
    for (int i = 0; i < shape->vertex_count; i++)
        mend_tangents(&shape->vertices[i], &tallies[i]);
    free(tallies);
    return true;
}

/* Unit directions of both tangents that the file gives a vertex; 0: none. */
typedef struct {
    float u[3], v[3];
} Directions;

/* Moves the tangents of the file out of the vertices. Returns false if memory runs out. *made is
 * NULL if no run has tangents. */
static bool take_directions(Shape *shape, const ModelRun *runs, int run_count, Directions **made)
{
    bool any = false;
    *made = NULL;
    for (int i = 0; i < run_count; i++)
        any |= runs[i].has_tangents;
    if (!any)
        return true;
    *made = malloc((size_t)shape->vertex_count * sizeof **made);
    for (int i = 0; *made && i < shape->vertex_count; i++) {
        ShapeVertex *vertex = &shape->vertices[i];
        memcpy((*made)[i].u, vertex->tangentU, sizeof vertex->tangentU);
        memcpy((*made)[i].v, vertex->tangentV, sizeof vertex->tangentV);
        memset(vertex->tangentU, 0, sizeof vertex->tangentU);
        memset(vertex->tangentV, 0, sizeof vertex->tangentV);
    }
    return *made != NULL;
}

/* Gives tangents the directions of the file and the lengths of dP/du and dP/dv. */
static void put_directions(Shape *shape, const Directions *directions)
{
    for (int i = 0; directions && i < shape->vertex_count; i++) {
        ShapeVertex *vertex = &shape->vertices[i];
        Directions own = directions[i];
        const float lengths[2] = {sqrtf(dot(vertex->tangentU, vertex->tangentU)),
                                  sqrtf(dot(vertex->tangentV, vertex->tangentV))};
        if (!normalize(own.u) || !normalize(own.v))
            continue;
        for (int k = 0; k < 3; k++) {
            vertex->tangentU[k] = own.u[k] * lengths[0];
            vertex->tangentV[k] = own.v[k] * lengths[1];
        }
    }
}

/* Returns whether all texture coordinates are finite and below 1e9, as tangents require. */
static bool are_finite(const ShapeVertex *vertices, int count)
{
    for (int i = 0; i < count; i++)
        if (!(fabsf(vertices[i].uv[0]) < 1e9f && fabsf(vertices[i].uv[1]) < 1e9f))
            return false;
    return true;
}

/* Returns an error message unless the runs have valid coordinates, and triangles of their own
 * vertices only. */
static const char *find_run_fault(const Shape *shape, const ModelRun *runs, int run_count)
{
    for (int i = 0, index = 0, vertex = 0; i < run_count; vertex += runs[i++].vertex_count) {
        if (runs[i].has_coordinates && !are_finite(shape->vertices + vertex, runs[i].vertex_count))
            return "a texture coordinate is no number, or not below 1e9";
        for (const int end = index + runs[i].index_count; index < end; index++)
            if (shape->indices[index] < (uint32_t)vertex ||
                shape->indices[index] >= (uint32_t)(vertex + runs[i].vertex_count))
                return "a triangle has a corner that is not there";
    }
    return NULL;
}

/* Computes the normals and texture coordinates that runs lack. */
static void complete_runs(Shape *shape, const ModelRun *runs, int run_count)
{
    for (int i = 0, index = 0, vertex = 0; i < run_count; i++) {
        if (!runs[i].has_coordinates)
            make_coordinates(shape->vertices + vertex, runs[i].vertex_count);
        for (int k = 0; !runs[i].has_normals && k < runs[i].vertex_count; k++)
            memset(shape->vertices[vertex + k].normal, 0, sizeof shape->vertices[0].normal);
        if (!runs[i].has_normals)
            make_normals(shape->vertices, shape->indices + index, runs[i].index_count);
        index += runs[i].index_count;
        vertex += runs[i].vertex_count;
    }
    mend_normals(shape);
}

/* Splits vertices between mirrored and other coordinates, and makes tangents. */
static bool add_frames(Shape *shape, const ModelRun *runs, int run_count, float (*kept)[3])
{
    Directions *directions = NULL;
    const bool done = model_part_sides(shape, kept) &&
                      take_directions(shape, runs, run_count, &directions) && make_tangents(shape);
    if (done)
        put_directions(shape, directions);
    free(directions);
    return done;
}

/* Validates and completes a mesh, fitted into the unit sphere; *size restores the original size.
 * `kept`: NULL, or a row per vertex with capacity for twice as many; a duplicated vertex has its
 * row copied. */
static const char *complete(Shape *shape, const ModelRun *runs, int run_count, float *size,
                            float (*kept)[3])
{
    const char *fault = find_fault(shape);
    if (!fault)
        fault = find_run_fault(shape, runs, run_count);
    if (fault)
        return fault;
    *size = fit(shape);
    if (!(*size > 0))
        return "all its corners are one point";
    complete_runs(shape, runs, run_count);
    return add_frames(shape, runs, run_count, kept) ? NULL : "out of memory";
}

const char *model_complete_runs(Shape *shape, const ModelRun *runs, int run_count)
{
    float size;
    return complete(shape, runs, run_count, &size, NULL);
}

/* Computes on the mesh scaled to size 1, so that the threshold for small areas is well defined,
 * and restores positions and tangents afterwards. */
const char *model_complete_runs_in_place(Shape *shape, const ModelRun *runs, int run_count)
{
    float size, (*kept)[3] = malloc((size_t)shape->vertex_count * 2 * sizeof *kept + 1);
    if (!kept)
        return "out of memory";
    for (int i = 0; i < shape->vertex_count; i++)
        memcpy(kept[i], shape->vertices[i].position, sizeof *kept);
    const char *fault = complete(shape, runs, run_count, &size, kept);
    for (int i = 0; !fault && i < shape->vertex_count; i++) {
        memcpy(shape->vertices[i].position, kept[i], sizeof *kept);
        for (int k = 0; k < 3; k++) {
            shape->vertices[i].tangentU[k] *= size;
            shape->vertices[i].tangentV[k] *= size;
        }
    }
    free(kept);
    return fault;
}

/* The whole shape as a run without tangents. */
static ModelRun whole_run(const Shape *shape, bool has_normals, bool has_coordinates)
{
    return (ModelRun){.index_count = shape->index_count,
                      .vertex_count = shape->vertex_count,
                      .has_normals = has_normals,
                      .has_coordinates = has_coordinates};
}

const char *model_complete(Shape *shape, bool has_normals, bool has_coordinates)
{
    const ModelRun run = whole_run(shape, has_normals, has_coordinates);
    return model_complete_runs(shape, &run, 1);
}

const char *model_complete_in_place(Shape *shape, bool has_normals, bool has_coordinates)
{
    const ModelRun run = whole_run(shape, has_normals, has_coordinates);
    return model_complete_runs_in_place(shape, &run, 1);
}
