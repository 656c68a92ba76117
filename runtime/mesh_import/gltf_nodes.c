#include "runtime/mesh_import/gltf_nodes.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/gltf_accessor.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

GltfTransform gltf_transform_product(const GltfTransform *a, const GltfTransform *b)
{
    GltfTransform made;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++)
            made.m[r][c] = a->m[r][0] * b->m[0][c] + a->m[r][1] * b->m[1][c] +
                           a->m[r][2] * b->m[2][c] + (c == 3 ? a->m[r][3] : 0);
    return made;
}

/* Translation, rotation by a quaternion (x, y, z, w) of any length, and scale. */
static GltfTransform compose(const double t[3], const double q[4], const double s[3])
{
    const double size = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const double k = size > 0 ? 2 / size : 0, x = q[0], y = q[1], z = q[2], w = q[3];
    const double rotation[3][3] = {
        {1 - k * (y * y + z * z), k * (x * y - z * w), k * (x * z + y * w)},
        {k * (x * y + z * w), 1 - k * (x * x + z * z), k * (y * z - x * w)},
        {k * (x * z - y * w), k * (y * z + x * w), 1 - k * (x * x + y * y)}};
    GltfTransform made;
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++)
            made.m[r][c] = rotation[r][c] * s[c];
        made.m[r][3] = t[r];
    }
    return made;
}

static bool fail_node(GltfMesh *mesh, size_t node, const char *part, const char *why)
{
    snprintf(mesh->where, sizeof mesh->where, "nodes/%zu", node);
    return gltf_fail(mesh, part, why);
}

/* Reads a list of exactly `count` numbers, which is left alone if it is missing. */
static bool read_numbers(const Tree *list, uint32_t count, double *to)
{
    if (!list)
        return true;
    if (list->kind != TREE_list || list->count != count)
        return false;
    for (uint32_t i = 0; i < count; i++)
        if (list->items[i]->kind != TREE_scalar || !list->items[i]->plain ||
            !tree_number(list->items[i], &to[i]))
            return false;
    return true;
}

static bool read_local(GltfMesh *mesh, const Tree *node, size_t number, GltfTransform *local)
{
    double matrix[16], t[3] = {0}, q[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    const Tree *given = gltf_file_value(node, "matrix");
    if (!read_numbers(given, 16, matrix))
        return fail_node(mesh, number, "/matrix", "it is not a list of 16 numbers");
    for (int i = 0; given && i < 12; i++)
        local->m[i / 4][i % 4] = matrix[i % 4 * 4 + i / 4];
    if (given)
        return true;
    if (!read_numbers(gltf_file_value(node, "translation"), 3, t))
        return fail_node(mesh, number, "/translation", "it is not a list of 3 numbers");
    if (!read_numbers(gltf_file_value(node, "rotation"), 4, q))
        return fail_node(mesh, number, "/rotation", "it is not a list of 4 numbers");
    if (!read_numbers(gltf_file_value(node, "scale"), 3, s))
        return fail_node(mesh, number, "/scale", "it is not a list of 3 numbers");
    *local = compose(t, q, s);
    return true;
}

static const Tree *node_at(const GltfMesh *mesh, size_t node)
{
    return gltf_file_item(mesh->root, "nodes", node);
}

static uint32_t child_count(const Tree *node)
{
    const Tree *children = gltf_file_value(node, "children");
    return children && children->kind == TREE_list ? children->count : 0;
}

static size_t child_of(const Tree *node, uint32_t i)
{
    return gltf_file_whole(gltf_file_value(node, "children")->items[i], SIZE_MAX);
}

static bool find_parents(GltfMesh *mesh, GltfNodes *nodes)
{
    for (size_t i = 0; i < nodes->count; i++)
        nodes->parents[i] = SIZE_MAX;
    for (size_t i = 0; i < nodes->count; i++) {
        const Tree *node = node_at(mesh, i);
        for (uint32_t k = 0; k < child_count(node); k++) {
            const size_t child = child_of(node, k);
            if (child >= nodes->count)
                return fail_node(mesh, i, "/children", "a node is not there");
            if (nodes->parents[child] != SIZE_MAX)
                return fail_node(mesh, child, "", "it is the child of two nodes");
            nodes->parents[child] = i;
        }
    }
    return true;
}

/* Computes world transforms from the nodes without parents downwards, with an explicit stack. A
 * node is pushed once, as it has one parent. */
static bool find_worlds(GltfMesh *mesh, GltfNodes *nodes, size_t *stack)
{
    size_t count = 0;
    for (size_t i = 0; i < nodes->count; i++)
        if (nodes->parents[i] == SIZE_MAX)
            stack[count++] = i;
    while (count) {
        const size_t i = stack[--count], parent = nodes->parents[i];
        const Tree *node = node_at(mesh, i);
        GltfTransform local;
        if (!read_local(mesh, node, i, &local))
            return false;
        nodes->world[i] =
            parent == SIZE_MAX ? local : gltf_transform_product(&nodes->world[parent], &local);
        nodes->reached[i] = true;
        for (uint32_t k = 0; k < child_count(node); k++)
            stack[count++] = child_of(node, k);
    }
    return true;
}

static const Tree *extension_of(const Tree *node, const char *name)
{
    return gltf_file_value(gltf_file_value(node, "extensions"), name);
}

static bool is_visible(const Tree *node)
{
    const Tree *visible = gltf_file_value(extension_of(node, "KHR_node_visibility"), "visible");
    return !visible || visible->kind != TREE_scalar || strcmp(visible->text, "false") != 0;
}

/* Pushes the scene's nodes, the last first: of the default scene, else of the first, else all nodes
 * without parents. */
static bool push_roots(GltfMesh *mesh, const GltfNodes *nodes, size_t *stack, size_t *count)
{
    const Tree *index = gltf_file_value(mesh->root, "scene");
    const Tree *scene = gltf_file_item(mesh->root, "scenes", gltf_file_whole(index, 0));
    const Tree *roots = gltf_file_value(scene, "nodes");
    if (index && !scene)
        return gltf_fail(mesh, "scene", "the scene is not there");
    for (size_t i = nodes->count; !scene && i--;)
        if (nodes->parents[i] == SIZE_MAX)
            stack[(*count)++] = i;
    for (uint32_t i = roots && roots->kind == TREE_list ? roots->count : 0; i--;) {
        const size_t node = gltf_file_whole(roots->items[i], SIZE_MAX);
        if (node >= nodes->count || *count == nodes->count)
            return gltf_fail(mesh, "scene", "a node is not there, or there twice");
        if (!nodes->reached[node])
            return fail_node(mesh, node, "", "it is its own ancestor");
        stack[(*count)++] = node;
    }
    return true;
}

/* Lists the visible nodes with meshes. A node that is seen twice, as a root of the scene and as a
 * child, is an error. */
static bool find_shown(GltfMesh *mesh, GltfNodes *nodes, size_t *stack)
{
    size_t count = 0;
    bool *seen = ARENA_ARRAY(mesh->arena, bool, nodes->count + 1);
    if (!push_roots(mesh, nodes, stack, &count))
        return false;
    while (count) {
        const size_t i = stack[--count];
        const Tree *node = node_at(mesh, i);
        if (seen[i])
            return fail_node(mesh, i, "", "it is in its scene twice");
        seen[i] = true;
        if (!is_visible(node))
            continue;
        if (gltf_file_value(node, "mesh"))
            nodes->shown[nodes->shown_count++] = i;
        for (uint32_t k = child_count(node); k--;)
            stack[count++] = child_of(node, k);
    }
    return true;
}

bool gltf_nodes_read(GltfMesh *mesh, GltfNodes *made)
{
    const Tree *list = gltf_file_value(mesh->root, "nodes");
    *made = (GltfNodes){.count = list && list->kind == TREE_list ? list->count : 0};
    if (made->count > MODEL_NODES)
        return message_fail(mesh->error, mesh->capacity, "it has %zu nodes; at most %d are read",
                            made->count, MODEL_NODES);
    made->world = ARENA_ARRAY(mesh->arena, GltfTransform, made->count + 1);
    made->parents = ARENA_ARRAY(mesh->arena, size_t, made->count + 1);
    made->reached = ARENA_ARRAY(mesh->arena, bool, made->count + 1);
    made->shown = ARENA_ARRAY(mesh->arena, size_t, made->count + 1);
    /* Roots of the scene may be children of others too: twice the nodes at most. */
    size_t *stack = ARENA_ARRAY(mesh->arena, size_t, 2 * made->count + 1);
    return find_parents(mesh, made) && find_worlds(mesh, made, stack) &&
           find_shown(mesh, made, stack);
}

/* Reads an attribute of all instances. *count is 0 before the first. */
static float *read_instances(GltfMesh *mesh, const Tree *attributes, const char *name, int wide,
                             size_t *count)
{
    GltfAccessor a;
    const Tree *index = gltf_file_value(attributes, name);
    const char *why = gltf_accessor_open(mesh, index, &a);
    char part[GLTF_MESH_PLACE];
    if (!why && (a.components != wide || (*count && a.count != *count)))
        why = "its type or its count is not that of instances";
    if (!why && a.count > MODEL_INSTANCES)
        why = "more instances than are drawn";
    float *made = why ? NULL : arena_alloc(mesh->arena, a.count * (size_t)wide * sizeof *made);
    if (!why)
        why = gltf_accessor_numbers(mesh, &a, (GltfRows){.count = a.count}, wide, made);
    if (!why)
        return *count = a.count, made;
    snprintf(part, sizeof part, "/extensions/EXT_mesh_gpu_instancing/attributes/%s", name);
    gltf_fail(mesh, part, why);
    return NULL;
}

const GltfTransform *gltf_nodes_instances(GltfMesh *mesh, const GltfNodes *nodes, size_t node,
                                          size_t *count)
{
    static const struct {
        const char *name;
        int wide;
    } parts[] = {{"TRANSLATION", 3}, {"ROTATION", 4}, {"SCALE", 3}};
    const Tree *attributes =
        gltf_file_value(extension_of(node_at(mesh, node), "EXT_mesh_gpu_instancing"), "attributes");
    float *values[3] = {NULL};
    *count = 0;
    snprintf(mesh->where, sizeof mesh->where, "nodes/%zu", node);
    for (int i = 0; i < 3; i++)
        if (gltf_file_value(attributes, parts[i].name) &&
            !(values[i] = read_instances(mesh, attributes, parts[i].name, parts[i].wide, count)))
            return NULL;
    if (!*count)
        return *count = 1, &nodes->world[node];
    GltfTransform *made = ARENA_ARRAY(mesh->arena, GltfTransform, *count);
    for (size_t i = 0; i < *count; i++) {
        double all[3][4] = {{0}, {0, 0, 0, 1}, {1, 1, 1}};
        for (int p = 0; p < 3; p++)
            for (int k = 0; values[p] && k < parts[p].wide; k++)
                all[p][k] = (double)values[p][i * (size_t)parts[p].wide + (size_t)k];
        const GltfTransform local = compose(all[0], all[1], all[2]);
        made[i] = gltf_transform_product(&nodes->world[node], &local);
    }
    return made;
}
