/* Meshes of files, each read once; of a file with materials, a mesh for each of them. */
#include "runtime/scene/model.h"
#include "runtime/scene/scene_part.h"
#include <stdlib.h>
#include <string.h>

enum { MESSAGE = 1024 };

/* The file that a value names; NULL: told. */
static const char *path_of(SceneReader *r, const Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return session_path_beside(r->session, r->session->sources[tree->span.file].name, tree->text);
    diag_add(r->session, tree->span, DIAG_wrong_type, "file", "a file name", tree_describe(r->session, tree));
    r->fine = false;
    return NULL;
}

/* The first mesh of the file: its parts, or the whole. */
static int find(const Scene *scene, const char *path, bool parts)
{
    for (int i = 0; i < scene->mesh_count; i++)
        if (!strcmp(scene->meshes[i].path, path) && (scene->meshes[i].part >= 0) == parts)
            return i;
    return -1;
}

static void add(SceneReader *r, SceneMesh mesh)
{
    size_t count = (size_t)r->scene->mesh_count;
    ARENA_PUSH(r->session->arena, r->scene->meshes, count, r->mesh_room, mesh);
    r->scene->mesh_count = (int)count;
}

static int fail(SceneReader *r, const Tree *tree, const char *error)
{
    diag_add(r->session, tree->span, DIAG_cannot_read, tree->text, error);
    r->fine = false;
    return -1;
}

int scene_mesh_read(SceneReader *r, const Tree *tree)
{
    char error[MESSAGE];
    SceneMesh mesh = {.path = path_of(r, tree), .part = -1};
    if (!mesh.path)
        return -1;
    const int known = find(r->scene, mesh.path, false);
    if (known >= 0)
        return known;
    session_depend_on(r->session, mesh.path);
    if (!model_read_in_place(mesh.path, &mesh.shape, error, sizeof error))
        return fail(r, tree, error);
    add(r, mesh);
    return r->scene->mesh_count - 1;
}

int scene_mesh_read_parts(SceneReader *r, const Tree *tree, int *first)
{
    char error[MESSAGE];
    ModelPart *parts;
    int count;
    const char *path = path_of(r, tree);
    *first = path ? find(r->scene, path, true) : -1;
    for (int i = *first; path && i >= 0; i++)
        if (i == r->scene->mesh_count || strcmp(r->scene->meshes[i].path, path) || r->scene->meshes[i].part < 0)
            return i - *first;
    if (!path)
        return -1;
    session_depend_on(r->session, path);
    if (!model_read_parts(path, &parts, &count, error, sizeof error))
        return fail(r, tree, error);
    *first = r->scene->mesh_count;
    for (int i = 0; i < count; i++)
        add(r, (SceneMesh){.path = path, .shape = parts[i].shape, .part = parts[i].material});
    free(parts);
    return count;
}
