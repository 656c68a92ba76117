/* Meshes of files, each read once; a file with materials gives a mesh for each material. */
#include "compiler/hints/hint.h"
#include "runtime/mesh_import/model.h"
#include "runtime/scene_reader/scene_part.h"
#include <stdlib.h>
#include <string.h>

enum { MESSAGE = 1024 };

/* Returns the path that a value names; NULL after an error was reported. */
static const char *path_of(SceneReader *r, const Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return session_path_beside(r->session, r->session->sources[tree->span.file].name,
                                   tree->text);
    diag_add(r->session, tree->span, DIAG_wrong_type, "file", "a file name",
             tree_describe(r->session, tree));
    r->fine = false;
    return NULL;
}

static void add(SceneReader *r, SceneMesh mesh)
{
    size_t count = (size_t)r->scene->mesh_count;
    ARENA_PUSH(r->session->arena, r->scene->meshes, count, r->mesh_capacity, mesh);
    r->scene->mesh_count = (int)count;
}

static bool read_file(SceneReader *r, const ModelSource *source, char *error, size_t capacity)
{
    ModelPart *parts;
    int count;
    if (!model_read_source(source, &parts, &count, error, capacity))
        return false;
    for (int i = 0; i < count; i++)
        add(r,
            (SceneMesh){.path = source->path, .shape = parts[i].shape, .part = parts[i].material});
    free(parts);
    return true;
}

/* Returns the mesh file at a path, read once and cached. */
static SceneMeshFile file_of(SceneReader *r, const char *path, bool parts)
{
    char error[MESSAGE];
    SceneMeshFiles *files = &r->mesh_files[parts];
    const size_t number = (size_t)names_add(r->session->arena, &files->paths, path);
    if (number < files->count)
        return files->at[number];
    SceneMeshFile file = {.first = r->scene->mesh_count};
    session_depend_on(r->session, path);
    const ModelSource source = {path, r->session->options->root, !parts};
    if (!read_file(r, &source, error, sizeof error))
        file.why = arena_string(r->session->arena, error, strlen(error));
    file.count = r->scene->mesh_count - file.first;
    ARENA_PUSH(r->session->arena, files->at, files->count, files->capacity, file);
    return file;
}

static int fail(SceneReader *r, const Tree *tree, const char *error)
{
    if (!hint_backslash(r->session, tree->span))
        diag_add(r->session, tree->span, DIAG_cannot_read, tree->text, error);
    r->fine = false;
    return -1;
}

int scene_mesh_read(SceneReader *r, const Tree *tree)
{
    const char *path = path_of(r, tree);
    if (!path)
        return -1;
    const SceneMeshFile file = file_of(r, path, false);
    return file.why ? fail(r, tree, file.why) : file.first;
}

int scene_mesh_read_parts(SceneReader *r, const Tree *tree, int *first)
{
    const char *path = path_of(r, tree);
    if (!path)
        return -1;
    const SceneMeshFile file = file_of(r, path, true);
    *first = file.first;
    return file.why ? fail(r, tree, file.why) : file.count;
}
