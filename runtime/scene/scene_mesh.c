/* Meshes of files, each read once. */
#include "runtime/scene/model.h"
#include "runtime/scene/scene_part.h"
#include <string.h>

enum { MESSAGE = 1024 };

int scene_mesh_read(SceneReader *r, const Tree *tree)
{
    Scene *scene = r->scene;
    char error[MESSAGE];
    if (tree->kind != TREE_scalar) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "file", "a file name", tree_describe(r->session, tree));
        return r->fine = false, -1;
    }
    SceneMesh mesh = {.path = session_path_beside(r->session, r->session->sources[tree->span.file].name, tree->text)};
    for (int i = 0; i < scene->mesh_count; i++)
        if (!strcmp(scene->meshes[i].path, mesh.path))
            return i;
    session_depend_on(r->session, mesh.path);
    if (!model_read_in_place(mesh.path, &mesh.shape, error, sizeof error)) {
        diag_add(r->session, tree->span, DIAG_cannot_read, tree->text, error);
        return r->fine = false, -1;
    }
    size_t count = (size_t)scene->mesh_count;
    ARENA_PUSH(r->session->arena, scene->meshes, count, r->mesh_room, mesh);
    scene->mesh_count = (int)count;
    return scene->mesh_count - 1;
}
