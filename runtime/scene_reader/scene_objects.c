/* Flattens the hierarchy of objects into a list: each object with its matrix to world space, and
 * its material. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene_reader/scene_part.h"
#include "runtime/tessellate/scene_scatter.h"
#include "runtime/scene_reader/scene_stand.h"
#include <math.h>
#include <string.h>

/* Properties that a group passes on to its members. */
typedef struct {
    SceneMatrix world_from_group;
    int material;     /* index of the material; -1: none */
    int depth;        /* number of enclosing groups and instances */
    const char *name; /* names of the enclosing groups, joined by '/'; NULL: no names */
} Around;

/* Indices of the parameters that every object has, and of a kind's numbers. */
typedef struct {
    int transform, material, name;
    int numbers[3], components; /* parameters with `components` components each; -1 ends the list */
} ObjectRow;

static const ObjectRow rows[SCENE_KIND_COUNT] = {
    [SCENE_Group] = {S_Group_transform, S_Group_material, S_Group_name, {-1}, 0},
    [SCENE_Scatter] = {S_Scatter_transform, S_Scatter_material, S_Scatter_name, {-1}, 0},
    [SCENE_Instance] = {S_Instance_transform, S_Instance_material, S_Instance_name, {-1}, 0},
    [SCENE_Sphere] = {S_Sphere_transform,
                      S_Sphere_material,
                      S_Sphere_name,
                      {S_Sphere_radius, S_Sphere_detail, -1},
                      1},
    [SCENE_Box] = {S_Box_transform, S_Box_material, S_Box_name, {S_Box_size, -1}, 3},
    [SCENE_Cylinder] = {S_Cylinder_transform,
                        S_Cylinder_material,
                        S_Cylinder_name,
                        {S_Cylinder_radius, S_Cylinder_height, S_Cylinder_detail},
                        1},
    [SCENE_Cone] = {S_Cone_transform,
                    S_Cone_material,
                    S_Cone_name,
                    {S_Cone_radius, S_Cone_height, S_Cone_detail},
                    1},
    [SCENE_Parallelogram] = {S_Parallelogram_transform,
                             S_Parallelogram_material,
                             S_Parallelogram_name,
                             {S_Parallelogram_u, S_Parallelogram_v, -1},
                             3},
    [SCENE_Plane] = {S_Plane_transform, S_Plane_material, S_Plane_name, {-1}, 0},
    [SCENE_Mesh] = {S_Mesh_transform, S_Mesh_material, S_Mesh_name, {-1}, 0},
};

static bool fault(SceneReader *r, Span span, DiagKind kind, const char *what)
{
    diag_add(r->session, span, kind, what);
    return r->fine = false;
}

static void read_numbers(const SceneNodeDesc *desc, SceneObject *object)
{
    const ObjectRow *row = &rows[desc->kind];
    for (int i = 0; i < 3 && row->numbers[i] >= 0; i++)
        if (row->components == 3)
            scene_node_vector(desc, row->numbers[i], object->numbers + 3 * i);
        else
            object->numbers[i] = scene_node_number(desc, row->numbers[i]);
}

/* Returns a bound of an object's local coordinates, before its matrix. */
static double reach_of(const SceneObject *object)
{
    double reach = 1;
    for (int i = 0; i < SCENE_NUMBERS; i++)
        reach = fmax(reach, fabs(object->numbers[i]));
    return reach;
}

/* Checks a matrix: one that flattens an object, or has no finite numbers, cannot be drawn; x and
 * y of a plane must stay perpendicular. */
static bool check_matrix(SceneReader *r, const SceneNodeDesc *desc, const SceneObject *object)
{
    const SceneMatrix *m = &object->world_from_local;
    const double reach = reach_of(object);
    const Span span = scene_node_span(desc, rows[desc->kind].transform);
    double x[3], y[3], z[3];
    memcpy(x, m->m, sizeof x);
    memcpy(y, m->m + 4, sizeof y);
    memcpy(z, m->m + 8, sizeof z);
    for (int i = 0; i < 16; i++)
        if (!(fabs(m->m[i]) * (i < 12 ? reach : 1) < 1e30))
            return fault(r, span, DIAG_scene_flat, "the transformation leads too far away");
    if (!vec3_normalize(x) || !vec3_normalize(y) || !vec3_normalize(z))
        return fault(r, span, DIAG_scene_flat, "the transformation makes it flat");
    const double axes[3][3] = {{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {z[0], z[1], z[2]}};
    double cross[3];
    vec3_cross(axes[1], axes[2], cross);
    if (fabs(vec3_dot(axes[0], cross)) < 1e-9)
        return fault(r, span, DIAG_scene_flat, "the transformation makes it flat");
    if (desc->kind == SCENE_Plane && fabs(vec3_dot(x, y)) > 1e-6)
        return fault(r, span, DIAG_scene_flat,
                     "the transform does not keep x and y of a plane perpendicular");
    return true;
}

static bool check_parallelogram(SceneReader *r, const SceneNodeDesc *desc,
                                const SceneObject *object)
{
    return desc->kind != SCENE_Parallelogram || vec3_span(object->numbers, object->numbers + 3) ||
           fault(r, scene_node_span(desc, S_Parallelogram_v), DIAG_scene_flat,
                 "u and v are parallel");
}

/* Returns the object's own material, or that of its group. */
static int material_of(SceneReader *r, const SceneNodeDesc *desc, int around)
{
    Tree *given = scene_node_given(desc, rows[desc->kind].material);
    return given ? scene_material_read(r, given) : around;
}

static bool fault_missing(SceneReader *r, const SceneNodeDesc *desc, const char *key)
{
    diag_add(r->session, desc->tree->span, DIAG_missing_key, scene_kind_table[desc->kind].name,
             key);
    return r->fine = false;
}

/* Returns the names of the enclosing groups and the object's own, joined by '/', such as
 * lamps/bulb. NULL without names. */
static const char *name_of(SceneReader *r, const SceneNodeDesc *desc, const char *around)
{
    const Tree *given = scene_node_given(desc, rows[desc->kind].name);
    const char *own = scene_node_name(r, given);
    if (!own || !around)
        return own ? own : around;
    Text joined = text_new(r->session->arena);
    text_format(&joined, "%s/%s", around, own);
    return joined.at;
}

static bool find_mesh(SceneReader *r, const SceneNodeDesc *desc, int *mesh)
{
    const Tree *file = desc->kind == SCENE_Mesh ? scene_node_given(desc, S_Mesh_file) : NULL;
    *mesh = file ? scene_mesh_read(r, file) : -1;
    return desc->kind != SCENE_Mesh || (file ? *mesh >= 0 : fault_missing(r, desc, "file"));
}

/* Records a plane. Reports once that there are too many. */
static bool add_plane(SceneReader *r, const SceneNodeDesc *desc)
{
    if (r->plane_count > SCENE_PLANES)
        return false;
    ARENA_PUSH(r->session->arena, r->planes, r->plane_count, r->plane_capacity,
               r->scene->object_count);
    if (r->plane_count <= SCENE_PLANES)
        return true;
    diag_add(r->session, desc->tree->span, DIAG_too_many_planes, SCENE_PLANES);
    return r->fine = false;
}

static bool fault_many(SceneReader *r, Span span)
{
    diag_add(r->session, span, DIAG_too_many_objects, SCENE_OBJECTS);
    return r->fine = false;
}

/* Counts an object or group. Returns false if there are too many, which is reported once. */
static bool count_node(SceneReader *r, Span span)
{
    if (r->objects > SCENE_OBJECTS)
        return false;
    return ++r->objects <= SCENE_OBJECTS || fault_many(r, span);
}

static bool push_object(SceneReader *r, const SceneNodeDesc *desc, SceneObject object)
{
    Scene *scene = r->scene;
    if (!scene_triangles_add(r, desc, &object))
        return false;
    size_t count = (size_t)scene->object_count;
    r->origin_count = count; /* removes the origins of the objects outside the scene */
    ARENA_PUSH(r->session->arena, r->origins, r->origin_count, r->origin_capacity,
               desc->tree->span);
    ARENA_PUSH(r->session->arena, scene->objects, count, r->object_capacity, object);
    scene->object_count = (int)count;
    return true;
}

/* Reports whether a mesh is split by the file's materials into an object for each: the document
 * gives no material, neither for the mesh nor for its groups. */
static bool is_in_parts(const SceneNodeDesc *desc, int material)
{
    const Tree *file = desc->kind == SCENE_Mesh ? scene_node_given(desc, S_Mesh_file) : NULL;
    const char *dot = file && file->kind == TREE_scalar ? strrchr(file->text, '.') : NULL;
    return dot && (!strcmp(dot, ".gltf") || !strcmp(dot, ".glb")) && material < 0 &&
           !scene_node_given(desc, S_Mesh_material);
}

static bool add_parts(SceneReader *r, const SceneNodeDesc *desc, SceneObject object)
{
    const Tree *file = scene_node_given(desc, S_Mesh_file);
    int first;
    const int count = scene_mesh_read_parts(r, file, &first);
    for (int i = first; i < first + count; i++) {
        object.mesh = i;
        object.material = scene_material_read_of(r, file, r->scene->meshes[i].part);
        if (object.material < 0 || (i > first && !count_node(r, desc->tree->span)) ||
            !push_object(r, desc, object))
            return false;
    }
    return count >= 0;
}

static bool add_object(SceneReader *r, const SceneNodeDesc *desc, const Around *around)
{
    const bool round =
        desc->kind == SCENE_Sphere || desc->kind == SCENE_Cylinder || desc->kind == SCENE_Cone;
    SceneObject object = {.kind = desc->kind,
                          .name = around->name,
                          .adapts = round && !tree_find(desc->tree, "detail"),
                          .world_from_local = around->world_from_group};
    read_numbers(desc, &object);
    object.material = around->material;
    if (!check_matrix(r, desc, &object) || !check_parallelogram(r, desc, &object))
        return false;
    if (is_in_parts(desc, object.material))
        return add_parts(r, desc, object);
    if (!find_mesh(r, desc, &object.mesh))
        return false;
    if (object.material < 0)
        return scene_node_given(desc, rows[desc->kind].material)
                   ? r->fine
                   : fault_missing(r, desc, "material");
    return (desc->kind != SCENE_Plane || r->aside || add_plane(r, desc)) &&
           push_object(r, desc, object);
}

static void read_list(SceneReader *r, const Tree *list, const Around *around);
static bool read_copies(SceneReader *r, const SceneNodeDesc *desc, const Around *around);
static bool read_instance(SceneReader *r, const SceneNodeDesc *desc, const Around *around);

/* Records a top-level position, a candidate for the origin: scene_origin.c. */
static void add_root(SceneReader *r, const SceneNodeDesc *desc, const SceneMatrix *matrix)
{
    Scene *scene = r->scene;
    size_t count = (size_t)scene->root_count;
    SceneRoot root = {.number = scene->root_count, .plane = desc->kind == SCENE_Plane};
    memcpy(root.at, matrix->m + 12, sizeof root.at);
    ARENA_PUSH(r->session->arena, scene->roots, count, r->root_capacity, root);
    scene->root_count = (int)count;
}

/* Reads an object. An error in it is reported once, however often the object is used. */
static void read_object(SceneReader *r, Tree *tree, const Around *around)
{
    SceneNodeDesc desc;
    if (!scene_node_read(r, tree, SCENE_SORT_object, &desc))
        return;
    const Transform *transform = scene_node_transform(&desc, rows[desc.kind].transform);
    const SceneMatrix own = transform ? scene_matrix_of(transform) : scene_matrix_identity();
    const Around here = {.world_from_group = scene_matrix_multiply(&around->world_from_group, &own),
                         .material = material_of(r, &desc, around->material),
                         .depth = around->depth + 1,
                         .name = name_of(r, &desc, around->name)};
    if (around->depth == 0 && !r->aside)
        add_root(r, &desc, &here.world_from_group);
    if (here.depth > LIMIT_DEPTH) {
        diag_add(r->session, tree->span, DIAG_too_deep, LIMIT_DEPTH);
        tree->failed = true, r->fine = false;
    } else if (desc.kind == SCENE_Scatter)
        tree->failed = !read_copies(r, &desc, &here);
    else if (desc.kind == SCENE_Instance)
        tree->failed = !read_instance(r, &desc, &here);
    else if (desc.kind != SCENE_Group)
        tree->failed = !add_object(r, &desc, &here);
    else if (scene_node_given(&desc, S_Group_objects))
        read_list(r, scene_node_given(&desc, S_Group_objects), &here);
}

/* Reads a list. Every use of an alias counts, since nested aliases can multiply objects without
 * limit. */
static void read_list(SceneReader *r, const Tree *list, const Around *around)
{
    for (uint32_t i = 0; i < list->count && count_node(r, list->items[i]->span); i++)
        read_object(r, list->items[i], around);
}

/* Reads an instance. A definition is open while its content is read: an instance of an open
 * definition contains itself. Returns false after an error was reported. */
static bool read_instance(SceneReader *r, const SceneNodeDesc *desc, const Around *around)
{
    const Tree *name = scene_node_given(desc, S_Instance_of);
    Tree *definition = name ? scene_definition_find(r, name) : NULL;
    if (!name)
        return fault_missing(r, desc, "of");
    if (definition && definition->open) {
        diag_add(r->session, name->span, DIAG_cycle, name->text);
        return r->fine = false;
    }
    if (!definition || !count_node(r, desc->tree->span))
        return false;
    definition->open = true;
    read_object(r, definition, around);
    definition->open = false;
    return true;
}

static bool has(const SceneNodeDesc *desc, const char *key)
{
    return tree_find(desc->tree, key) != NULL;
}

static bool fault_scatter(SceneReader *r, const SceneNodeDesc *desc, int param, const char *what)
{
    return fault(r, scene_node_span(desc, param), DIAG_scene_scatter, what);
}

static bool check_scatter(SceneReader *r, const SceneNodeDesc *desc)
{
    const bool on = scene_node_given(desc, S_Scatter_on) != NULL;
    if (scene_node_number(desc, S_Scatter_least) > scene_node_number(desc, S_Scatter_most))
        return fault_scatter(r, desc, S_Scatter_least, "the least scale is greater than the most");
    if (on && has(desc, "size"))
        return fault_scatter(
            r, desc, S_Scatter_size,
            "`on` and `size` are mutually exclusive: copies are either on a surface or in a box");
    if (has(desc, "density") && has(desc, "count"))
        return fault_scatter(r, desc, S_Scatter_density,
                             "there are as many copies as one says: `density` or `count`");
    if (!on && has(desc, "density"))
        return fault_scatter(r, desc, S_Scatter_density, "`density` needs a surface: set `on`");
    if (!on && has(desc, "aligned"))
        return fault_scatter(r, desc, S_Scatter_aligned, "alignment needs a surface: set `on`");
    return true;
}

static bool make_surface(SceneReader *r, const SceneNodeDesc *desc, int first, SceneSurface *made)
{
    const Scene *scene = r->scene;
    for (int i = first; i < scene->object_count; i++)
        if (scene->objects[i].kind == SCENE_Plane)
            return fault_scatter(r, desc, S_Scatter_on,
                                 "copies cannot be distributed evenly on an infinite plane");
    if (!scene_surface_make(scene, scene->objects + first, scene->object_count - first, made) ||
        (r->surface_triangles += made->count) > SCENE_SURFACE_TRIANGLES)
        return fault_scatter(r, desc, S_Scatter_on,
                             "the surfaces of all Scatters have too many triangles in total");
    return scene_surface_area(made) > 0 ||
           fault_scatter(r, desc, S_Scatter_on, "the surface has no area");
}

/* Reads the objects of a tree in local space, outside the scene. They are appended; the caller
 * removes them by restoring object_count. */
static void read_aside(SceneReader *r, Tree *tree, int depth)
{
    const bool before = r->aside;
    const size_t stands = r->stand_count;
    r->aside = true;
    read_object(
        r, tree,
        &(Around){.world_from_group = scene_matrix_identity(), .material = 0, .depth = depth});
    r->aside = before;
    r->stand_count = stands;
}

/* Reads the surface of a Scatter, in the copies' space. Returns false after an error was
 * reported. */
static bool read_surface(SceneReader *r, const SceneNodeDesc *desc, const Around *around,
                         SceneSurface *made)
{
    Scene *scene = r->scene;
    const int objects = scene->object_count;
    *made = (SceneSurface){0};
    if (!count_node(r, desc->tree->span))
        return false;
    read_aside(r, scene_node_given(desc, S_Scatter_on), around->depth);
    const bool done = r->fine && make_surface(r, desc, objects, made);
    if (done)
        scene_stand_open(r, &around->world_from_group, objects,
                         scene_node_number(desc, S_Scatter_aligned) != 0);
    scene->object_count = objects;
    return done;
}

/* Returns the number of copies for a density, rounded to nearest; limited to one more than
 * allowed. */
static int copies_of(const SceneNodeDesc *desc, const SceneSurface *surface)
{
    if (!has(desc, "density"))
        return (int)scene_node_number(desc, S_Scatter_count);
    return (int)fmin(scene_node_number(desc, S_Scatter_density) * scene_surface_area(surface) + .5,
                     SCENE_OBJECTS + 1);
}

/* Adds copies up to the first error, which all of them would repeat. */
static void add_copies(SceneReader *r, const SceneNodeDesc *desc, const Around *around,
                       const SceneScatter *scatter)
{
    const Tree *list = scene_node_given(desc, S_Scatter_objects);
    const int count = copies_of(desc, scatter->surface);
    uint64_t state = (uint64_t)scene_node_number(desc, S_Scatter_seed);
    const size_t stand = r->stand_count - 1; /* copies may have surfaces of their own */
    for (int i = 0; list && i < count && (i == 0 || r->fine) && count_node(r, desc->tree->span);
         i++) {
        SceneStood stood = {.first = r->scene->object_count};
        scene_scatter_numbers(state, stood.numbers);
        const SceneMatrix own = scene_scatter_matrix(scatter, &state);
        const Around here = {.world_from_group =
                                 scene_matrix_multiply(&around->world_from_group, &own),
                             .material = around->material,
                             .depth = around->depth,
                             .name = around->name};
        read_list(r, list, &here);
        stood.end = r->scene->object_count;
        if (scatter->surface)
            scene_stand_add(r, stand, &stood);
    }
}

/* Reads a Scatter. Returns false after an error was reported. */
static bool read_copies(SceneReader *r, const SceneNodeDesc *desc, const Around *around)
{
    SceneSurface surface = {0};
    const bool on = scene_node_given(desc, S_Scatter_on) != NULL;
    SceneScatter scatter = {.least = scene_node_number(desc, S_Scatter_least),
                            .most = scene_node_number(desc, S_Scatter_most),
                            .surface = on ? &surface : NULL,
                            .aligned = scene_node_number(desc, S_Scatter_aligned) != 0};
    scene_node_vector(desc, S_Scatter_size, scatter.size);
    scene_node_vector(desc, S_Scatter_rotation, scatter.rotation);
    const bool fine = check_scatter(r, desc) && (!on || read_surface(r, desc, around, &surface));
    if (fine)
        add_copies(r, desc, around, &scatter);
    scene_surface_free(&surface);
    return fine;
}

void scene_objects_read(SceneReader *r, const Tree *list)
{
    read_list(r, list, &(Around){.world_from_group = scene_matrix_identity(), .material = -1});
}

/* All definitions together may have as many objects as a scene. */
void scene_objects_check_unused(SceneReader *r)
{
    const int objects = r->scene->object_count;
    r->objects = 0;
    for (uint32_t i = 0; r->definitions && i < r->definitions->count; i++) {
        Tree *definition = scene_definition_unused(r, i);
        if (definition)
            read_aside(r, definition, 0);
        r->scene->object_count = objects;
    }
}
