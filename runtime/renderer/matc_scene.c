/* The library's public functions for scenes: names, and additions and removals by the host. */
#include "compiler/document.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include "runtime/renderer/host.h"
#include "runtime/mesh_import/model.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_origin.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

MatcScene *matc_scene_read(const char *name, const char *text, size_t size,
                           const MatcOptions *options, MatcDocument **document)
{
    MatcOptions defaults;
    if (!document)
        return NULL; /* the caller could not free the document */
    MatcScene *made = memory_checked(calloc(1, sizeof *made));
    matc_options_init(&defaults);
    defaults.pixels = true;
    made->document = *document =
        scene_read(name, text, size, options ? options : &defaults, &made->scene);
    if (made->scene)
        return made;
    if (!matc_error_count(*document))
        diag_add(&(*document)->session, NO_SPAN, DIAG_no_scene);
    free(made);
    return NULL;
}

void matc_scene_free(MatcScene *scene)
{
    if (scene)
        scene_free(scene->scene);
    free(scene);
}

const char *matc_scene_error(const MatcScene *s) { return s ? s->error : "the scene is NULL"; }

int matc_scene_object_count(const MatcScene *s) { return s ? s->scene->object_count : 0; }
int matc_scene_light_count(const MatcScene *s) { return s ? s->scene->light_count : 0; }
int matc_scene_material_count(const MatcScene *s) { return s ? s->scene->material_count : 0; }

static bool is_object(const MatcScene *s, int object)
{
    return object >= 0 && object < matc_scene_object_count(s);
}

void matc_scene_matrix(const MatcScene *s, int object, double matrix[16])
{
    const SceneMatrix identity = scene_matrix_identity();
    const SceneMatrix *of =
        is_object(s, object) ? &s->scene->objects[object].world_from_local : &identity;
    if (!matrix)
        return;
    memcpy(matrix, of->m, sizeof of->m);
    if (of != &identity)
        scene_origin_from(s->scene, of->m + 12, matrix + 12);
}

/* -- names */

const char *matc_scene_object_name(const MatcScene *s, int object)
{
    return is_object(s, object) ? s->scene->objects[object].name : NULL;
}

/* Reports whether an object has the name, or is in a group of that name: "lamps" finds
 * "lamps/bulb". */
static bool goes_by(const char *name, const char *wanted)
{
    const size_t size = strlen(wanted);
    return name && !strncmp(name, wanted, size) && (!name[size] || name[size] == '/');
}

int matc_scene_find_object(const MatcScene *s, const char *name, int after)
{
    if (!name || after >= matc_scene_object_count(s))
        return -1;
    for (int i = after < 0 ? 0 : after + 1; i < matc_scene_object_count(s); i++)
        if (goes_by(s->scene->objects[i].name, name))
            return i;
    return -1;
}

int matc_scene_find_light(const MatcScene *s, const char *name)
{
    for (int i = 0; name && i < matc_scene_light_count(s); i++)
        if (s->scene->lights[i].name && !strcmp(s->scene->lights[i].name, name))
            return i;
    return -1;
}

/* Returns an array of the scene with capacity for one more element. The first growth copies it
 * out of the reader's memory. */
static void *with_capacity(const MatcScene *s, void *array, int count, size_t *capacity,
                           size_t size)
{
    enum { LEAST = 8 };
    if ((size_t)count < *capacity)
        return array;
    *capacity = 2 * (size_t)count + LEAST;
    void *moved = arena_zero(s->document->session.arena, *capacity * size);
    if (count)
        memcpy(moved, array, (size_t)count * size);
    return moved;
}

int matc_scene_find_material(MatcScene *s, const char *name)
{
    if (!s)
        return -1;
    if (!name)
        return message_fail(s->error, sizeof s->error, "the name is NULL"), -1;
    Scene *scene = s->scene;
    for (int i = 0; i < scene->material_count; i++) {
        const SceneMaterial *of = &scene->materials[i];
        if (of->document == s->document &&
            !strcmp(matc_material_name(of->document, of->index), name))
            return i;
    }
    const int index = matc_material_find(s->document, name);
    if (index < 0)
        return message_fail(s->error, sizeof s->error, "the document has no material '%s'", name),
               -1;
    if (scene->displaced) /* displacement data is indexed by material */
        return message_fail(s->error, sizeof s->error,
                            "a scene with displaced objects takes no further materials"),
               -1;
    scene->materials = with_capacity(s, scene->materials, scene->material_count,
                                     &s->material_capacity, sizeof *scene->materials);
    scene->materials[scene->material_count] = (SceneMaterial){s->document, index};
    return scene->material_count++;
}

/* -- meshes */

static bool is_mesh(MatcScene *s, const MatcMesh *mesh)
{
    if (!mesh || mesh->size < sizeof(size_t) + sizeof(float *))
        return message_fail(s->error, sizeof s->error, "MatcMesh.size is to be sizeof(MatcMesh)");
    if (s->scene->displaced)
        return message_fail(s->error, sizeof s->error,
                            "a scene with displaced objects takes no further meshes");
    return true;
}

static bool check_counts(MatcScene *s, const MatcMesh *mesh)
{
    if (!mesh->positions || mesh->vertex_count < 1 || mesh->vertex_count > MODEL_VERTICES)
        return message_fail(s->error, sizeof s->error, "a mesh has positions, of 1 to %d vertices",
                            MODEL_VERTICES);
    return (mesh->index_count >= 0 && mesh->index_count <= MODEL_INDICES &&
            !mesh->indices == !mesh->index_count) ||
           message_fail(s->error, sizeof s->error, "a mesh has at most %d indices, or none",
                        MODEL_INDICES);
}

/* Checks normals and texture coordinates; completing the mesh checks positions. */
static bool check_attributes(MatcScene *s, const MatcMesh *mesh)
{
    const float *const lists[] = {mesh->normals, mesh->texcoords};
    static const size_t components[] = {3, 2};
    for (int list = 0; list < 2; list++)
        for (size_t i = 0; lists[list] && i < components[list] * (size_t)mesh->vertex_count; i++)
            if (!isfinite(lists[list][i]))
                return message_fail(s->error, sizeof s->error,
                                    "the mesh: a normal or a coordinate is no number");
    return true;
}

static void take_vertices(const MatcMesh *mesh, Shape *shape)
{
    for (int i = 0; i < shape->vertex_count; i++) {
        ShapeVertex *to = &shape->vertices[i];
        memcpy(to->position, mesh->positions + 3 * (size_t)i, sizeof to->position);
        if (mesh->normals)
            memcpy(to->normal, mesh->normals + 3 * (size_t)i, sizeof to->normal);
        if (mesh->texcoords)
            memcpy(to->uv, mesh->texcoords + 2 * (size_t)i, sizeof to->uv);
    }
    for (int i = 0; i < shape->index_count; i++)
        shape->indices[i] = mesh->indices ? mesh->indices[i] : (uint32_t)i;
}

static bool make_shape(MatcScene *s, const MatcMesh *mesh, Shape *shape)
{
    const int indices = mesh->indices ? mesh->index_count : mesh->vertex_count;
    *shape = (Shape){
        .vertices = memory_checked(calloc((size_t)mesh->vertex_count, sizeof *shape->vertices)),
        .indices = memory_checked(calloc((size_t)indices, sizeof *shape->indices)),
        .vertex_count = mesh->vertex_count,
        .index_count = indices};
    take_vertices(mesh, shape);
    const char *fault =
        model_complete_in_place(shape, mesh->normals != NULL, mesh->texcoords != NULL);
    if (!fault)
        return true;
    shape_free(shape);
    return message_fail(s->error, sizeof s->error, "the mesh: %s", fault);
}

int matc_scene_add_mesh(MatcScene *s, const MatcMesh *given)
{
    MatcMesh mesh = {0};
    SceneMesh made = {.path = "", .part = -1};
    if (!s || !is_mesh(s, given))
        return -1;
    Scene *scene = s->scene;
    memcpy(&mesh, given, given->size < sizeof mesh ? given->size : sizeof mesh);
    if (!check_counts(s, &mesh) || !check_attributes(s, &mesh) ||
        !make_shape(s, &mesh, &made.shape))
        return -1;
    scene->meshes = with_capacity(s, scene->meshes, scene->mesh_count, &s->mesh_capacity,
                                  sizeof *scene->meshes);
    scene->meshes[scene->mesh_count] = made;
    return scene->mesh_count++;
}

/* -- objects */

static bool is_matrix(const double m[16])
{
    double x[3], y[3], z[3], cross[3];
    for (int i = 0; i < 16; i++)
        if (!(fabs(m[i]) < 1e30))
            return false;
    memcpy(x, m, sizeof x);
    memcpy(y, m + 4, sizeof y);
    memcpy(z, m + 8, sizeof z);
    if (!vec3_normalize(x) || !vec3_normalize(y) || !vec3_normalize(z))
        return false;
    vec3_cross(y, z, cross);
    return fabs(vec3_dot(x, cross)) > 1e-9 && m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
}

static bool check_object(MatcScene *s, int mesh, int material, const double matrix[16])
{
    const Scene *scene = s->scene;
    if (scene->displaced)
        return message_fail(s->error, sizeof s->error,
                            "a scene with displaced objects takes no further objects");
    if (mesh < 0 || mesh >= scene->mesh_count)
        return message_fail(s->error, sizeof s->error, "no mesh %d", mesh);
    if (material < 0 || material >= scene->material_count)
        return message_fail(s->error, sizeof s->error, "no material %d", material);
    const SceneMaterial *of = &scene->materials[material];
    if (matc_moves(of->document, of->index, NULL) != MATC_MOVES_none)
        return message_fail(s->error, sizeof s->error,
                            "the material '%s' displaces: an object that is added cannot be",
                            matc_material_name(of->document, of->index));
    return (matrix && is_matrix(matrix)) ||
           message_fail(s->error, sizeof s->error, "the matrix flattens, or is no number");
}

/* Returns the index of a removed object, or appends a new one; -1 if there are too many. */
static int find_place(MatcScene *s)
{
    Scene *scene = s->scene;
    for (int i = 0; i < scene->object_count; i++)
        if (scene->objects[i].removed)
            return i;
    if (scene->object_count >= SCENE_OBJECTS)
        return -1;
    scene->objects = with_capacity(s, scene->objects, scene->object_count, &s->object_capacity,
                                   sizeof *scene->objects);
    return scene->object_count++;
}

int matc_scene_add_object(MatcScene *s, int mesh, int material, const double matrix[16])
{
    if (!s || !check_object(s, mesh, material, matrix))
        return -1;
    const int place = find_place(s);
    if (place < 0)
        return message_fail(s->error, sizeof s->error, "a scene has %d objects at most",
                            SCENE_OBJECTS),
               -1;
    SceneObject *object = &s->scene->objects[place];
    *object = (SceneObject){.kind = SCENE_Mesh, .mesh = mesh, .material = material};
    memcpy(object->world_from_local.m, matrix, sizeof object->world_from_local.m);
    scene_origin_to(s->scene, matrix + 12, object->world_from_local.m + 12);
    return place;
}

static bool has_object(MatcScene *s, int object)
{
    if (!s)
        return false;
    return (is_object(s, object) && !s->scene->objects[object].removed) ||
           message_fail(s->error, sizeof s->error, "no object %d", object);
}

bool matc_scene_set_visible(MatcScene *s, int object, bool visible)
{
    if (!has_object(s, object))
        return false;
    s->scene->objects[object].hidden = !visible;
    return true;
}

bool matc_scene_remove_object(MatcScene *s, int object)
{
    if (!has_object(s, object))
        return false;
    SceneObject *of = &s->scene->objects[object];
    of->hidden = of->removed = true;
    of->name = NULL;
    return true;
}
