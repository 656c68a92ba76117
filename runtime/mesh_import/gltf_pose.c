/* Morph targets by their stored weights, and skins in their stored pose. */
#include "runtime/mesh_import/gltf_primitive.h"
#include <stdio.h>
#include <string.h>

/* -- morph targets */

static void add_scaled(float *to, const float *delta, size_t count, const int wide[2], float by)
{
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < wide[1]; k++)
            to[i * (size_t)wide[0] + (size_t)k] += by * delta[i * (size_t)wide[1] + (size_t)k];
}

/* Adds one attribute's displacements. Texture coordinates were turned, and so are theirs. */
static bool add_target(GltfMesh *mesh, GltfPrimitive *p, const Tree *target, float weight)
{
    float(*uv1)[4] = p->extra[SHAPE_EXTRA_uv1], (*color)[4] = p->extra[SHAPE_EXTRA_color];
    const struct {
        const char *name;
        float *to;
        int low, high, wide[2]; /* numbers of a vertex: in the primitive, in the target */
    } rows[] = {{"POSITION", (float *)p->positions, 3, 3, {3, 3}},
                {"NORMAL", (float *)p->normals, 3, 3, {3, 3}},
                {"TANGENT", (float *)p->tangents, 3, 3, {4, 3}},
                {"TEXCOORD_0", (float *)p->uv, 2, 2, {2, 2}},
                {"TEXCOORD_1", (float *)uv1, 2, 2, {4, 2}},
                {"COLOR_0", (float *)color, 3, 4, {4, 3}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!rows[i].to || !gltf_file_value(target, rows[i].name))
            continue;
        float *delta = gltf_primitive_attribute(
            mesh, p,
            &(GltfAttribute){target, rows[i].name, rows[i].low, rows[i].high, rows[i].wide[1]});
        if (!delta)
            return false;
        for (size_t v = 0; rows[i].wide[1] == 2 && v < p->rows.count; v++)
            delta[2 * v + 1] = -delta[2 * v + 1];
        add_scaled(rows[i].to, delta, p->rows.count, rows[i].wide, weight);
    }
    return true;
}

bool gltf_pose_morph(GltfMesh *mesh, const Tree *weights, GltfPrimitive *p)
{
    const Tree *target;
    if (!weights || weights->kind != TREE_list)
        return true;
    for (size_t i = 0; (target = gltf_file_item(p->tree, "targets", i)); i++) {
        double weight = 0;
        if (i >= weights->count)
            break;
        const Tree *number = weights->items[i];
        if (number->kind != TREE_scalar || !tree_number(number, &weight))
            return gltf_fail(mesh, "/targets", "a weight is not a number");
        if (weight != 0 && !add_target(mesh, p, target, (float)weight))
            return false;
    }
    return true;
}

/* -- skins */

/* Transforms of a skin's joints, from the mesh's space at binding to the world. */
typedef struct {
    GltfTransform *at;
    size_t count;
} Joints;

static bool fail_skin(GltfMesh *mesh, const Tree *skin, const char *part, const char *why)
{
    snprintf(mesh->where, sizeof mesh->where, "skins/%zu", gltf_file_whole(skin, 0));
    return gltf_fail(mesh, part, why);
}

/* Reads the inverse bind matrices, stored by columns; they are optional. */
static bool read_binds(GltfMesh *mesh, const Tree *skin, const Tree *index, Joints *joints)
{
    GltfAccessor a;
    float(*values)[GLTF_MATRIX] = arena_alloc(mesh->scratch, joints->count * sizeof *values);
    const char *why = gltf_accessor_open(mesh, index, &a);
    if (!why && (a.components != GLTF_MATRIX || a.count < joints->count))
        why = "its accessor is not a MAT4 for each joint";
    if (!why)
        why = gltf_accessor_numbers(mesh, &a, (GltfRows){.count = joints->count}, GLTF_MATRIX,
                                    values[0]);
    if (why)
        return fail_skin(mesh, skin, "/inverseBindMatrices", why);
    for (size_t i = 0; i < joints->count; i++) {
        GltfTransform bind;
        for (int k = 0; k < 12; k++)
            bind.m[k / 4][k % 4] = (double)values[i][k % 4 * 4 + k / 4];
        joints->at[i] = gltf_transform_product(&joints->at[i], &bind);
    }
    return true;
}

static bool read_joints(GltfMesh *mesh, const GltfNodes *nodes, const Tree *index, Joints *made)
{
    const Tree *skin = gltf_file_item(mesh->root, "skins", gltf_file_whole(index, SIZE_MAX));
    const Tree *list = gltf_file_value(skin, "joints");
    const Tree *binds = gltf_file_value(skin, "inverseBindMatrices");
    if (!list || list->kind != TREE_list || !list->count)
        return fail_skin(mesh, index, "/joints", "there are none");
    made->count = list->count;
    made->at = arena_alloc(mesh->scratch, made->count * sizeof *made->at);
    for (size_t i = 0; i < made->count; i++) {
        const size_t node = gltf_file_whole(list->items[i], SIZE_MAX);
        if (node >= nodes->count || !nodes->reached[node])
            return fail_skin(mesh, index, "/joints", "a node is not there");
        made->at[i] = nodes->world[node];
    }
    return !binds || read_binds(mesh, index, binds, made);
}

/* Adds the joints of one set to all vertices; `sums` are the sums of weights. */
static bool add_set(GltfMesh *mesh, GltfPrimitive *p, int set, const Joints *joints, float *sums)
{
    char names[2][32];
    snprintf(names[0], sizeof names[0], "JOINTS_%d", set);
    snprintf(names[1], sizeof names[1], "WEIGHTS_%d", set);
    const float *numbers =
        gltf_primitive_attribute(mesh, p, &(GltfAttribute){p->attributes, names[0], 4, 4, 4});
    const float *weights =
        numbers
            ? gltf_primitive_attribute(mesh, p, &(GltfAttribute){p->attributes, names[1], 4, 4, 4})
            : NULL;
    if (!weights)
        return false;
    for (size_t i = 0; i < p->rows.count * 4; i++) {
        if (!(weights[i] > 0))
            continue;
        if (!(numbers[i] >= 0 && numbers[i] < (float)joints->count))
            return gltf_fail(mesh, "/attributes/JOINTS", "a joint is not in the skin");
        const GltfTransform *joint = &joints->at[(size_t)numbers[i]];
        for (int k = 0; k < 12; k++)
            p->skin[i / 4].m[k / 4][k % 4] += (double)weights[i] * joint->m[k / 4][k % 4];
        sums[i / 4] += weights[i];
    }
    return true;
}

/* Divides the sums by the weights. A vertex without weights stays where it is. */
static void divide_sums(GltfPrimitive *p, const float *sums)
{
    static const GltfTransform unmoved = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    for (size_t i = 0; i < p->rows.count; i++)
        if (!(sums[i] > 0))
            p->skin[i] = unmoved;
        else
            for (int k = 0; k < 12; k++)
                p->skin[i].m[k / 4][k % 4] /= (double)sums[i];
}

bool gltf_pose_skin(GltfMesh *mesh, const GltfNodes *nodes, const Tree *skin, GltfPrimitive *p)
{
    Joints joints = {0};
    char name[32] = "JOINTS_0";
    if (!skin || !gltf_file_value(p->attributes, name))
        return true;
    char where[GLTF_MESH_PLACE];
    memcpy(where, mesh->where, sizeof where);
    if (!read_joints(mesh, nodes, skin, &joints))
        return false;
    memcpy(mesh->where, where, sizeof where);
    p->skin = arena_zero(mesh->scratch, p->rows.count * sizeof *p->skin);
    float *sums = arena_zero(mesh->scratch, p->rows.count * sizeof *sums);
    for (int set = 0; gltf_file_value(p->attributes, name);
         snprintf(name, sizeof name, "JOINTS_%d", ++set))
        if (!add_set(mesh, p, set, &joints, sums))
            return false;
    divide_sums(p, sums);
    return true;
}
