/* How many triangles the meshes of a scene have: equal solids, and objects of one file, are one mesh. */
#include "runtime/scene/scene_part.h"

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

/* Told once. */
bool scene_triangles_add(SceneReader *r, const SceneThing *thing, const SceneObject *object)
{
    const Key key = scene_solid_key(object);
    if (r->triangles > SCENE_TRIANGLES)
        return false;
    if (is_known(r, key))
        return true;
    ARENA_PUSH(r->session->arena, r->solid_keys, r->solid_count, r->solid_room, key);
    hash_index_add(r->session->arena, &r->solids, (uint32_t)key.low, (uint32_t)r->solid_count - 1);
    r->triangles += triangles_of(r->scene, object);
    if (r->triangles <= SCENE_TRIANGLES)
        return true;
    diag_add(r->session, thing->tree->span, DIAG_too_many_triangles, SCENE_TRIANGLES);
    return r->fine = false;
}
