/* Counts the triangles of a scene's meshes, where equal solids and objects of one file share a
 * mesh; and the triangles that are drawn. */
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/tessellate/scene_fine.h"
#include "runtime/scene_reader/scene_part.h"
#include "runtime/tessellate/scene_solid.h"
#include <stdlib.h>

static int triangles_of(const Scene *scene, const SceneObject *object)
{
    return object->kind == SCENE_Mesh ? scene->meshes[object->mesh].shape.index_count / 3
                                      : scene_solid_triangles(object);
}

static bool is_known(const SceneReader *r, Key key)
{
    HashProbe probe = hash_probe(&r->solids, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(r->solid_keys[probe.number], key))
            return true;
    return false;
}

/* Reports the limit once. */
bool scene_triangles_add(SceneReader *r, const SceneNodeDesc *desc, const SceneObject *object)
{
    const Key key = scene_solid_key(object);
    if (r->triangles > SCENE_TRIANGLES)
        return false;
    if (is_known(r, key))
        return true;
    ARENA_PUSH(r->session->arena, r->solid_keys, r->solid_count, r->solid_capacity, key);
    hash_index_add(r->session->arena, &r->solids, (uint32_t)key.low, (uint32_t)r->solid_count - 1);
    r->triangles += triangles_of(r->scene, object);
    if (r->triangles <= SCENE_TRIANGLES)
        return true;
    diag_add(r->session, desc->tree->span, DIAG_too_many_triangles, SCENE_TRIANGLES);
    return r->fine = false;
}

/* Objects written at one place of the document: copies, and instances of a definition. */
typedef struct {
    Span span;
    SceneKind kind; /* kind of one of the objects */
    int copies;
    int64_t triangles;
} Origin;

static int64_t drawn_of(const Scene *scene, const SceneObject *object)
{
    return object->kind == SCENE_Mesh ? scene_displaced_triangles(&scene->meshes[object->mesh])
                                      : scene_solid_triangles(object);
}

static int by_place(const void *a, const void *b)
{
    const Span *x = &((const Origin *)a)->span, *y = &((const Origin *)b)->span;
    return x->file != y->file ? (x->file > y->file) - (x->file < y->file)
                              : (x->start > y->start) - (x->start < y->start);
}

/* Joins objects of one place; returns the place with the most triangles. */
static Origin most_of(Origin *origins, int count)
{
    Origin most = {.triangles = -1}, here = {.triangles = -1};
    qsort(origins, (size_t)count, sizeof *origins, by_place);
    for (int i = 0; i < count; i++) {
        const bool same = i && !by_place(&origins[i], &here);
        here = same ? (Origin){here.span, here.kind, here.copies + 1,
                               here.triangles + origins[i].triangles}
                    : origins[i];
        if (here.triangles > most.triangles)
            most = here;
    }
    return most;
}

void scene_triangles_warn(SceneReader *r)
{
    const Scene *scene = r->scene;
    Origin *origins = ARENA_ARRAY(r->session->arena, Origin, scene->object_count + 1);
    int64_t triangles = 0;
    for (int i = 0; i < scene->object_count; i++) {
        origins[i] =
            (Origin){r->origins[i], scene->objects[i].kind, 1, drawn_of(scene, &scene->objects[i])};
        triangles += origins[i].triangles;
    }
    if (triangles <= SCENE_HEAVY_TRIANGLES)
        return;
    const Origin most = most_of(origins, scene->object_count);
    diag_add(r->session, most.span, DIAG_scene_heavy, (long long)triangles,
             (long long)most.triangles, scene_kind_table[most.kind].name, most.copies);
}
