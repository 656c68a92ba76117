/* Geometry of glTF files: every corner of the read triangles against values written by hand. */
#include "runtime/mesh_import/model.h"
#include "tests/gltf_folder.h"
#include <math.h>

/* A buffer of all data: each accessor is a view of its own. */
enum { MAX_BYTES = 1024, MAX_VIEWS = 16 };
typedef struct {
    unsigned char bytes[MAX_BYTES];
    size_t size;
    char views[2048], accessors[4096];
    int count;
} Data;

#define ACCESSOR(type, component, count)                                                           \
    "\"type\":\"" type "\",\"componentType\":" #component ",\"count\":" #count

/* Appends an accessor, whose values start at a multiple of four bytes; its number is that of the
 * call. `json` has the accessor's other members. */
static void add(Data *data, const void *values, size_t size, const char *json)
{
    const char *comma = data->count++ ? "," : "";
    assert_true(data->size + size <= MAX_BYTES && data->count <= MAX_VIEWS);
    memcpy(data->bytes + data->size, values, size);
    sprintf(data->views + strlen(data->views),
            "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", comma, data->size, size);
    sprintf(data->accessors + strlen(data->accessors), "%s{\"bufferView\":%d,%s}", comma,
            data->count - 1, json);
    data->size = (data->size + size + 3) / 4 * 4;
}

/* Writes the file with a scene's nodes and meshes, and reads it as a whole. Returns whether it was
 * read. */
static bool read_scene(const Data *data, const char *scene, Shape *shape, char error[1024])
{
    char text[16384], path[128];
    write_file("data one.bin", data->bytes, data->size);
    snprintf(text, sizeof text,
             "{\"asset\":{\"version\":\"2.0\"},%s,\"buffers\":[{\"uri\":\"data%%20one.bin\","
             "\"byteLength\":%zu}],\"bufferViews\":[%s],\"accessors\":[%s]}",
             scene, data->size, data->views, data->accessors);
    write_file("a.gltf", text, strlen(text));
    return model_read_in_place(path_of("a.gltf", path), shape, error, 1024);
}

/* Checks the corners' positions, in the file's axes: (x, y, z) of the file is (x, -z, y). */
static void assert_corners(const Shape *shape, const float (*wanted)[3], int count)
{
    assert_int_equal(shape->index_count, count);
    for (int i = 0; i < count; i++) {
        const float *p = shape->vertices[shape->indices[i]].position;
        const float got[3] = {p[0], p[2], -p[1]};
        for (int k = 0; k < 3; k++)
            if (fabsf(got[k] - wanted[i][k]) > 1e-5f)
                fail_msg("corner %d: (%g, %g, %g), not (%g, %g, %g)", i, got[0], got[1], got[2],
                         wanted[i][0], wanted[i][1], wanted[i][2]);
    }
}

static void assert_scene(const Data *data, const char *scene, const float (*wanted)[3], int count)
{
    Shape shape;
    char error[1024] = "";
    if (!read_scene(data, scene, &shape, error))
        fail_msg("%s: %s", scene, error);
    assert_corners(&shape, wanted, count);
    shape_free(&shape);
}

/* A triangle (0), its normals (1), tangents (2) and the indices of two triangles' rows. */
static const float points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
static const float normals[4][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};

static Data quad(void)
{
    Data data = {.count = 0};
    add(&data, points, sizeof points, ACCESSOR("VEC3", 5126, 4));
    add(&data, normals, sizeof normals, ACCESSOR("VEC3", 5126, 4));
    return data;
}

#define ONE_NODE    "\"nodes\":[{\"mesh\":0}],"
#define MESH(parts) "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}" parts "}]}]"

static void modes_make_triangles(void **state)
{
    (void)state;
    Data data = quad();
    static const unsigned char order[] = {0, 1, 2, 3};
    add(&data, order, sizeof order, ACCESSOR("SCALAR", 5121, 4));
    assert_scene(
        &data, ONE_NODE MESH(",\"mode\":5"),
        (const float[][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 6);
    assert_scene(
        &data, ONE_NODE MESH(",\"mode\":5,\"indices\":2"),
        (const float[][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 6);
    assert_scene(
        &data, ONE_NODE MESH(",\"mode\":6"),
        (const float[][3]){{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 0}}, 6);
    assert_scene(&data, ONE_NODE MESH(""), (const float[][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3);
    /* Points beside triangles are left out. */
    assert_scene(&data,
                 ONE_NODE
                 "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":0}"
                 ",{\"attributes\":{\"POSITION\":0}}]}]",
                 (const float[][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3);
}

/* A parent turned by a quarter around z, its child scaled and moved, by TRS and by a matrix; a
 * hidden node; a node of another scene. */
static void nodes_have_places(void **state)
{
    (void)state;
    const Data data = quad();
    static const float wanted[][3] = {{0, 3, 0}, {0, 5, 0}, {-2, 3, 0}};
    assert_scene(
        &data,
        "\"scene\":1,\"scenes\":[{\"nodes\":[2]},{\"nodes\":[0]}],\"nodes\":[{\"rotation\":"
        "[0,0,0.70710678,0.70710678],\"children\":[1,3]},{\"mesh\":0,\"translation\":[3,0,0"
        "],\"scale\":[2,2,2]},{\"mesh\":0},{\"mesh\":0,\"extensions\":{"
        "\"KHR_node_visibility\":{\"visible\":false}}}]," MESH(""),
        wanted, 3);
    assert_scene(&data,
                 "\"nodes\":[{\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0,1],\"children\":[1]},{"
                 "\"mesh\":0,\"matrix\":[2,0,0,0,0,2,0,0,0,0,2,0,3,0,0,1]}]," MESH(""),
                 wanted, 3);
}

/* The triangle's other corners change places, and its normal stays outside. */
static void mirrored_nodes_keep_their_front(void **state)
{
    (void)state;
    const Data data = quad();
    Shape shape;
    char error[1024] = "";
    static const char *const attributes[] = {"", ",\"NORMAL\":1"};
    for (int i = 0; i < 2; i++) {
        char scene[512];
        snprintf(scene, sizeof scene,
                 "\"nodes\":[{\"mesh\":0,\"scale\":[-1,1,1]}],\"meshes\":[{\"primitives\":[{"
                 "\"attributes\":{\"POSITION\":0%s}}]}]",
                 attributes[i]);
        assert_true(read_scene(&data, scene, &shape, error));
        assert_corners(&shape, (const float[][3]){{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, 3);
        for (int k = 0; k < 3; k++)
            assert_true(shape.vertices[k].normal[1] == -1); /* z of the file */
        shape_free(&shape);
    }
}

/* Two faces at a right angle share an edge; without normals each has its own. The primitive beside
 * them keeps its normals, which lean. */
static void missing_normals_are_flat(void **state)
{
    (void)state;
    static const float ridge[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    static const float leaning[4][3] = {{.6f, 0, .8f}, {.6f, 0, .8f}, {.6f, 0, .8f}, {.6f, 0, .8f}};
    static const unsigned char order[] = {0, 1, 2, 0, 3, 1};
    Data data = {.count = 0};
    Shape shape;
    char error[1024] = "";
    add(&data, ridge, sizeof ridge, ACCESSOR("VEC3", 5126, 4));
    add(&data, order, sizeof order, ACCESSOR("SCALAR", 5121, 6));
    add(&data, leaning, sizeof leaning, ACCESSOR("VEC3", 5126, 4));
    assert_true(read_scene(&data,
                           ONE_NODE "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
                                    "\"indices\":1},{\"attributes\":{\"POSITION\":0,\"NORMAL\":2},"
                                    "\"indices\":1}]}]",
                           &shape, error));
    assert_int_equal(shape.index_count, 12);
    for (int i = 0; i < 12; i++) {
        static const float wanted[3][3] = {{0, -1, 0}, {0, 0, -1}, {.6f, -.8f, 0}};
        const float *n = shape.vertices[shape.indices[i]].normal;
        for (int k = 0; k < 3; k++)
            assert_true(fabsf(n[k] - wanted[i / 3 < 2 ? i / 3 : 2][k]) < 1e-6f);
    }
    shape_free(&shape);
}

/* T = (0, 1, 0) and N = (0, 0, 1): the other direction is w (N x T) = -w x. Texture coordinates are
 * twice as long in u, so that dP/du has half the length. */
static void own_tangents_are_the_frame(void **state)
{
    (void)state;
    static const float uv[4][2] = {{0, 1}, {2, 1}, {0, 0}, {2, 0}};
    for (int w = -1; w < 2; w += 2) {
        Data data = quad();
        Shape shape;
        char error[1024] = "";
        const float t[4][4] = {
            {0, 1, 0, (float)w}, {0, 1, 0, (float)w}, {0, 1, 0, (float)w}, {0, 1, 0, (float)w}};
        add(&data, t, sizeof t, ACCESSOR("VEC4", 5126, 4));
        add(&data, uv, sizeof uv, ACCESSOR("VEC2", 5126, 4));
        assert_true(read_scene(&data,
                               ONE_NODE
                               "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":"
                               "0,\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3}}]}]",
                               &shape, error));
        for (int i = 0; i < 3; i++) {
            const float wanted[2][3] = {{0, 0, .5f}, {(float)-w, 0, 0}};
            for (int k = 0; k < 3; k++) {
                assert_true(fabsf(shape.vertices[i].tangentU[k] - wanted[0][k]) < 1e-5f);
                assert_true(fabsf(shape.vertices[i].tangentV[k] - wanted[1][k]) < 1e-5f);
            }
        }
        shape_free(&shape);
    }
}

/* Shorts of a stride are a position, as they are and normalized; unsigned shorts are coordinates.
 * An accessor without a view is 0, where sparse values move one row. */
static void integers_are_decoded(void **state)
{
    (void)state;
    static const int16_t shorts[3][4] = {{-32767, 0, 0}, {32767, 0, 0}, {0, 32767, 0}};
    static const uint16_t uv[3][2] = {{0, 65535}, {65535, 65535}, {0, 0}};
    Data data = {.count = 0};
    Shape shape;
    char error[1024] = "", scene[512];
    memcpy(data.bytes, shorts, sizeof shorts);
    data.size = sizeof shorts;
    data.count = 1;
    strcpy(data.views, "{\"buffer\":0,\"byteLength\":24,\"byteStride\":8}");
    strcpy(data.accessors, "{\"bufferView\":0,\"type\":\"VEC3\",\"componentType\":5122,\"count\":3,"
                           "\"normalized\":true}");
    add(&data, uv, sizeof uv, ACCESSOR("VEC2", 5123, 3) ",\"normalized\":true");
    snprintf(scene, sizeof scene, ONE_NODE "%s",
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1}}]}]");
    assert_true(read_scene(&data, scene, &shape, error));
    assert_corners(&shape, (const float[][3]){{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3);
    assert_true(shape.vertices[0].uv[0] == 0 && shape.vertices[0].uv[1] == 0);
    assert_true(shape.vertices[1].uv[0] == 1 && shape.vertices[2].uv[1] == 1);
    shape_free(&shape);
    strcpy(data.accessors,
           "{\"bufferView\":0,\"type\":\"VEC3\",\"componentType\":5122,\"count\":3}");
    assert_scene(&data, ONE_NODE MESH(""),
                 (const float[][3]){{-32767, 0, 0}, {32767, 0, 0}, {0, 32767, 0}}, 3);
    static const struct {
        unsigned char rows[4];
        float values[2][3];
    } sparse = {{1, 2}, {{3, 0, 0}, {0, 5, 0}}};
    memcpy(data.bytes, &sparse, sizeof sparse);
    data.size = sizeof sparse;
    strcpy(data.views, "{\"buffer\":0,\"byteLength\":28}");
    strcpy(data.accessors, "{\"type\":\"VEC3\",\"componentType\":5126,\"count\":3,\"sparse\":{"
                           "\"count\":2,\"indices\":{\"bufferView\":0,\"componentType\":5121},"
                           "\"values\":{\"bufferView\":0,\"byteOffset\":4}}}");
    assert_scene(&data, ONE_NODE MESH(""), (const float[][3]){{0, 0, 0}, {3, 0, 0}, {0, 5, 0}}, 3);
}

/* Two instances: one moved by (2, 0, 0), one moved by (0, 3, 0) and scaled by 2. */
static void instances_are_drawn(void **state)
{
    (void)state;
    static const float moves[2][3] = {{2, 0, 0}, {0, 3, 0}}, scales[2][3] = {{1, 1, 1}, {2, 2, 2}};
    Data data = quad();
    add(&data, moves, sizeof moves, ACCESSOR("VEC3", 5126, 2));
    add(&data, scales, sizeof scales, ACCESSOR("VEC3", 5126, 2));
    assert_scene(
        &data,
        "\"nodes\":[{\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{"
        "\"attributes\":{\"TRANSLATION\":2,\"SCALE\":3}}}}]," MESH(""),
        (const float[][3]){{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 3, 0}, {2, 3, 0}, {0, 5, 0}}, 6);
}

/* A node's weights (0.5, -1) replace those of its mesh: targets move by (2, 0, 0) and (0, 0, 1). */
static void targets_move_vertices(void **state)
{
    (void)state;
    static const float targets[2][4][3] = {{{2, 0, 0}, {2, 0, 0}, {2, 0, 0}},
                                           {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    Data data = quad();
    add(&data, targets[0], sizeof targets[0], ACCESSOR("VEC3", 5126, 4));
    add(&data, targets[1], sizeof targets[1], ACCESSOR("VEC3", 5126, 4));
#define TARGETS ",\"targets\":[{\"POSITION\":2},{\"POSITION\":3}]"
#define WEIGHED                                                                                    \
    "\"meshes\":[{\"weights\":[0,1],\"primitives\":[{\"attributes\":{\"POSITION\":0}" TARGETS "}]" \
    "}]"
    assert_scene(&data, ONE_NODE WEIGHED, (const float[][3]){{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, 3);
    assert_scene(&data, "\"nodes\":[{\"mesh\":0,\"weights\":[0.5,-1]}]," WEIGHED,
                 (const float[][3]){{1, 0, -1}, {2, 0, -1}, {1, 1, -1}}, 3);
}

/* Joint 0 is moved by (0, 0, 5) and was bound at (1, 0, 0); joint 1 is not moved. Vertex 0 hangs on
 * the first, vertex 1 on the second, vertex 2 on both by halves. The transform of the mesh's own
 * node is ignored. */
static void skins_have_their_pose(void **state)
{
    (void)state;
    static const float binds[2][16] = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1},
                                       {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    static const unsigned char joints[4][4] = {{0}, {1}, {0, 1}, {0}};
    static const float weights[4][4] = {{1}, {1}, {.5f, .5f}, {1}};
    Data data = quad();
    add(&data, binds, sizeof binds, ACCESSOR("MAT4", 5126, 2));
    add(&data, joints, sizeof joints, ACCESSOR("VEC4", 5121, 4));
    add(&data, weights, sizeof weights, ACCESSOR("VEC4", 5126, 4));
    assert_scene(&data,
                 "\"nodes\":[{\"mesh\":0,\"skin\":0,\"translation\":[7,7,7]},{\"translation\":[0,0,"
                 "5]},{}],\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":2}],\"meshes\":[{"
                 "\"primitives\":[{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":3,\"WEIGHTS_0\":4}}]"
                 "}]",
                 (const float[][3]){{-1, 0, 5}, {1, 0, 0}, {-.5f, 1, 2.5f}}, 3);
}

/* The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), compressed by the libraries' own encoders. Without
 * a library the error names the extension. */
static void compressed_data_are_read(void **state)
{
    (void)state;
    static const struct {
        const char *text, *extension;
    } files[] = {
        {"{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
         "\"attributes\":{\"POSITION\":0},\"indices\":1}]}],\"accessors\":[{\"bufferView\":0,"
         "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},{\"bufferView\":1,"
         "\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":1,"
         "\"byteLength\":48,\"byteStride\":16,\"extensions\":{\"EXT_meshopt_compression\":{"
         "\"buffer\":0,\"byteOffset\":0,\"byteLength\":71,\"byteStride\":16,\"count\":3,\"mode\":"
         "\"ATTRIBUTES\"}}},{\"buffer\":1,\"byteOffset\":48,\"byteLength\":6,\"extensions\":{\"EXT_"
         "meshopt_compression\":{\"buffer\":0,\"byteOffset\":71,\"byteLength\":18,\"byteStride\":2,"
         "\"count\":3,\"mode\":\"TRIANGLES\"}}}],\"buffers\":[{\"byteLength\":89,\"uri\":\"data:"
         "application/octet-stream;base64,oAAAATwAAAD//wE8AAAAfn0AAAEMAAAA/"
         "wEMAAAAfgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADg8AB2h1ZneKmGZYlomAFpAAA="
         "\"},{\"byteLength\":54}]}",
         "EXT_meshopt_compression"},
        {"{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
         "\"attributes\":{\"POSITION\":0},\"indices\":1,\"extensions\":{\"KHR_draco_mesh_"
         "compression\":{\"bufferView\":0,\"attributes\":{\"POSITION\":0}}}}]}],\"accessors\":[{"
         "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},{\"componentType\":5123,\"count\":"
         "3,\"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":70}],\"buffers\":[{"
         "\"byteLength\":70,\"uri\":\"data:application/"
         "octet-stream;base64,RFJBQ08CAgEBAAAAAwEAAQAAAQf/AREB/"
         "wAAAQAJAwAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAAAAAA==\"}]}",
         "KHR_draco_mesh_compression"}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[128], error[1024] = "";
        Shape shape;
        write_file("a.gltf", files[i].text, strlen(files[i].text));
        if (model_read_in_place(path_of("a.gltf", path), &shape, error, sizeof error)) {
            assert_corners(&shape, (const float[][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3);
            shape_free(&shape);
        } else if (!strstr(error, files[i].extension) || !strstr(error, "was built without"))
            fail_msg("%s: %s", files[i].extension, error);
    }
}

/* Faults name their place. None of them crashes, or takes long. */
static void faults_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *scene, *reported;
    } cases[] = {
        {"\"nodes\":[{\"children\":[1]},{\"children\":[0],\"mesh\":0}],\"scenes\":[{\"nodes\":[0]}]"
         ","
         "\"meshes\":[]",
         "nodes/0: it is its own ancestor"},
        {"\"nodes\":[{\"children\":[2]},{\"children\":[2]},{}],\"meshes\":[]",
         "nodes/2: it is the child of two nodes"},
        {"\"nodes\":[{\"children\":[1]},{}],\"scenes\":[{\"nodes\":[0,1]}],\"meshes\":[]",
         "nodes/1: it is in its scene twice"},
        {"\"nodes\":[{\"children\":[7]}],\"meshes\":[]", "nodes/0/children: a node is not there"},
        {"\"scene\":3,\"nodes\":[]", "scene: the scene is not there"},
        {"\"nodes\":[{\"mesh\":4}],\"meshes\":[]", "nodes/0/mesh: the mesh is not there"},
        {"\"nodes\":[{\"scale\":[1,2]}],\"meshes\":[]", "nodes/0/scale: it is not a list of 3"},
        {ONE_NODE MESH(",\"mode\":9"), "meshes/0/primitives/0/mode: it is not"},
        {ONE_NODE MESH(",\"material\":0"), "meshes/0/primitives/0/material: the material is not"},
        {ONE_NODE MESH(",\"indices\":0"), "meshes/0/primitives/0/indices: its accessor is not a"},
        {ONE_NODE MESH(",\"indices\":2"), "meshes/0/primitives/0/indices: a vertex is not there"},
        {ONE_NODE MESH(",\"mode\":1"), "it has no triangle"},
        {ONE_NODE "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":2}}]}]",
         "meshes/0/primitives/0/attributes/NORMAL: its accessor's type is not"},
        {"\"nodes\":[{\"mesh\":0,\"skin\":5}],\"meshes\":[{\"primitives\":[{\"attributes\":{"
         "\"POSITION\":0,\"JOINTS_0\":0}}]}]",
         "skins/5/joints: there are none"},
        {ONE_NODE MESH(",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":9}},"
                       "\"mode\":4"),
         ""},
    };
    Data data = quad();
    static const unsigned char order[] = {0, 1, 9};
    add(&data, order, sizeof order, ACCESSOR("SCALAR", 5121, 3));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Shape shape;
        char error[1024] = "";
        const bool done = read_scene(&data, cases[i].scene, &shape, error);
        if (done)
            shape_free(&shape);
        if (done != !*cases[i].reported || !strstr(error, cases[i].reported))
            fail_msg("%zu: '%s', not '%s'", i, error, cases[i].reported);
    }
}

static int make_folder(void **state)
{
    (void)state;
    return !mkdtemp(folder);
}

static int remove_folder(void **state)
{
    (void)state;
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modes_make_triangles),
        cmocka_unit_test(nodes_have_places),
        cmocka_unit_test(mirrored_nodes_keep_their_front),
        cmocka_unit_test(missing_normals_are_flat),
        cmocka_unit_test(own_tangents_are_the_frame),
        cmocka_unit_test(integers_are_decoded),
        cmocka_unit_test(instances_are_drawn),
        cmocka_unit_test(targets_move_vertices),
        cmocka_unit_test(skins_have_their_pose),
        cmocka_unit_test(compressed_data_are_read),
        cmocka_unit_test(faults_are_named),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
