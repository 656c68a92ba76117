/* Assimp's scene as one list of triangles. */
#include "runtime/scene/model_import.h"
#include "runtime/gl/message.h"
#include "runtime/scene/model_attributes.h"
#include "runtime/scene/model_number.h"
#include "runtime/scene/model_open.h"
#include <stdlib.h>
#include <string.h>

#ifndef MATC_ASSIMP
bool model_import(const char *path, ModelParts *parts, char *error, size_t room)
{
    (void)path;
    *parts = (ModelParts){0};
    return message_fail(error, room,
                        "this matview was built without assimp (Debian: libassimp-dev), which reads meshes");
}
#else
#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

static const unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                              aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure;

/* Where vertices come from. */
typedef struct {
    const struct aiMesh *mesh;
    const ModelAttributes *attributes;
    int numbers; /* of vertices: which set of texture coordinates */
} Origin;

/* Points and lines have no surface. */
static bool has_triangles(const struct aiMesh *mesh) { return mesh->mPrimitiveTypes & aiPrimitiveType_TRIANGLE; }

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

static void put(float to[3], const struct aiVector3D *from) { to[0] = from->x, to[1] = from->y, to[2] = from->z; }

/* The set of texture coordinates that is numbers of vertices: the one of three (model_number_vertices.c); -1: it has none. */
static int numbers_of(const struct aiMesh *mesh)
{
    int i = MODEL_COORDINATES - 1;
    while (i >= 0 && (!mesh->mTextureCoords[i] || mesh->mNumUVComponents[i] != 3))
        i--;
    return i;
}

static bool has_set(const struct aiMesh *mesh, int set) { return mesh->mTextureCoords[set] && numbers_of(mesh) != set; }

/* The primitive that a vertex came from, and which of its vertices it is; NULL: none that has attributes of the author's. */
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

/* What the meshes have of the extras; those that lack it are white, or have 0. */
static bool make_extras(const struct aiScene *scene, const ModelAttributes *attributes, size_t vertices,
                        ModelParts *parts)
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
        if (has[i] && !(parts->shape.extra[i] = calloc(vertices + 1, sizeof *parts->shape.extra[i])))
            return false;
    for (size_t k = 0; has[SHAPE_EXTRA_color] && k < 4 * vertices; k++)
        parts->shape.extra[SHAPE_EXTRA_color][k / 4][k % 4] = 1;
    memcpy(parts->shape.names, attributes->names, sizeof attributes->names);
    return true;
}

static void put_extras(const Origin *from, unsigned i, Shape *shape)
{
    float(*color)[4] = shape->extra[SHAPE_EXTRA_color], (*uv1)[4] = shape->extra[SHAPE_EXTRA_uv1];
    const int to = shape->vertex_count;
    size_t vertex = 0;
    if (color && from->mesh->mColors[0])
        memcpy(color[to], &from->mesh->mColors[0][i], sizeof *color);
    if (uv1 && has_set(from->mesh, 1)) {
        uv1[to][0] = from->mesh->mTextureCoords[1][i].x;
        uv1[to][1] = from->mesh->mTextureCoords[1][i].y;
    }
    const ModelPrimitive *primitive = primitive_of(from, i, &vertex);
    for (int k = 0; primitive && k < SHAPE_NAMED; k++)
        if (primitive->values[k])
            memcpy(shape->extra[SHAPE_EXTRA_named + k][to], primitive->values[k][vertex],
                   sizeof primitive->values[k][vertex]);
}

static void add_vertices(const struct aiMesh *mesh, const ModelAttributes *attributes, ModelParts *parts)
{
    const Origin from = {mesh, attributes, numbers_of(mesh)};
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        put_extras(&from, i, &parts->shape);
        ShapeVertex *vertex = &parts->shape.vertices[parts->shape.vertex_count++];
        put(vertex->position, &mesh->mVertices[i]);
        if (mesh->mNormals)
            put(vertex->normal, &mesh->mNormals[i]);
        if (has_set(mesh, 0)) {
            vertex->uv[0] = mesh->mTextureCoords[0][i].x;
            vertex->uv[1] = mesh->mTextureCoords[0][i].y;
        }
    }
    parts->has_normals &= mesh->mNormals != NULL;
    parts->has_coordinates &= has_set(mesh, 0);
}

/* Of a mesh; names of a glTF's are numbers (model_number.h). */
static int material_of(const struct aiScene *scene, const struct aiMesh *mesh)
{
    struct aiString name = {0};
    if (mesh->mMaterialIndex >= scene->mNumMaterials)
        return MODEL_NO_MATERIAL;
    aiGetMaterialString(scene->mMaterials[mesh->mMaterialIndex], AI_MATKEY_NAME, &name);
    return model_material_number(name.data);
}

static void add_mesh(const struct aiMesh *mesh, int material, const ModelAttributes *attributes, ModelParts *parts)
{
    const uint32_t first = (uint32_t)parts->shape.vertex_count;
    const int before = parts->shape.index_count;
    add_vertices(mesh, attributes, parts);
    for (unsigned f = 0; f < mesh->mNumFaces; f++)
        for (unsigned k = 0; k < 3 && mesh->mFaces[f].mNumIndices == 3; k++) {
            /* one that is out of range stays so: the parts are checked */
            const unsigned index = mesh->mFaces[f].mIndices[k];
            parts->shape.indices[parts->shape.index_count++] = index < mesh->mNumVertices ? first + index : UINT32_MAX;
        }
    parts->runs[parts->run_count++] = (ModelRun){material, parts->shape.index_count - before};
}

static bool take(const struct aiScene *scene, const ModelAttributes *attributes, ModelParts *parts, char *error,
                 size_t room)
{
    size_t vertices, indices;
    count(scene, &vertices, &indices);
    if (vertices > MODEL_VERTICES || indices > MODEL_INDICES)
        return message_fail(error, room, "it has %zu vertices and %zu triangles; at most %d and %d are drawn", vertices,
                            indices / 3, MODEL_VERTICES, MODEL_INDICES / 3);
    *parts = (ModelParts){.has_normals = true, .has_coordinates = true};
    parts->shape.vertices = calloc(vertices + 1, sizeof *parts->shape.vertices);
    parts->shape.indices = calloc(indices + 1, sizeof *parts->shape.indices);
    parts->runs = calloc((size_t)scene->mNumMeshes + 1, sizeof *parts->runs);
    if (!parts->shape.vertices || !parts->shape.indices || !parts->runs ||
        !make_extras(scene, attributes, vertices, parts))
        return message_fail(error, room, "out of memory");
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        if (has_triangles(scene->mMeshes[m]))
            add_mesh(scene->mMeshes[m], material_of(scene, scene->mMeshes[m]), attributes, parts);
    return true;
}

/* What assimp says is wrong; a name of C++ says nothing to who wrote the file. */
static const char *said(void)
{
    const char *text = aiGetErrorString();
    return strcmp(text, "std::bad_alloc") ? text : "reading it takes too much memory: it is damaged, or too large";
}

bool model_import(const char *path, ModelParts *parts, char *error, size_t room)
{
    Arena arena = {0};
    ModelAttributes attributes;
    *parts = (ModelParts){0};
    bool done = model_attributes_read(&arena, path, &attributes, error, room);
    struct aiFileIO files = model_open_files();
    const struct aiScene *scene = done ? aiImportFileEx(path, steps, &files) : NULL;
    if (done && !scene)
        done = message_fail(error, room, "%s", said());
    if (scene) {
        done = take(scene, &attributes, parts, error, room);
        aiReleaseImport(scene);
    }
    arena_free(&arena);
    return done;
}
#endif
