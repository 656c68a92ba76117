/* The hierarchy of objects as a flat list: each with its matrix to the world, and its material. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_part.h"
#include "runtime/scene/scene_scatter.h"
#include <math.h>
#include <string.h>

/* What a group gives to what is in it. */
typedef struct {
    SceneMatrix world_from_group;
    int material; /* -1: none */
    int depth;    /* groups and instances around it */
} Around;

/* Where the rows of a kind have what every object has, and its own numbers. */
typedef struct {
    int transform, material;
    int numbers[3], lanes; /* params, of so many lanes each; -1: no more */
} ObjectRow;

static const ObjectRow rows[SCENE_KIND_COUNT] = {
    [SCENE_Group] = {S_Group_transform, S_Group_material, {-1}, 0},
    [SCENE_Scatter] = {S_Scatter_transform, S_Scatter_material, {-1}, 0},
    [SCENE_Instance] = {S_Instance_transform, S_Instance_material, {-1}, 0},
    [SCENE_Sphere] = {S_Sphere_transform, S_Sphere_material, {S_Sphere_radius, S_Sphere_detail, -1}, 1},
    [SCENE_Box] = {S_Box_transform, S_Box_material, {S_Box_size, -1}, 3},
    [SCENE_Cylinder] = {S_Cylinder_transform,
                        S_Cylinder_material,
                        {S_Cylinder_radius, S_Cylinder_height, S_Cylinder_detail},
                        1},
    [SCENE_Cone] = {S_Cone_transform, S_Cone_material, {S_Cone_radius, S_Cone_height, S_Cone_detail}, 1},
    [SCENE_Parallelogram] = {S_Parallelogram_transform,
                             S_Parallelogram_material,
                             {S_Parallelogram_u, S_Parallelogram_v, -1},
                             3},
    [SCENE_Plane] = {S_Plane_transform, S_Plane_material, {-1}, 0},
    [SCENE_Mesh] = {S_Mesh_transform, S_Mesh_material, {-1}, 0},
};

static bool fault(SceneReader *r, Span span, DiagKind kind, const char *what)
{
    diag_add(r->session, span, kind, what);
    return r->fine = false;
}

static void read_numbers(const SceneThing *thing, SceneObject *object)
{
    const ObjectRow *row = &rows[thing->kind];
    for (int i = 0; i < 3 && row->numbers[i] >= 0; i++)
        if (row->lanes == 3)
            scene_thing_vector(thing, row->numbers[i], object->numbers + 3 * i);
        else
            object->numbers[i] = scene_thing_number(thing, row->numbers[i]);
}

/* How far its own numbers lead it along an axis; the matrix takes that further. */
static double reach_of(const SceneObject *object)
{
    double reach = 1;
    for (int i = 0; i < SCENE_NUMBERS; i++)
        reach = fmax(reach, fabs(object->numbers[i]));
    return reach;
}

/* An image of unit vectors that is flat, or no number, cannot be drawn; x and y of a plane have to stay at a right angle. */
static bool check_matrix(SceneReader *r, const SceneThing *thing, const SceneObject *object)
{
    const SceneMatrix *m = &object->world_from_local;
    const double reach = reach_of(object);
    const Span span = scene_thing_span(thing, rows[thing->kind].transform);
    double x[3], y[3], z[3];
    memcpy(x, m->m, sizeof x);
    memcpy(y, m->m + 4, sizeof y);
    memcpy(z, m->m + 8, sizeof z);
    for (int i = 0; i < 16; i++)
        if (!(fabs(m->m[i]) * (i < 12 ? reach : 1) < 1e30))
            return fault(r, span, DIAG_scene_flat, "the transformation leads too far away");
    if (!scene_vector_normalize(x) || !scene_vector_normalize(y) || !scene_vector_normalize(z))
        return fault(r, span, DIAG_scene_flat, "the transformation makes it flat");
    const double axes[3][3] = {{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {z[0], z[1], z[2]}};
    double cross[3];
    scene_vector_cross(axes[1], axes[2], cross);
    if (fabs(scene_vector_dot(axes[0], cross)) < 1e-9)
        return fault(r, span, DIAG_scene_flat, "the transformation makes it flat");
    if (thing->kind == SCENE_Plane && fabs(scene_vector_dot(x, y)) > 1e-6)
        return fault(r, span, DIAG_scene_flat, "the transformation leaves x and y of a plane at no right angle");
    return true;
}

static bool check_parallelogram(SceneReader *r, const SceneThing *thing, const SceneObject *object)
{
    return thing->kind != SCENE_Parallelogram || scene_vector_span(object->numbers, object->numbers + 3) ||
           fault(r, scene_thing_span(thing, S_Parallelogram_v), DIAG_scene_flat, "u and v span nothing");
}

/* Its own, or that of what is around it. */
static int material_of(SceneReader *r, const SceneThing *thing, int around)
{
    Tree *given = scene_thing_given(thing, rows[thing->kind].material);
    return given ? scene_material_read(r, given) : around;
}

static bool fault_missing(SceneReader *r, const SceneThing *thing, const char *key)
{
    diag_add(r->session, thing->tree->span, DIAG_missing_key, scene_kind_table[thing->kind].name, key);
    return r->fine = false;
}

static bool find_mesh(SceneReader *r, const SceneThing *thing, int *mesh)
{
    const Tree *file = thing->kind == SCENE_Mesh ? scene_thing_given(thing, S_Mesh_file) : NULL;
    *mesh = file ? scene_mesh_read(r, file) : -1;
    return thing->kind != SCENE_Mesh || (file ? *mesh >= 0 : fault_missing(r, thing, "file"));
}

/* Told once. */
static bool add_plane(SceneReader *r, const SceneThing *thing)
{
    if (r->plane_count > SCENE_PLANES)
        return false;
    ARENA_PUSH(r->session->arena, r->planes, r->plane_count, r->plane_room, r->scene->object_count);
    if (r->plane_count <= SCENE_PLANES)
        return true;
    diag_add(r->session, thing->tree->span, DIAG_too_many_planes, SCENE_PLANES);
    return r->fine = false;
}

static bool add_object(SceneReader *r, const SceneThing *thing, const Around *around)
{
    Scene *scene = r->scene;
    SceneObject object = {.kind = thing->kind, .world_from_local = around->world_from_group};
    read_numbers(thing, &object);
    object.material = around->material;
    if (!check_matrix(r, thing, &object) || !check_parallelogram(r, thing, &object) ||
        !find_mesh(r, thing, &object.mesh))
        return false;
    if (object.material < 0)
        return scene_thing_given(thing, rows[thing->kind].material) ? r->fine : fault_missing(r, thing, "material");
    if (thing->kind == SCENE_Plane && !add_plane(r, thing))
        return false;
    size_t count = (size_t)scene->object_count;
    ARENA_PUSH(r->session->arena, scene->objects, count, r->object_room, object);
    scene->object_count = (int)count;
    return true;
}

static void read_list(SceneReader *r, const Tree *list, const Around *around);
static void read_copies(SceneReader *r, const SceneThing *thing, const Around *around);
static bool read_instance(SceneReader *r, const SceneThing *thing, const Around *around);

/* What is wrong with an object is told once, however often it is met. */
static void read_object(SceneReader *r, Tree *tree, const Around *around)
{
    SceneThing thing;
    if (!scene_thing_read(r, tree, SCENE_SORT_object, &thing))
        return;
    const Transform *transform = scene_thing_transform(&thing, rows[thing.kind].transform);
    const SceneMatrix own = transform ? scene_matrix_of(transform) : scene_matrix_identity();
    const Around here = {.world_from_group = scene_matrix_multiply(&around->world_from_group, &own),
                         .material = material_of(r, &thing, around->material),
                         .depth = around->depth + 1};
    if (here.depth > LIMIT_DEPTH) {
        diag_add(r->session, tree->span, DIAG_too_deep, LIMIT_DEPTH);
        tree->failed = true, r->fine = false;
    } else if (thing.kind == SCENE_Scatter)
        read_copies(r, &thing, &here);
    else if (thing.kind == SCENE_Instance)
        tree->failed = !read_instance(r, &thing, &here);
    else if (thing.kind != SCENE_Group)
        tree->failed = !add_object(r, &thing, &here);
    else if (scene_thing_given(&thing, S_Group_objects))
        read_list(r, scene_thing_given(&thing, S_Group_objects), &here);
}

static bool fault_many(SceneReader *r, Span span)
{
    diag_add(r->session, span, DIAG_too_many_objects, SCENE_OBJECTS);
    return r->fine = false;
}

/* Whether there is room for one more; it is told once that there is none. */
static bool count_thing(SceneReader *r, Span span)
{
    if (r->things > SCENE_OBJECTS)
        return false;
    return ++r->things <= SCENE_OBJECTS || fault_many(r, span);
}

/* An alias may stand for a list any number of times, in lists that are aliases: what is met is counted. */
static void read_list(SceneReader *r, const Tree *list, const Around *around)
{
    for (uint32_t i = 0; i < list->count && count_thing(r, list->items[i]->span); i++)
        read_object(r, list->items[i], around);
}

/* A definition is open while what is in it is read: what is instanced then contains itself. False: told. */
static bool read_instance(SceneReader *r, const SceneThing *thing, const Around *around)
{
    const Tree *name = scene_thing_given(thing, S_Instance_of);
    Tree *definition = name ? scene_definition_find(r, name) : NULL;
    if (!name)
        return fault_missing(r, thing, "of");
    if (definition && definition->open) {
        diag_add(r->session, name->span, DIAG_cycle, name->text);
        return r->fine = false;
    }
    if (!definition || !count_thing(r, thing->tree->span))
        return false;
    definition->open = true;
    read_object(r, definition, around);
    definition->open = false;
    return true;
}

/* What is wrong with one copy is wrong with all. */
static void read_copies(SceneReader *r, const SceneThing *thing, const Around *around)
{
    const Tree *list = scene_thing_given(thing, S_Scatter_objects);
    const int count = (int)scene_thing_number(thing, S_Scatter_count);
    uint64_t state = (uint64_t)scene_thing_number(thing, S_Scatter_seed);
    SceneScatter scatter = {.least = scene_thing_number(thing, S_Scatter_least),
                            .most = scene_thing_number(thing, S_Scatter_most)};
    scene_thing_vector(thing, S_Scatter_size, scatter.size);
    scene_thing_vector(thing, S_Scatter_rotation, scatter.rotation);
    if (scatter.least > scatter.most) {
        diag_add(r->session, scene_thing_span(thing, S_Scatter_least), DIAG_scene_scatter);
        r->fine = false;
    }
    for (int i = 0; list && i < count && (i == 0 || r->fine) && count_thing(r, thing->tree->span); i++) {
        const SceneMatrix own = scene_scatter_matrix(&scatter, &state);
        const Around here = {.world_from_group = scene_matrix_multiply(&around->world_from_group, &own),
                             .material = around->material,
                             .depth = around->depth};
        read_list(r, list, &here);
    }
}

void scene_objects_read(SceneReader *r, const Tree *list)
{
    read_list(r, list, &(Around){.world_from_group = scene_matrix_identity(), .material = -1});
}

/* Any number stands for the material that an instance might bring. All of them together may be as much as a scene. */
void scene_objects_check_unused(SceneReader *r)
{
    const Around nothing = {.world_from_group = scene_matrix_identity(), .material = 0};
    Scene *scene = r->scene;
    const int objects = scene->object_count, materials = scene->material_count;
    r->things = 0;
    for (uint32_t i = 0; r->definitions && i < r->definitions->count; i++) {
        Tree *definition = scene_definition_unused(r, i);
        if (definition)
            read_object(r, definition, &nothing);
        scene->object_count = objects;
        scene->material_count = materials;
    }
}
