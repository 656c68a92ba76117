/* Assimp's scene as one list of triangles. */
#include "runtime/scene/model_import.h"
#include "runtime/gl/message.h"
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

/* What the meshes have of the extras; those that lack it are white, and have the second texture coordinate 0. */
static bool make_extras(const struct aiScene *scene, size_t vertices, ModelParts *parts)
{
    for (unsigned m = 0; m < scene->mNumMeshes; m++) {
        const struct aiMesh *mesh = scene->mMeshes[m];
        const bool has[SHAPE_EXTRAS] = {mesh->mColors[0] != NULL, mesh->mTextureCoords[1] != NULL};
        for (int i = 0; i < SHAPE_EXTRAS && has_triangles(mesh); i++) {
            if (!has[i] || parts->shape.extra[i])
                continue;
            if (!(parts->shape.extra[i] = calloc(vertices + 1, sizeof *parts->shape.extra[i])))
                return false;
            for (size_t k = 0; i == SHAPE_EXTRA_color && k < 4 * vertices; k++)
                parts->shape.extra[i][k / 4][k % 4] = 1;
        }
    }
    return true;
}

static void put_extras(const struct aiMesh *mesh, unsigned i, Shape *shape)
{
    float(*color)[4] = shape->extra[SHAPE_EXTRA_color], (*uv1)[4] = shape->extra[SHAPE_EXTRA_uv1];
    if (color && mesh->mColors[0])
        memcpy(color[shape->vertex_count], &mesh->mColors[0][i], sizeof *color);
    if (uv1 && mesh->mTextureCoords[1]) {
        uv1[shape->vertex_count][0] = mesh->mTextureCoords[1][i].x;
        uv1[shape->vertex_count][1] = mesh->mTextureCoords[1][i].y;
    }
}

static void add_vertices(const struct aiMesh *mesh, ModelParts *parts)
{
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        put_extras(mesh, i, &parts->shape);
        ShapeVertex *vertex = &parts->shape.vertices[parts->shape.vertex_count++];
        put(vertex->position, &mesh->mVertices[i]);
        if (mesh->mNormals)
            put(vertex->normal, &mesh->mNormals[i]);
        if (mesh->mTextureCoords[0]) {
            vertex->uv[0] = mesh->mTextureCoords[0][i].x;
            vertex->uv[1] = mesh->mTextureCoords[0][i].y;
        }
    }
    parts->has_normals &= mesh->mNormals != NULL;
    parts->has_coordinates &= mesh->mTextureCoords[0] != NULL;
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

static void add_mesh(const struct aiMesh *mesh, int material, ModelParts *parts)
{
    const uint32_t first = (uint32_t)parts->shape.vertex_count;
    const int before = parts->shape.index_count;
    add_vertices(mesh, parts);
    for (unsigned f = 0; f < mesh->mNumFaces; f++)
        for (unsigned k = 0; k < 3 && mesh->mFaces[f].mNumIndices == 3; k++) {
            /* one that is out of range stays so: the parts are checked */
            const unsigned index = mesh->mFaces[f].mIndices[k];
            parts->shape.indices[parts->shape.index_count++] = index < mesh->mNumVertices ? first + index : UINT32_MAX;
        }
    parts->runs[parts->run_count++] = (ModelRun){material, parts->shape.index_count - before};
}

static bool take(const struct aiScene *scene, ModelParts *parts, char *error, size_t room)
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
    if (!parts->shape.vertices || !parts->shape.indices || !parts->runs || !make_extras(scene, vertices, parts))
        return message_fail(error, room, "out of memory");
    for (unsigned m = 0; m < scene->mNumMeshes; m++)
        if (has_triangles(scene->mMeshes[m]))
            add_mesh(scene->mMeshes[m], material_of(scene, scene->mMeshes[m]), parts);
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
    *parts = (ModelParts){0};
    struct aiFileIO files = model_open_files();
    const struct aiScene *scene = aiImportFileEx(path, steps, &files);
    if (!scene)
        return message_fail(error, room, "%s", said());
    bool done = take(scene, parts, error, room);
    aiReleaseImport(scene);
    return done;
}
#endif
