#include "runtime/mesh_import/gltf_primitive.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS, LINES, LINE_LOOP, LINE_STRIP, TRIANGLES, STRIP, FAN, MODES, FIRST_SET = 2 };

static const char draco_name[] = "KHR_draco_mesh_compression";

/* -- names of attributes */

/* Adds a name, unless it is there or there is no space. Returns its index; SHAPE_NAMED: no space.
 */
static int add_name(ShapeNames names, const char *name)
{
    int i = 0;
    while (i < SHAPE_NAMED && names[i][0] && strcmp(names[i], name) != 0)
        i++;
    if (i < SHAPE_NAMED && !names[i][0])
        snprintf(names[i], SHAPE_NAME, "%s", name);
    return i;
}

/* Converts "_WETNESS" to "wetness". Returns false for an attribute that is not the author's, or
 * whose name is too long for a formula. */
static bool own_name(const Member *member, char name[SHAPE_NAME])
{
    if (member->key[0] != '_' || !member->key[1] || member->size >= SHAPE_NAME)
        return false;
    size_t i = 0;
    for (; member->key[i + 1]; i++)
        name[i] = (char)(member->key[i + 1] >= 'A' && member->key[i + 1] <= 'Z'
                             ? member->key[i + 1] - 'A' + 'a'
                             : member->key[i + 1]);
    name[i] = 0;
    return true;
}

/* Converts "TEXCOORD_2" and further sets to "uv2". */
static bool set_name(const Member *member, char name[SHAPE_NAME])
{
    static const char start[] = "TEXCOORD_";
    const char *number = member->key + sizeof start - 1;
    if (strncmp(member->key, start, sizeof start - 1) != 0 || strlen(number) != 1 ||
        *number < '0' + FIRST_SET || *number > '9')
        return false;
    snprintf(name, SHAPE_NAME, "uv%s", number);
    return true;
}

typedef bool NameOf(const Member *member, char name[SHAPE_NAME]);

static void add_names(const Tree *attributes, NameOf *name_of, ShapeNames names)
{
    char name[SHAPE_NAME];
    const uint32_t count = attributes && attributes->kind == TREE_object ? attributes->count : 0;
    for (uint32_t i = 0; i < count; i++)
        if (name_of(&attributes->members[i], name))
            add_name(names, name);
}

void gltf_primitive_names(const GltfMesh *mesh, ShapeNames names)
{
    static NameOf *const kinds[] = {own_name, set_name};
    for (int kind = 0; kind < 2; kind++) {
        const Tree *item, *primitive;
        for (size_t m = 0; (item = gltf_file_item(mesh->root, "meshes", m)); m++)
            for (size_t p = 0; (primitive = gltf_file_item(item, "primitives", p)); p++)
                add_names(gltf_file_value(primitive, "attributes"), kinds[kind], names);
    }
}

/* -- attributes */

/* Replaces an accessor's values by those that Draco decoded. */
static const char *open_draco(GltfMesh *mesh, const GltfPrimitive *primitive, const char *name,
                              GltfAccessor *a)
{
    const Tree *extension =
        gltf_file_value(gltf_file_value(primitive->tree, "extensions"), draco_name);
    const Tree *id = gltf_file_value(gltf_file_value(extension, "attributes"), name);
    if (!id)
        return NULL;
    const size_t values = a->count * (size_t)a->components;
    if (values > MODEL_VALUES - mesh->values)
        return "its accessors have more numbers than are read";
    float *to = arena_alloc(mesh->scratch, values * sizeof *to);
    if (a->count != gltf_draco_points(primitive->draco) ||
        !gltf_draco_numbers(primitive->draco, (uint32_t)gltf_file_whole(id, UINT32_MAX),
                            a->components, a->normalized, to))
        return "its data compressed by KHR_draco_mesh_compression are of another type or count";
    *a = (GltfAccessor){.at = (const unsigned char *)to,
                        .stride = (size_t)a->components * sizeof *to,
                        .count = a->count,
                        .components = a->components,
                        .component = GLTF_FLOAT};
    return NULL;
}

static const char *open_attribute(GltfMesh *mesh, const GltfPrimitive *primitive,
                                  const GltfAttribute *attribute, GltfAccessor *a)
{
    const char *why =
        gltf_accessor_open(mesh, gltf_file_value(attribute->attributes, attribute->name), a);
    if (why)
        return why;
    if (a->component == GLTF_UNSIGNED_INT)
        return "its accessor's componentType is not byte, short or float (5120 to 5123, 5126)";
    if (a->components < attribute->low || a->components > attribute->high)
        return "its accessor's type is not that of the attribute";
    if (a->count != primitive->row_count)
        return "its accessor has another count than that of POSITION";
    return primitive->draco && attribute->attributes == primitive->attributes
               ? open_draco(mesh, primitive, attribute->name, a)
               : NULL;
}

static bool fail_attribute(const GltfMesh *mesh, const char *name, const char *why)
{
    char part[GLTF_MESH_PLACE];
    snprintf(part, sizeof part, "/attributes/%.*s", SHAPE_NAME, name);
    return gltf_fail(mesh, part, why);
}

float *gltf_primitive_attribute(GltfMesh *mesh, const GltfPrimitive *primitive,
                                const GltfAttribute *attribute)
{
    GltfAccessor a;
    const char *why = open_attribute(mesh, primitive, attribute, &a);
    float *made = why ? NULL
                      : arena_alloc(mesh->scratch,
                                    primitive->rows.count * (size_t)attribute->wide * sizeof *made);
    if (!why)
        why = gltf_accessor_numbers(mesh, &a, primitive->rows, attribute->wide, made);
    if (!why)
        return made;
    fail_attribute(mesh, attribute->name, why);
    return NULL;
}

/* Reads an attribute, if the primitive has it. */
static bool read_optional(GltfMesh *mesh, const GltfPrimitive *primitive, GltfAttribute attribute,
                          float **made)
{
    attribute.attributes = primitive->attributes;
    if (!gltf_file_value(primitive->attributes, attribute.name))
        return true;
    return (*made = gltf_primitive_attribute(mesh, primitive, &attribute)) != NULL;
}

/* Turns texture coordinates, whose v runs downwards in glTF. */
static void turn_coordinates(float *values, size_t count, size_t wide)
{
    for (size_t i = 0; values && i < count; i++)
        values[i * wide + 1] = 1 - values[i * wide + 1];
}

/* Reads an attribute that formulas reach by its name. */
static bool read_named(GltfMesh *mesh, GltfPrimitive *primitive, const Member *member)
{
    char name[SHAPE_NAME];
    float *values = NULL;
    const bool set = set_name(member, name);
    if (!set && !own_name(member, name))
        return true;
    const int place = add_name(mesh->parts->shape.names, name);
    if (place == SHAPE_NAMED || (set && primitive->extra[SHAPE_EXTRA_named + place]))
        return true;
    if (primitive->extra[SHAPE_EXTRA_named + place])
        return fail_attribute(mesh, member->key, "two names that differ in capitals alone");
    if (!read_optional(mesh, primitive, (GltfAttribute){NULL, member->key, 1, 4, 4}, &values))
        return false;
    if (set)
        turn_coordinates(values, primitive->rows.count, 4);
    primitive->extra[SHAPE_EXTRA_named + place] = (float(*)[4])values;
    return true;
}

static bool read_attributes(GltfMesh *mesh, GltfPrimitive *p)
{
    float *positions = NULL, *normals = NULL, *tangents = NULL, *uv = NULL, *uv1 = NULL,
          *color = NULL;
    if (!read_optional(mesh, p, (GltfAttribute){NULL, "POSITION", 3, 3, 3}, &positions) ||
        !read_optional(mesh, p, (GltfAttribute){NULL, "NORMAL", 3, 3, 3}, &normals) ||
        !read_optional(mesh, p, (GltfAttribute){NULL, "TANGENT", 4, 4, 4}, &tangents) ||
        !read_optional(mesh, p, (GltfAttribute){NULL, "TEXCOORD_0", 2, 2, 2}, &uv) ||
        !read_optional(mesh, p, (GltfAttribute){NULL, "TEXCOORD_1", 2, 2, 4}, &uv1) ||
        !read_optional(mesh, p, (GltfAttribute){NULL, "COLOR_0", 3, 4, 4}, &color))
        return false;
    for (size_t i = 0; uv1 && i < p->rows.count; i++)
        uv1[i * 4 + 3] = 0;
    turn_coordinates(uv, p->rows.count, 2);
    turn_coordinates(uv1, p->rows.count, 4);
    p->positions = (float(*)[3])positions;
    p->normals = (float(*)[3])normals;
    p->tangents = normals ? (float(*)[4])tangents : NULL; /* glTF 2.0, section 3.7.2.1 */
    p->uv = (float(*)[2])uv;
    p->extra[SHAPE_EXTRA_uv1] = (float(*)[4])uv1;
    p->extra[SHAPE_EXTRA_color] = (float(*)[4])color;
    for (uint32_t i = 0; i < p->attributes->count; i++)
        if (!read_named(mesh, p, &p->attributes->members[i]))
            return false;
    return true;
}

/* -- triangles */

/* Decodes the primitive's Draco data. A file that offers other data too is read without the
 * library. */
static bool open_compressed(GltfMesh *mesh, GltfPrimitive *p)
{
    GltfBytes bytes;
    const char *why = NULL;
    const Tree *extension = gltf_file_value(gltf_file_value(p->tree, "extensions"), draco_name);
    const Tree *position = gltf_file_item(
        mesh->root, "accessors", gltf_file_whole(gltf_file_value(p->attributes, "POSITION"), 0));
    if (!extension)
        return true;
    if (gltf_file_view(&mesh->place, gltf_file_value(extension, "bufferView"), &bytes, &why))
        p->draco = gltf_draco_open(bytes.at, bytes.size, &why);
    return p->draco || gltf_file_value(position, "bufferView") || gltf_fail(mesh, "", why);
}

/* Returns the primitive's indices of rows, or all rows in order. */
static uint32_t *read_rows(GltfMesh *mesh, const GltfPrimitive *p, size_t *count)
{
    const char *why = "it has more triangles than are drawn";
    const Tree *index = gltf_file_value(p->tree, "indices");
    if (index && !p->draco) {
        uint32_t *made = gltf_accessor_indices(mesh, index, count, &why);
        if (!made)
            gltf_fail(mesh, "/indices", why);
        return made;
    }
    *count = p->draco ? gltf_draco_indices(p->draco, NULL) : p->row_count;
    if (*count > MODEL_INDICES)
        return gltf_fail(mesh, "", why), NULL;
    uint32_t *made = arena_alloc(mesh->scratch, *count * sizeof *made + 1);
    if (p->draco)
        gltf_draco_indices(p->draco, made);
    for (size_t i = 0; !p->draco && i < *count; i++)
        made[i] = (uint32_t)i;
    return made;
}

/* Turns a strip or a fan into separate triangles (glTF 2.0, section 3.7.2.1):
 *     strip 0 1 2 3      0 1 2  1 3 2
 *     fan   0 1 2 3      1 2 0  2 3 0 */
static uint32_t *separate(GltfMesh *mesh, int mode, const uint32_t *rows, size_t *count)
{
    const size_t triangles = *count < 3 ? 0 : *count - 2;
    uint32_t *made = arena_alloc(mesh->scratch, triangles * 3 * sizeof *made + 1);
    size_t made_count = 0;
    for (size_t i = 0; i < triangles; i++) {
        const size_t odd = mode == STRIP ? i % 2 : 0;
        const uint32_t corner[3] = {rows[mode == FAN ? i + 1 : i],
                                    rows[mode == FAN ? i + 2 : i + 1 + odd],
                                    rows[mode == FAN ? 0 : i + 2 - odd]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            continue;
        memcpy(made + made_count, corner, sizeof corner);
        made_count += 3;
    }
    *count = made_count;
    return made;
}

/* Ensures that there is a slot for each row. */
static void reserve_slots(GltfMesh *mesh, size_t rows)
{
    if (rows <= mesh->slot_count)
        return;
    free(mesh->slots);
    mesh->slots = memory_checked(calloc(rows, sizeof *mesh->slots));
    mesh->slot_count = rows;
}

/* Numbers the used rows in the order of first use, and turns indices of rows into indices of
 * vertices. */
static bool number_vertices(GltfMesh *mesh, GltfPrimitive *p)
{
    const size_t most = p->index_count < p->row_count ? p->index_count : p->row_count;
    uint32_t *rows = arena_alloc(mesh->scratch, most * sizeof *rows + 1);
    size_t count = 0;
    bool fits = true;
    reserve_slots(mesh, p->row_count);
    for (size_t i = 0; fits && i < p->index_count; i++) {
        const uint32_t row = p->indices[i];
        fits = row < p->row_count;
        if (!fits)
            break;
        if (!mesh->slots[row]) {
            rows[count++] = row;
            mesh->slots[row] = (uint32_t)count;
        }
        p->indices[i] = mesh->slots[row] - 1;
    }
    p->rows = (GltfRows){rows, mesh->slots, count};
    return fits || gltf_fail(mesh, "/indices", "a vertex is not there");
}

static bool read_triangles(GltfMesh *mesh, GltfPrimitive *p)
{
    const size_t mode = gltf_file_whole(gltf_file_value(p->tree, "mode"), TRIANGLES);
    size_t count = 0;
    if (mode >= MODES)
        return gltf_fail(mesh, "/mode", "it is not a number from 0 to 6");
    if (mode < TRIANGLES)
        return true;
    uint32_t *rows = read_rows(mesh, p, &count);
    if (!rows)
        return false;
    if (!p->draco && mode != TRIANGLES)
        rows = separate(mesh, (int)mode, rows, &count);
    p->indices = rows;
    p->index_count = count - count % 3;
    return p->index_count <= (size_t)(MODEL_INDICES - mesh->parts->shape.index_count) ||
           message_fail(mesh->error, mesh->capacity, "it has more than %d triangles",
                        MODEL_INDICES / 3);
}

/* The attribute that a message names: the author's first, else POSITION. */
static const char *blamed(const Tree *attributes)
{
    for (uint32_t i = 0; attributes && attributes->kind == TREE_object && i < attributes->count;
         i++)
        if (attributes->members[i].key[0] == '_')
            return attributes->members[i].key;
    return "POSITION";
}

static bool find_rows(GltfMesh *mesh, GltfPrimitive *p)
{
    const Tree *index = gltf_file_value(p->attributes, "POSITION");
    const Tree *position =
        gltf_file_item(mesh->root, "accessors", gltf_file_whole(index, SIZE_MAX));
    p->row_count = gltf_file_whole(gltf_file_value(position, "count"), 0);
    if (!p->row_count)
        return fail_attribute(mesh, blamed(p->attributes), "its primitive has no POSITION");
    return p->row_count <= MODEL_INDICES ||
           fail_attribute(mesh, blamed(p->attributes), "more vertices than are drawn");
}

bool gltf_primitive_read(GltfMesh *mesh, const Tree *tree, GltfPrimitive *made)
{
    const size_t material = gltf_file_whole(gltf_file_value(tree, "material"), MODEL_NO_MATERIAL);
    *made = (GltfPrimitive){.tree = tree, .attributes = gltf_file_value(tree, "attributes")};
    if (!gltf_file_item(mesh->root, "materials", material) && material != MODEL_NO_MATERIAL)
        return gltf_fail(mesh, "/material", "the material is not there");
    made->material = (int)material;
    return find_rows(mesh, made) && open_compressed(mesh, made) && read_triangles(mesh, made) &&
           (!made->index_count || (number_vertices(mesh, made) && read_attributes(mesh, made)));
}

void gltf_primitive_close(GltfMesh *mesh, GltfPrimitive *primitive)
{
    for (size_t i = 0; i < primitive->rows.count; i++)
        mesh->slots[primitive->rows.rows[i]] = 0;
    gltf_draco_close(primitive->draco);
    *primitive = (GltfPrimitive){0};
    arena_reset(mesh->scratch);
}
