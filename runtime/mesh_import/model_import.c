/* Converts assimp's scene to a single list of triangles. */
#include "runtime/gl/message.h"
#include "runtime/mesh_import/model_attributes.h"
#include "runtime/mesh_import/model_join.h"
#include "runtime/mesh_import/model_number.h"
#include "runtime/mesh_import/model_open.h"
#include "runtime/mesh_import/model_reader.h"
#include <stdlib.h>
#include <string.h>

#ifndef MATC_ASSIMP
bool model_import(const ModelSource *source, ModelParts *parts, char *error, size_t capacity)
{
    (void)source;
    *parts = (ModelParts){0};
    return message_fail(
        error, capacity,
        "this matview was built without assimp (Debian: libassimp-dev), which reads meshes");
}
#else
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

/* Vertices are welded by model_join.c instead: assimp 5.2 hashes positions only, and takes
 * quadratic time for many vertices in one place. */
static const unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType |
                              aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure;

/* Source of a mesh's vertices. */
typedef struct {
    const struct aiMesh *mesh;
    const ModelAttributes *attributes;
    int numbers; /* set of texture coordinates with vertex numbers; -1: none */
} Origin;

/* Meshes of points or lines are skipped. */
static bool has_triangles(const struct aiMesh *mesh)
{
    return mesh->mPrimitiveTypes & aiPrimitiveType_TRIANGLE;
}

static void count(const struct aiScene *scene, size_t *vertices, size_t *indices)
{
    *vertices = *indices = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        if (!has_triangles(scene->mMeshes[m]))
            continue;
        *vertices += scene->mMeshes[m]->mNumVertices;
        *indices += (size_t)scene->mMeshes[m]->mNumFaces * 3;
    }
}

/* Copies a vector; adding 0 turns -0 into +0, since vertices are compared by their bytes. */
static void put(float to[3], const struct aiVector3D *from)
{
    to[0] = from->x + 0.f, to[1] = from->y + 0.f, to[2] = from->z + 0.f;
}

/* Returns the set of texture coordinates that holds vertex numbers: the set with three
 * components (model_number.c). -1: absent. */
static int numbers_of(const struct aiMesh *mesh)
{
    int i = MODEL_COORDINATES - 1;
    while (i >= 0 && (!mesh->mTextureCoords[i] || mesh->mNumUVComponents[i] != 3))
        i--;
    return i;
}

static bool has_set(const struct aiMesh *mesh, int set)
{
    return mesh->mTextureCoords[set] && numbers_of(mesh) != set;
}

/* Returns the primitive of a vertex and the vertex's index in that primitive. NULL: the
 * primitive has no application-specific attributes. */
static const ModelPrimitive *primitive_of(const Origin *from, unsigned i, size_t *vertex)
{
    if (from->numbers < 0)
        return NULL;
    const struct aiVector3D *number = &from->mesh->mTextureCoords[from->numbers][i];
    if (!(number->z >= 1 && number->z <= (float)from->attributes->count && number->x >= 0))
        return NULL;
    const ModelPrimitive *primitive = &from->attributes->primitives[(size_t)number->z - 1];
    *vertex = number->x < (float)primitive->vertex_count ? (size_t)number->x : 0;
    return primitive->vertex_count ? primitive : NULL;
}

/* Allocates the extra attributes that any mesh has. Meshes without such an attribute get white
 * for colors and 0 for other attributes. */
static bool make_extras(const struct aiScene *scene, const ModelAttributes *attributes,
                        size_t vertices, ModelParts *parts)
{
    bool has[SHAPE_EXTRAS] = {0};
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh *mesh = scene->mMeshes[m];
        has[SHAPE_EXTRA_color] |= has_triangles(mesh) && mesh->mColors[0];
        has[SHAPE_EXTRA_uv1] |= has_triangles(mesh) && has_set(mesh, 1);
    }
    for (int i = 0; i < SHAPE_NAMED; i++)
        has[SHAPE_EXTRA_named + i] = attributes->names[i][0];
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (has[i] &&
            !(parts->shape.extra[i] = calloc(vertices + 1, sizeof *parts->shape.extra[i])))
            return false;
    memcpy(parts->shape.names, attributes->names, sizeof attributes->names);
    return true;
}

/* Writes all extra attributes of the vertex after the shape's last. */
static void put_extras(const Origin *from, unsigned i, Shape *shape)
{
    static const float white[4] = {1, 1, 1, 1};
    float(*color)[4] = shape->extra[SHAPE_EXTRA_color], (*uv1)[4] = shape->extra[SHAPE_EXTRA_uv1];
    const int to = shape->vertex_count;
    size_t vertex = 0;
    if (color)
        memcpy(color[to],
               from->mesh->mColors[0] ? (const float *)&from->mesh->mColors[0][i] : white,
               sizeof *color);
    if (uv1 && has_set(from->mesh, 1)) {
        uv1[to][0] = from->mesh->mTextureCoords[1][i].x;
        uv1[to][1] = from->mesh->mTextureCoords[1][i].y;
    } else if (uv1)
        memset(uv1[to], 0, sizeof *uv1);
    const ModelPrimitive *primitive = primitive_of(from, i, &vertex);
    for (int k = 0; k < SHAPE_NAMED; k++) {
        float(*named)[4] = shape->extra[SHAPE_EXTRA_named + k];
        if (named && primitive && primitive->values[k])
            memcpy(named[to], primitive->values[k][vertex], sizeof *named);
        else if (named)
            memset(named[to], 0, sizeof *named);
    }
}

/* Writes a vertex after the shape's last, and welds it with an equal vertex of the same mesh. */
static bool add_vertex(const Origin *from, unsigned i, ModelJoin *join)
{
    const struct aiMesh *mesh = from->mesh;
    Shape *shape = join->shape;
    ShapeVertex *vertex = &shape->vertices[shape->vertex_count];
    *vertex = (ShapeVertex){0};
    put_extras(from, i, shape);
    put(vertex->position, &mesh->mVertices[i]);
    if (mesh->mNormals)
        put(vertex->normal, &mesh->mNormals[i]);
    if (has_set(mesh, 0)) {
        vertex->uv[0] = mesh->mTextureCoords[0][i].x + 0.f;
        vertex->uv[1] = mesh->mTextureCoords[0][i].y + 0.f;
    }
    return model_join_add(join, i);
}

static bool add_vertices(const struct aiMesh *mesh, const ModelAttributes *attributes,
                         ModelJoin *join)
{
    const Origin from = {mesh, attributes, numbers_of(mesh)};
    for (unsigned i = 0; i < mesh->mNumVertices; i++)
        if (!add_vertex(&from, i, join))
            return false;
    return true;
}

/* Returns a mesh's material. Material names of a glTF file are indices (model_number.h). */
static int material_of(const struct aiScene *scene, const struct aiMesh *mesh)
{
    struct aiString name = {0};
    if (mesh->mMaterialIndex >= scene->mNumMaterials)
        return MODEL_NO_MATERIAL;
    aiGetMaterialString(scene->mMaterials[mesh->mMaterialIndex], AI_MATKEY_NAME, &name);
    return model_material_number(name.data);
}

static bool add_mesh(const struct aiMesh *mesh, int material, const ModelAttributes *attributes,
                     ModelParts *parts)
{
    ModelJoin join;
    const int before = parts->shape.index_count, first = parts->shape.vertex_count;
    const bool joined = model_join_open(&join, &parts->shape, mesh->mNumVertices) &&
                        add_vertices(mesh, attributes, &join);
    for (unsigned f = 0; joined && f < mesh->mNumFaces; f++)
        for (unsigned k = 0; k < 3 && mesh->mFaces[f].mNumIndices == 3; k++) {
            /* An index out of range stays invalid; the parent process validates all indices. */
            const unsigned index = mesh->mFaces[f].mIndices[k];
            parts->shape.indices[parts->shape.index_count++] =
                index < mesh->mNumVertices ? join.joined[index] : UINT32_MAX;
        }
    parts->runs[parts->run_count++] = (ModelRun){.material = material,
                                                 .index_count = parts->shape.index_count - before,
                                                 .vertex_count = parts->shape.vertex_count - first,
                                                 .has_normals = mesh->mNormals != NULL,
                                                 .has_coordinates = has_set(mesh, 0)};
    model_join_close(&join);
    return joined;
}

static bool fail_many(size_t vertices, size_t indices, char *error, size_t capacity)
{
    return message_fail(error, capacity,
                        "it has %zu vertices and %zu triangles; at most %d and %d are drawn",
                        vertices, indices / 3, MODEL_VERTICES, MODEL_INDICES / 3);
}

static bool take(const struct aiScene *scene, const ModelAttributes *attributes, ModelParts *parts,
                 char *error, size_t capacity)
{
    size_t vertices, indices;
    count(scene, &vertices, &indices);
    if (indices > MODEL_INDICES)
        return fail_many(vertices, indices, error, capacity);
    const size_t most = vertices < MODEL_VERTICES ? vertices : MODEL_VERTICES;
    *parts = (ModelParts){0};
    parts->shape.vertices = calloc(most + 1, sizeof *parts->shape.vertices);
    parts->shape.indices = calloc(indices + 1, sizeof *parts->shape.indices);
    parts->runs = calloc((size_t)scene->mNumMeshes + 1, sizeof *parts->runs);
    if (!parts->shape.vertices || !parts->shape.indices || !parts->runs ||
        !make_extras(scene, attributes, most, parts))
        return message_fail(error, capacity, "out of memory");
    bool fits = true;
    for (unsigned m = 0; fits && m < scene->mNumMeshes; m++)
        if (has_triangles(scene->mMeshes[m]))
            fits = add_mesh(scene->mMeshes[m], material_of(scene, scene->mMeshes[m]), attributes,
                            parts);
    return fits || fail_many(vertices, indices, error, capacity);
}

/* Returns assimp's error message; std::bad_alloc is replaced by a message for authors. */
static const char *reported(void)
{
    const char *text = aiGetErrorString();
    return strcmp(text, "std::bad_alloc")
               ? text
               : "reading needs too much memory: the file is corrupt or too large";
}

bool model_import(const ModelSource *source, ModelParts *parts, char *error, size_t capacity)
{
    Arena arena = {0};
    ModelAttributes attributes;
    *parts = (ModelParts){0};
    bool done = model_attributes_read(&arena, source, &attributes, error, capacity);
    struct aiFileIO files = model_open_files(source->root);
    const struct aiScene *scene = done ? aiImportFileEx(source->path, steps, &files) : NULL;
    if (done && !scene)
        done = message_fail(error, capacity, "%s", reported());
    if (scene) {
        done = take(scene, &attributes, parts, error, capacity);
        aiReleaseImport(scene);
    }
    arena_free(&arena);
    return done;
}
#endif
