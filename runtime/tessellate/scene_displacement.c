/* True displacement on the CPU: triangles are divided, evenly or by error (scene_refine.c), and
 * each place is moved once, by the C reference in double; after division by error also slightly
 * further, to reduce the triangles' error. The renderer then sees ordinary meshes in all passes:
 * shadows of each technique, voxels, depth of the picture.
 *
 * There are no cracks: triangles that share an edge divide it alike (scene_divide.c,
 * scene_bisection.c), and all vertices of one place move together: along the normalized sum of
 * their normals, and by the texture coordinates and tangents of the first. So closed meshes stay
 * closed, bit for bit. */
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_places.h"
#include "runtime/tessellate/scene_refine.h"
#include "runtime/tessellate/scene_volume.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Transforms v by the upper left 3x3 part; normals by its transposed inverse. */
static void turn(const SceneMatrix *m, bool transposed, const float v[3], double result[3])
{
    for (int row = 0; row < 3; row++) {
        result[row] = 0;
        for (int column = 0; column < 3; column++)
            result[row] +=
                m->m[transposed ? 4 * row + column : 4 * column + row] * (double)v[column];
    }
}

static void copy(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

MatcPoint scene_displaced_point(const ShapeVertex *vertex, const SceneMatrix *m,
                                const SceneMatrix *inverse, const double origin[3])
{
    MatcPoint point;
    turn(m, false, vertex->position, point.position);
    for (int i = 0; i < 3; i++)
        point.position[i] += m->m[12 + i] + origin[i];
    turn(inverse, true, vertex->normal, point.normal);
    turn(m, false, vertex->tangentU, point.tangent_u);
    turn(m, false, vertex->tangentV, point.tangent_v);
    copy(vertex->position, point.local);
    copy(vertex->tangentU, point.local_u);
    copy(vertex->tangentV, point.local_v);
    point.uv[0] = (double)vertex->uv[0];
    point.uv[1] = (double)vertex->uv[1];
    return point;
}

typedef struct {
    const SceneDisplacing *how;
    SceneMatrix local_from_world;
} Mover;

/* Moves points by the C reference, in world space and back. */
static bool move_points(void *user, const ShapeVertex *at, int count, double (*to)[3])
{
    const Mover *mover = user;
    const SceneMatrix *m = &mover->how->world_from_local, *inverse = &mover->local_from_world;
    MatcPoint *points = malloc(((size_t)count + 1) * sizeof *points);
    for (int i = 0; points && i < count; i++)
        points[i] = scene_displaced_point(&at[i], m, inverse, mover->how->origin);
    const bool fine = points && matc_move(mover->how->document, mover->how->material,
                                          mover->how->options, points, count);
    for (int i = 0; fine && i < count; i++) {
        double from[3];
        for (int component = 0; component < 3; component++)
            from[component] = points[i].position[component] -
                              (m->m[12 + component] + mover->how->origin[component]);
        for (int component = 0; component < 3; component++)
            to[i][component] = inverse->m[component] * from[0] +
                               inverse->m[4 + component] * from[1] +
                               inverse->m[8 + component] * from[2];
    }
    free(points);
    return fine;
}

/* Finds the solid intervals over points, and the direction of a height of 1 in the world. */
static bool find_solid(void *user, SceneColumn *columns, int count)
{
    const Mover *mover = user;
    const SceneMatrix *m = &mover->how->world_from_local, *inverse = &mover->local_from_world;
    MatcSolid *points = calloc((size_t)count + 1, sizeof *points);
    for (int i = 0; points && i < count; i++)
        points[i].at = scene_displaced_point(&columns[i].at, m, inverse, mover->how->origin);
    const bool fine = points && matc_solid(mover->how->document, mover->how->material,
                                           mover->how->options, points, count);
    for (int i = 0; fine && i < count; i++) {
        const double *n = points[i].at.normal, size = fmax(sqrt(vec3_dot(n, n)), 1e-30);
        for (int component = 0; component < 3; component++)
            columns[i].along[component] =
                (inverse->m[component] * n[0] + inverse->m[4 + component] * n[1] +
                 inverse->m[8 + component] * n[2]) /
                size;
        memcpy(columns[i].heights, points[i].heights, sizeof columns[i].heights);
    }
    free(points);
    return fine;
}

/* Returns the pixels per unit of object space, along the axis with the greatest scale. */
static double pixels_at(void *user, const double at[3])
{
    const Mover *mover = user;
    const double *m = mover->how->world_from_local.m;
    double world[3], size = 0;
    for (int i = 0; i < 3; i++) {
        world[i] = m[i] * at[0] + m[4 + i] * at[1] + m[8 + i] * at[2] + m[12 + i];
        size = fmax(size, vec3_dot(&m[4 * i], &m[4 * i]));
    }
    return sqrt(size) * scene_seen_pixels(mover->how->seen, world);
}

/* Returns the length of a displacement in world space. */
static double length_of(void *user, const double by[3])
{
    const double *m = ((const Mover *)user)->how->world_from_local.m;
    double world[3];
    for (int i = 0; i < 3; i++)
        world[i] = m[i] * by[0] + m[4 + i] * by[1] + m[8 + i] * by[2];
    return sqrt(vec3_dot(world, world));
}

/* Returns the new positions of all places; `at` is the place of each vertex. From malloc; NULL:
 * failed. */
static double (*moved_places(Mover *mover, const Shape *shape, const int *first, int *at))[3]
{
    ShapeVertex *joined = calloc((size_t)shape->vertex_count + 1, sizeof *joined);
    double(*to)[3] = calloc((size_t)shape->vertex_count + 1, sizeof *to);
    int count = 0;
    bool fine = joined && to;
    if (fine)
        scene_places_join(shape, first, joined);
    for (int i = 0; fine && i < shape->vertex_count; i++) {
        at[i] = first[i] == i ? count : at[first[i]];
        if (first[i] == i)
            joined[count++] = joined[i];
    }
    fine = fine && move_points(mover, joined, count, to);
    free(joined);
    if (!fine)
        free(to);
    return fine ? to : NULL;
}

static bool move_shape(Mover *mover, Shape *shape)
{
    int *first = scene_places(shape), *at = calloc((size_t)shape->vertex_count + 1, sizeof *at);
    double(*to)[3] = first && at ? moved_places(mover, shape, first, at) : NULL;
    shape->base = calloc((size_t)shape->vertex_count + 1, sizeof *shape->base);
    const bool fine = to && shape->base;
    for (int i = 0; fine && i < shape->vertex_count; i++) {
        memcpy(shape->base[i], shape->vertices[i].position, sizeof shape->base[i]);
        for (int component = 0; component < 3; component++)
            shape->vertices[i].position[component] = (float)to[at[i]][component];
    }
    free(to);
    free(at);
    free(first);
    return fine;
}

/* Returns the number of parts of an edge that give `triangles` in all. */
static int parts_for(const Shape *from, double triangles)
{
    const double parts = ceil(sqrt(triangles / fmax(from->index_count / 3., 1)));
    return parts > 1 ? (int)parts : 1;
}

static int parts_of(const SceneDisplacing *how, const Shape *from)
{
    return how->level ? how->level : parts_for(from, how->triangles);
}

static bool divide_alike(Mover *mover, const Shape *from, Shape *made)
{
    if (!scene_divide(from, parts_of(mover->how, from), made))
        return false;
    if (move_shape(mover, made))
        return true;
    shape_free(made);
    return false;
}

static bool divide(const SceneDisplacing *how, const Shape *from, SceneMesh *mesh)
{
    Mover mover = {.how = how};
    Shape *made = &mesh->shape;
    if (!scene_matrix_invert(&how->world_from_local, &mover.local_from_world))
        return false;
    if (matc_has_volume(how->document, how->material))
        return scene_volume(from, &(SceneVolume){find_solid, &mover, how->level, how->triangles},
                            made, mesh->steps);
    if (how->method != KEYWORD_Displacing_bisection)
        return divide_alike(&mover, from, made);
    const SceneRefining refining = {.move = move_points,
                                    .user = &mover,
                                    .triangles = how->triangles,
                                    .scale = how->seen ? pixels_at : NULL,
                                    .length = length_of,
                                    .least = how->pixels};
    return scene_refine(from, &refining, made);
}

/* Sets the extent along each axis of object space of a motion of length `bound` in world space:
 * from the rows of the inverse. */
static void set_reach(const SceneMatrix *inverse, double bound, double reach[3])
{
    for (int i = 0; i < 3; i++)
        reach[i] =
            bound * sqrt(inverse->m[i] * inverse->m[i] + inverse->m[4 + i] * inverse->m[4 + i] +
                         inverse->m[8 + i] * inverse->m[8 + i]);
}

double scene_displaced_bound(const MatcDocument *document, int material, const MatcOptions *given)
{
    MatcOptions options = *given;
    options.pass = "depth";
    options.moved = false;
    MatcProgram *program = matc_compile(document, material, MATC_KEY, &options);
    const double bound = matc_ok(program) ? matc_displacement_bound(program) : INFINITY;
    matc_program_free(program);
    return bound;
}

enum { MAX_STEPS = 12, FEEDBACK_MAX = 1 << 24 /* limit of displaced_feedback.c */ };

/* Returns the number of triangles if all are near enough to be divided. */
static int64_t feedback_triangles(const ScenePatches *patches)
{
    return (int64_t)patches->count << 2 * patches->dividing.steps;
}

/* Returns a bound of the bulge of any point: the longest edge. */
static double longest_edge(const ScenePatches *patches)
{
    double longest = 0;
    for (int i = 0; i < 3 * patches->count; i++) {
        const float *a = patches->rows[patches->at[i / 3].own[i % 3]].position,
                    *b = patches->rows[patches->at[i / 3].own[(i + 1) % 3]].position;
        const double way[3] = {(double)a[0] - (double)b[0], (double)a[1] - (double)b[1],
                               (double)a[2] - (double)b[2]};
        longest = fmax(longest, sqrt(vec3_dot(way, way)));
    }
    return longest;
}

/* Returns the least power of two that is at least `parts`, and at least 2, since ray-marched
 * patches are halved repeatedly. */
static int power_of_two(int parts)
{
    int power = 2;
    while (power < parts)
        power *= 2;
    return power;
}

/* Divides a shape into patches. 131072 triangles of a box: 105 parts of an edge, which are 2
 * patches of 53. View-dependent: 512 patches or more, with 256 triangles each if all edges have
 * 16 parts. */
static bool divide_to_patches(const SceneDisplacing *how, const Shape *from, Shape *made,
                              ScenePatches **patches)
{
    enum { USUAL_TRIANGLES = 256 };
    const bool by_picture = how->pixels > 0;
    const int parts = parts_of(how, from);
    /* rounding uses the corners of the mesh's own triangles */
    const bool rounded = how->dividing.push != 0 || how->dividing.bulge > 0;
    const int across = how->method == KEYWORD_Displacing_feedback ||
                               how->method == KEYWORD_Displacing_bisection || rounded
                           ? 1
                       : by_picture ? parts_for(from, how->triangles / (double)USUAL_TRIANGLES)
                                    : (parts + SCENE_PATCH_PARTS - 1) / SCENE_PATCH_PARTS;
    const int most = how->level && how->level < SCENE_PATCH_PARTS ? how->level : SCENE_PATCH_PARTS;
    const double bound = scene_displaced_bound(how->document, how->material, how->options);
    SceneMatrix inverse;
    *made = (Shape){0};
    *patches = NULL;
    if (!isfinite(bound) || !scene_matrix_invert(&how->world_from_local, &inverse))
        return true;
    *patches = calloc(1, sizeof **patches);
    if (!*patches || !scene_divide(from, across, made) || !scene_patches_make(made, *patches)) {
        shape_free(made);
        free(*patches);
        *patches = NULL;
        return false;
    }
    (*patches)->method = how->method;
    (*patches)->world_from_local = how->world_from_local;
    (*patches)->dividing = how->dividing;
    while (!how->dividing.steps && (*patches)->dividing.steps < MAX_STEPS &&
           feedback_triangles(*patches) * 4 <= how->triangles)
        (*patches)->dividing.steps++;
    (*patches)->apart = how->dividing.skirts != KEYWORD_Skirts_auto;
    (*patches)->torn = (*patches)->apart || how->method == KEYWORD_Displacing_points ||
                       how->method == KEYWORD_Displacing_feedback;
    (*patches)->bound = bound;
    (*patches)->level = by_picture || parts > most * across ? most : (parts + across - 1) / across;
    (*patches)->pixels = how->pixels;
    (*patches)->triangles = how->triangles;
    if (scene_displaced_traced(how->method))
        (*patches)->level = power_of_two((*patches)->level);
    set_reach(&inverse, bound, (*patches)->reach);
    for (int i = 0; i < 3; i++)
        (*patches)->reach[i] +=
            fabs(how->dividing.push) + how->dividing.bulge * longest_edge(*patches);
    return true;
}

bool scene_displaced_traced(Keyword method)
{
    return method == KEYWORD_Displacing_traced || method == KEYWORD_Displacing_parallax;
}

bool scene_displaced_by_driver(Keyword method, double pixels)
{
    return method != KEYWORD_Displacing_mesh &&
           (method != KEYWORD_Displacing_bisection || pixels > 0);
}

bool scene_displaced_mesh(const SceneDisplacing *how, const Shape *from, SceneMesh *made)
{
    *made = (SceneMesh){.path = "", .part = -1};
    const bool here = how->processor || (how->method != KEYWORD_Displacing_points &&
                                         matc_has_volume(how->document, how->material));
    if (!here && scene_displaced_by_driver(how->method, how->pixels) &&
        !divide_to_patches(how, from, &made->shape, &made->patches))
        return false;
    return made->patches || divide(how, from, made);
}

int64_t scene_displaced_triangles(const SceneMesh *mesh)
{
    const ScenePatches *patches = mesh->patches;
    if (!patches)
        return mesh->shape.index_count / 3;
    if (patches->method == KEYWORD_Displacing_feedback)
        return feedback_triangles(patches) < FEEDBACK_MAX ? feedback_triangles(patches)
                                                          : FEEDBACK_MAX;
    const int64_t all = (int64_t)patches->count * patches->level * patches->level;
    const int64_t most = patches->triangles > patches->count ? patches->triangles : patches->count;
    return patches->pixels > 0 && all > most ? most : all;
}
