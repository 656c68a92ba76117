#include "runtime/mesh_import/gltf_mesh.h"
#include "compiler/base/root.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/gltf_primitive.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/* A node of the scene, its mesh, and where the mesh is drawn. */
typedef struct {
    const Tree *node, *mesh;
    size_t number; /* of the mesh */
    const GltfTransform *instances;
    size_t instance_count;
} Shown;

/* Reads a primitive in its pose, and draws it at every instance. */
static bool read_primitive(GltfMesh *mesh, const GltfNodes *nodes, const Shown *shown,
                           const Tree *tree)
{
    GltfPrimitive primitive = {0};
    const Tree *weights = gltf_file_value(shown->node, "weights");
    bool done = gltf_primitive_read(mesh, tree, &primitive);
    if (done && primitive.index_count)
        done = gltf_pose_morph(mesh, weights ? weights : gltf_file_value(shown->mesh, "weights"),
                               &primitive) &&
               gltf_pose_skin(mesh, nodes, gltf_file_value(shown->node, "skin"), &primitive);
    for (size_t i = 0; done && primitive.index_count && i < shown->instance_count; i++)
        done = gltf_emit(mesh, &primitive, &shown->instances[i]);
    gltf_primitive_close(mesh, &primitive);
    return done;
}

static bool read_node(GltfMesh *mesh, const GltfNodes *nodes, size_t number, size_t *instances)
{
    const Tree *primitive;
    Shown shown = {.node = gltf_file_item(mesh->root, "nodes", number)};
    shown.number = gltf_file_whole(gltf_file_value(shown.node, "mesh"), SIZE_MAX);
    shown.mesh = gltf_file_item(mesh->root, "meshes", shown.number);
    shown.instances = gltf_nodes_instances(mesh, nodes, number, &shown.instance_count);
    if (!shown.instances)
        return false;
    if (!shown.mesh)
        return gltf_fail(mesh, "/mesh", "the mesh is not there");
    if ((*instances += shown.instance_count) > MODEL_INSTANCES)
        return message_fail(mesh->error, mesh->capacity, "it has more than %d instances of meshes",
                            MODEL_INSTANCES);
    for (size_t i = 0; (primitive = gltf_file_item(shown.mesh, "primitives", i)); i++) {
        snprintf(mesh->where, sizeof mesh->where, "meshes/%zu/primitives/%zu", shown.number, i);
        if (!read_primitive(mesh, nodes, &shown, primitive))
            return false;
    }
    return true;
}

static bool read_scene(GltfMesh *mesh)
{
    GltfNodes nodes;
    size_t instances = 0;
    if (!gltf_nodes_read(mesh, &nodes))
        return false;
    gltf_primitive_names(mesh, mesh->parts->shape.names);
    for (size_t i = 0; i < nodes.shown_count; i++)
        if (!read_node(mesh, &nodes, nodes.shown[i], &instances))
            return false;
    return true;
}

/* Reads a file of at most MODEL_FILE_MIB below the root folder `user`. */
static char *read_file(void *user, const char *path, size_t *size, const char **why)
{
    struct stat info;
    const int descriptor = root_open(user, path, why);
    FILE *file =
        descriptor >= 0 && !fstat(descriptor, &info) && info.st_size <= (off_t)MODEL_FILE_MIB << 20
            ? fdopen(descriptor, "rb")
            : NULL;
    char *text = file ? malloc((size_t)info.st_size + 1) : NULL;
    *why = "the file does not exist or is too large";
    if (text) {
        *size = fread(text, 1, (size_t)info.st_size, file);
        text[*size] = 0;
    }
    if (file)
        fclose(file);
    else if (descriptor >= 0)
        close(descriptor);
    return text;
}

static bool read_in_arenas(const ModelSource *source, GltfMesh *mesh)
{
    GltfFiles files = {0};
    MatcOptions options;
    const char *why;
    matc_options_init(&options);
    options.read_file = read_file;
    options.user = (void *)source->root;
    Session session = session_open(&options, mesh->arena);
    mesh->place = (GltfPlace){&session, &files, source->path};
    mesh->root = gltf_file_root(&mesh->place, &why);
    if (!mesh->root)
        return message_fail(mesh->error, mesh->capacity, "%s",
                            session.diags.count ? session.diags.at[0].message : why);
    return read_scene(mesh);
}

bool gltf_mesh_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity)
{
    Arena arena = {0}, scratch = {0};
    *parts = (ModelParts){0};
    GltfMesh mesh = {
        .arena = &arena, .scratch = &scratch, .parts = parts, .error = error, .capacity = capacity};
    const bool done = read_in_arenas(source, &mesh);
    free(mesh.slots);
    arena_free(&scratch);
    arena_free(&arena);
    return done;
}
