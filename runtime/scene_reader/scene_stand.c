/* Materials are known only after all objects are read, so copies are first placed on the
 * undisplaced surface.
 *
 * In the copies' space a copy's matrix is T(p) R(n) O: its position, its rotation to the normal,
 * if aligned, and its own matrix. It becomes T(q) R(m) O, with q and m those of the displaced
 * surface: the world matrix W T(p) R(n) O X is multiplied by W T(q) R(m) (T(p) R(n))^-1 W^-1
 * from the left. A copy may contain surfaces with copies of their own; these come later in the
 * list, and move with it. */
#include "runtime/scene_reader/scene_stand.h"
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_scatter.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 1024 }; /* max copies moved by one call */

void scene_stand_open(SceneReader *r, const SceneMatrix *world_from_group, int objects,
                      bool aligned)
{
    SceneStand stand = {.world_from_group = *world_from_group,
                        .object_count = r->scene->object_count - objects,
                        .first = objects,
                        .aligned = aligned};
    stand.objects = ARENA_ARRAY(r->session->arena, SceneObject, stand.object_count + 1);
    memcpy(stand.objects, r->scene->objects + objects,
           (size_t)stand.object_count * sizeof *stand.objects);
    ARENA_PUSH(r->session->arena, r->stands, r->stand_count, r->stand_capacity, stand);
}

void scene_stand_add(SceneReader *r, size_t number, const SceneStood *copy)
{
    SceneStand *stand = &r->stands[number];
    if (copy->end > copy->first)
        ARENA_PUSH(r->session->arena, stand->copies, stand->copy_count, stand->copy_capacity,
                   *copy);
}

/* State of moving the copies of one surface. */
typedef struct {
    SceneReader *r;
    const MatcOptions *options;
    SceneStand *stand;
    SceneSurface surface;
    SceneMatrix group_from_world;
    bool *moves;  /* indexed as `asides`: the material displaces */
    bool *rounds; /* indexed as `asides`: push and bulge apply */
    size_t later; /* first later surface, which may be part of a copy */
} Standing;

static SceneMatrix place_of(const double at[3], const double normal[3], bool aligned)
{
    SceneMatrix place = aligned ? scene_scatter_turn(normal) : scene_matrix_identity();
    memcpy(place.m + 12, at, 3 * sizeof *at);
    return place;
}

static void apply(const SceneMatrix *m, const double p[3], double w, double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = m->m[i] * p[0] + m->m[4 + i] * p[1] + m->m[8 + i] * p[2] + m->m[12 + i] * w;
}

/* Computes the unit normal through the four adjacent points, on the side of the undisplaced
 * normal, or that normal if they are degenerate. In the copies' space. */
static void find_normal(const Standing *s, const MatcPoint around[SCENE_SURFACE_AROUND],
                        const double before[3], double normal[3])
{
    double at[SCENE_SURFACE_AROUND][3], u[3], v[3];
    for (int i = 0; i < SCENE_SURFACE_AROUND; i++)
        apply(&s->group_from_world, around[i].position, 1, at[i]);
    for (int i = 0; i < 3; i++) {
        u[i] = at[1][i] - at[2][i];
        v[i] = at[3][i] - at[4][i];
    }
    vec3_cross(u, v, normal);
    const bool turned = vec3_dot(normal, before) < 0;
    if (!vec3_normalize(normal))
        memcpy(normal, before, 3 * sizeof *normal);
    for (int i = 0; i < 3 && turned; i++)
        normal[i] = -normal[i];
}

static void multiply(SceneMatrix *to, const SceneMatrix *by)
{
    *to = scene_matrix_multiply(by, to);
}

static void place_copy(Standing *s, const SceneStood *copy,
                       const MatcPoint around[SCENE_SURFACE_AROUND])
{
    double at[3], normal[3], there[3], turned[3];
    scene_surface_point(&s->surface, copy->numbers, at, normal);
    apply(&s->group_from_world, around[0].position, 1, there);
    find_normal(s, around, normal, turned);
    const SceneMatrix before = place_of(at, normal, s->stand->aligned),
                      after = place_of(there, turned, s->stand->aligned);
    SceneMatrix by = s->group_from_world, back;
    if (!scene_matrix_invert(&before, &back))
        return;
    multiply(&by, &back);
    multiply(&by, &after);
    multiply(&by, &s->stand->world_from_group);
    for (int i = copy->first; i < copy->end; i++)
        multiply(&s->r->scene->objects[i].world_from_local, &by);
    for (; s->later < s->r->stand_count && s->r->stands[s->later].first < copy->end; s->later++)
        if (s->r->stands[s->later].first >= copy->first)
            multiply(&s->r->stands[s->later].world_from_group, &by);
}

/* A copy on a displaced surface, with the points around it. */
typedef struct {
    size_t copy;
    int material;
    MatcPoint around[SCENE_SURFACE_AROUND];
    double rounded[SCENE_SURFACE_AROUND][3]; /* offsets by push and bulge, in world space */
} Moving;

static bool moves(const Standing *s, const SceneStood *copy, Moving *made)
{
    ShapeVertex around[SCENE_SURFACE_AROUND];
    SceneMatrix inverse;
    const SceneObject *object =
        &s->stand->objects[scene_surface_around(&s->surface, copy->numbers, around)];
    const SceneMatrix m =
        scene_matrix_multiply(&s->stand->world_from_group, &object->world_from_local);
    made->material = object->material;
    if (!s->moves[object->material] || !scene_matrix_invert(&m, &inverse))
        return false;
    double by[SCENE_SURFACE_AROUND][3] = {{0}};
    if (s->rounds[object->material])
        scene_surface_rounded(&s->surface, copy->numbers, &s->r->scene->dividing, by);
    for (int i = 0; i < SCENE_SURFACE_AROUND; i++) {
        made->around[i] = scene_displaced_point(&around[i], &m, &inverse, s->r->scene->origin);
        apply(&m, by[i], 0, made->rounded[i]);
    }
    return true;
}

/* Displaces the points of `count` copies on one material. */
static bool move_run(Standing *s, Moving *at, int count)
{
    const SceneMaterial *material = &s->r->asides[at->material];
    MatcPoint *points = malloc((size_t)count * SCENE_SURFACE_AROUND * sizeof *points);
    for (int i = 0; points && i < count; i++)
        memcpy(points + i * SCENE_SURFACE_AROUND, at[i].around, sizeof at[i].around);
    const bool fine = points && matc_move(material->document, material->index, s->options, points,
                                          count * SCENE_SURFACE_AROUND);
    for (int i = 0; fine && i < count; i++) {
        memcpy(at[i].around, points + i * SCENE_SURFACE_AROUND, sizeof at[i].around);
        for (int k = 0; k < SCENE_SURFACE_AROUND; k++)
            for (int component = 0; component < 3; component++)
                at[i].around[k].position[component] += at[i].rounded[k][component];
    }
    free(points);
    return fine;
}

/* Displaces runs of consecutive copies on the same material, then moves each copy in order,
 * since later copies may be part of earlier ones. */
static bool move_chunk(Standing *s, Moving *chunk, int count)
{
    bool fine = true;
    for (int first = 0, end; first < count && fine; first = end) {
        for (end = first + 1; end < count && chunk[end].material == chunk[first].material;)
            end++;
        fine = move_run(s, chunk + first, end - first);
    }
    for (int i = 0; i < count && fine; i++)
        place_copy(s, &s->stand->copies[chunk[i].copy], chunk[i].around);
    return fine;
}

static bool move_all(Standing *s)
{
    Moving *chunk = malloc(CHUNK * sizeof *chunk);
    bool fine = chunk != NULL;
    int count = 0;
    for (size_t i = 0; i < s->stand->copy_count && fine; i++) {
        chunk[count].copy = i;
        count += moves(s, &s->stand->copies[i], &chunk[count]);
        if (count < CHUNK && i + 1 < s->stand->copy_count)
            continue;
        fine = move_chunk(s, chunk, count);
        count = 0;
    }
    free(chunk);
    return fine;
}

static bool stands_on_moving(const Standing *s)
{
    for (int i = 0; i < s->stand->object_count; i++)
        if (s->moves[s->stand->objects[i].material])
            return s->stand->copy_count > 0;
    return false;
}

/* Materials in asides that displace their surfaces, and those to which push and bulge apply:
 * volumes and materials without displacement are excluded. */
typedef struct {
    bool *moves, *rounds, any;
} Displaced;

static bool stand(SceneReader *r, const MatcOptions *options, size_t number, const Displaced *how)
{
    SceneStand *own = &r->stands[number];
    Standing s = {.r = r,
                  .options = options,
                  .stand = own,
                  .moves = how->moves,
                  .rounds = how->rounds,
                  .later = number + 1};
    if (!stands_on_moving(&s) || !scene_matrix_invert(&own->world_from_group, &s.group_from_world))
        return true;
    const bool fine = scene_surface_make(r->scene, own->objects, own->object_count, &s.surface) &&
                      (!how->any || scene_surface_join(&s.surface)) && move_all(&s);
    scene_surface_free(&s.surface);
    return fine;
}

static Displaced find_displaced(SceneReader *r, const MatcOptions *options)
{
    Displaced how = {.moves = ARENA_ARRAY(r->session->arena, bool, r->aside_count + 1),
                     .rounds = ARENA_ARRAY(r->session->arena, bool, r->aside_count + 1)};
    const bool rounded = r->scene->dividing.push != 0 || r->scene->dividing.bulge != 0;
    for (size_t i = 1; i < r->aside_count && r->stand_count; i++) {
        const SceneMaterial *material = &r->asides[i];
        how.moves[i] = matc_moves(material->document, material->index, options) != MATC_MOVES_none;
        how.rounds[i] =
            rounded && how.moves[i] && !matc_has_volume(material->document, material->index);
        how.any |= how.rounds[i];
    }
    return how;
}

bool scene_stand(SceneReader *r, const MatcOptions *options)
{
    const Displaced how = find_displaced(r, options);
    bool fine = true;
    for (size_t i = 0; i < r->stand_count && fine; i++)
        fine = stand(r, options, i, &how);
    if (!fine)
        diag_add(r->session, NO_SPAN, DIAG_scene_scatter,
                 "the displacement of the surface needs too many operations or too much memory");
    return fine;
}
