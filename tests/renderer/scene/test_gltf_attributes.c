/* Author-named attributes of glTF meshes: each vertex has the file's value for its position,
 * whatever assimp joins, copies or leaves out; all component types by hand; invalid or hostile
 * files. */
#include "tests/gltf_folder.h"
#include "runtime/mesh_import/model.h"

/* Rows of a place and of numbers that are a function of it, (x + 10 z, x z, x - z, 7); the last two
 * rows are in one place, with different numbers; no triangle has row 4. */
enum { ROWS = 7 };
typedef struct {
    float position[3], numbers[4];
} Row;
static const Row rows[ROWS] = {
    {{0, 0, 0}, {0, 0, 0, 7}},   {{1, 0, 0}, {1, 0, 1, 7}},   {{0, 0, 1}, {10, 0, -1, 7}},
    {{1, 0, 1}, {11, 1, 0, 7}},  {{9, 0, 9}, {99, 81, 0, 7}}, {{3, 0, 1}, {100, 1, 1, 1}},
    {{3, 0, 1}, {200, 2, 2, 2}},
};
static const uint16_t indices[] = {3, 1, 0, 0, 2, 3, 3, 5, 1, 1, 6, 3};
static unsigned char buffer[sizeof rows + sizeof indices + 64];

#define POSITION                                                                                   \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":7,\"type\":\"VEC3\",\"min\":[0,0,0],"      \
    "\"max\":[9,0,9]}"
#define INDICES "{\"bufferView\":1,\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"}"
#define NUMBERS                                                                                    \
    "{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,\"count\":7,\"type\":\"VEC4\"}"
#define NUMBER                                                                                     \
    "{\"bufferView\":0,\"byteOffset\":16,\"componentType\":5126,\"count\":7,\"type\":\"SCALAR\"}"
#define VIEWS                                                                                      \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":196,\"byteStride\":28},{\"buffer\":0,"          \
    "\"byteOffset\":196,"                                                                          \
    "\"byteLength\":24}]"
/* Two nodes have one mesh of two primitives, the second without numbers, and there is a mesh that
 * no node has. */
#define FILE_OF(address, attributes, accessors)                                                    \
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{"     \
    "\"mesh\":1},{\"mesh\":1,"                                                                     \
    "\"translation\":[0,5,0]}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"_"   \
    "OTHER\":3}}]},"                                                                               \
    "{\"primitives\":[{\"attributes\":{\"POSITION\":0," attributes "},\"indices\":1},"             \
    "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}]}],\"materials\":[{}],"        \
    "\"buffers\":[{" address "\"byteLength\":220}]," VIEWS ",\"accessors\":[" POSITION "," INDICES \
    "," accessors "]}"
#define WETNESS "\"_Wetness\":2,\"_PLACE_2\":3,\"TEXCOORD_0\":4,\"COLOR_0\":2"
#define COORDINATES                                                                                \
    "{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,\"count\":7,\"type\":\"VEC2\"}"

/* Six more names. They make nine with `_OTHER` and the two; the ninth is not read. */
#define NINE ",\"_1\":2,\"_2\":2,\"_3\":2,\"_4\":2,\"_5\":2,\"_6\":2"

static int find(const Shape *shape, const char *name)
{
    for (int i = 0; i < SHAPE_NAMED; i++)
        if (!strcmp(shape->names[i], name) && shape->extra[SHAPE_EXTRA_named + i])
            return SHAPE_EXTRA_named + i;
    fail_msg("nothing is called %s", name);
    return 0;
}

/* True if a row with that position has these numbers, and the second attribute is (y, 0, 0, 1). */
static bool is_of_row(const float position[3], const float place[2], const float numbers[4],
                      const float y[4])
{
    for (int i = 0; i < ROWS; i++)
        if (place[0] == rows[i].position[0] && place[1] == rows[i].position[2] &&
            !memcmp(numbers, rows[i].numbers, 16) && y[0] == rows[i].numbers[1] && y[1] == 0 &&
            y[2] == 0 && y[3] == 1)
            return i != 4 && position[1] == -place[1];
    return false;
}

/* The file is y up: (x, y, z) in the file is (x, -z, y). */
static void check_file(const char *name)
{
    char path[128], error[1024] = "";
    ModelPart *parts;
    int count, seen = 0;
    if (!model_read_parts(path_of(name, path), &parts, &count, error, sizeof error))
        fail_msg("%s: %s", name, error);
    assert_int_equal(count, 2); /* the material, and none */
    for (int p = 0; p < count; p++) {
        const Shape *shape = &parts[p].shape;
        assert_int_equal(shape->index_count, 24);
        const int wetness = find(shape, "wetness"), place = find(shape, "place_2");
        /* the numbers of vertices are nobody's coordinates */
        assert_null(shape->extra[SHAPE_EXTRA_uv1]);
        for (int i = 0; i < shape->vertex_count; i++, seen++) {
            const float *at = shape->vertices[i].position, *got = shape->extra[wetness][i];
            if (parts[p].material == MODEL_NO_MATERIAL &&
                !is_of_row(at, (float[]){at[0], -at[1]}, got, shape->extra[place][i]))
                fail_msg("%s: vertex %d at %g %g: %g %g %g %g", name, i, at[0], at[1], got[0],
                         got[1], got[2], got[3]);
            if (parts[p].material != MODEL_NO_MATERIAL)
                assert_true(got[0] == 0 && got[1] == 0 && got[2] == 0 && got[3] == 0);
        }
        shape_free(&parts[p].shape);
    }
    assert_true(seen >= 22); /* six rows twice; five places twice */
    free(parts);
    unlink(path);
}

static void write_binary(const char *name, const char *json)
{
    unsigned char bytes[4096];
    const uint32_t text = ((uint32_t)strlen(json) + 3) / 4 * 4, size = 12 + 8 + text + 8 + 220;
    const uint32_t head[] = {0x46546C67, 2, size, text, 0x4E4F534A}, chunk[] = {220, 0x004E4942};
    assert_true(size <= sizeof bytes);
    memcpy(bytes, head, sizeof head);
    memset(bytes + 20, ' ', text);
    memcpy(bytes + 20, json, strlen(json));
    memcpy(bytes + 20 + text, chunk, sizeof chunk);
    memcpy(bytes + 28 + text, buffer, 220);
    write_file(name, bytes, size);
}

static void vertices_have_what_the_file_says(void **state)
{
    (void)state;
    static const char beside[] =
        FILE_OF("\"uri\":\"rows.bin\",", WETNESS, NUMBERS "," NUMBER "," COORDINATES);
    static const char within[] = FILE_OF("", WETNESS, NUMBERS "," NUMBER "," COORDINATES);
    static const char bare[] =
        FILE_OF("\"uri\":\"rows.bin\",", "\"_WETNESS\":2,\"_place_2\":3" NINE, NUMBERS "," NUMBER);
    write_file("a.gltf", beside, sizeof beside - 1);
    check_file("a.gltf");
    /* its first coordinates are the vertices' numbers */
    write_file("a.gltf", bare, sizeof bare - 1);
    check_file("a.gltf");
    write_binary("a.glb", within);
    check_file("a.glb");
}

/* Rows 0 and 1 have these values of an accessor whose bytes are in view 2; others have 0 if
 * `alone`. */
static void check_rows(const char *accessor, const unsigned char bytes[16], const float want[2],
                       bool alone)
{
    char text[2048], path[128], error[1024] = "";
    unsigned char whole[sizeof buffer] = {0};
    Shape shape;
    memcpy(whole, buffer, 220);
    memcpy(whole + 220, bytes, 16);
    write_file("whole.bin", whole, sizeof whole);
    snprintf(
        text, sizeof text,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{"
        "\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"_A\":2},\"indices\":1}]}],"
        "\"buffers\":[{\"uri\":\"whole.bin\",\"byteLength\":%zu}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":196,\"byteStride\":28},{\"buffer\":0,"
        "\"byteOffset\":196,"
        "\"byteLength\":24},{\"buffer\":0,\"byteOffset\":220,\"byteLength\":64}],"
        "\"accessors\":[" POSITION "," INDICES ",{%s,\"count\":7,\"type\":\"SCALAR\"}]}",
        sizeof whole, accessor);
    write_file("a.gltf", text, strlen(text));
    if (!model_read_in_place(path_of("a.gltf", path), &shape, error, sizeof error))
        fail_msg("%s: %s", accessor, error);
    for (int k = 0; k < shape.vertex_count; k++) {
        const float *at = shape.vertices[k].position, got = shape.extra[SHAPE_EXTRA_named][k][0];
        const int row = at[1] == 0 && at[0] < 2 ? (int)at[0] : 2;
        if (row < 2 ? fabsf(got - want[row]) > 1e-7f : alone && got != 0)
            fail_msg("%s, vertex %d of %d, row %d: %.9g", accessor, k, shape.vertex_count, row,
                     got);
    }
    shape_free(&shape);
}

/* glTF 2.0, section 3.6.2.2: the numbers of row 0 and row 1. */
static void components_are_numbers(void **state)
{
    (void)state;
    static const struct {
        int component;
        bool normalized;
        unsigned char bytes[16];
        float want[2];
    } cases[] = {
        {5120, false, {0x80, 0x7F}, {-128, 127}},
        {5120, true, {0x80, 0x40}, {-1, 64 / 127.f}},
        {5121, false, {0xFF, 3}, {255, 3}},
        {5121, true, {0xFF, 51}, {1, .2f}},
        {5122, false, {0, 0x80, 0xFF, 0x7F}, {-32768, 32767}},
        {5122, true, {0x01, 0x80, 0, 0x40}, {-1, 16384 / 32767.f}},
        {5123, false, {0xFF, 0xFF, 2, 1}, {65535, 258}},
        {5123, true, {0xFF, 0xFF, 0x33, 0x33}, {1, .2f}},
        {5126, false, {0, 0, 0x20, 0x40, 0, 0, 0xC0, 0xFF}, {2.5f, 0}}, /* no number is 0 */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char accessor[128];
        snprintf(accessor, sizeof accessor, "\"bufferView\":2,\"componentType\":%d%s",
                 cases[i].component, cases[i].normalized ? ",\"normalized\":true" : "");
        check_rows(accessor, cases[i].bytes, cases[i].want, false);
    }
}

/* glTF 2.0, section 3.6.2.3: 2.5 for row 0 and -3 for row 1, over nothing, whose values are 0, and
 * over a view. */
static void sparse_values_replace_others(void **state)
{
    (void)state;
    static const struct {
        int component;
        unsigned char bytes[16];
    } cases[] = {
        {5121, {0, 1, 9, 9, 0, 0, 0x20, 0x40, 0, 0, 0x40, 0xC0}},
        {5123, {0, 0, 1, 0, 0, 0, 0x20, 0x40, 0, 0, 0x40, 0xC0}},
        {5125, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0x20, 0x40, 0, 0, 0x40, 0xC0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int over = 0; over < 2; over++) {
            char accessor[512];
            snprintf(
                accessor, sizeof accessor,
                "%s\"componentType\":5126,\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":2,"
                "\"componentType\":%d},\"values\":{\"bufferView\":2,\"byteOffset\":%d}}",
                over ? "\"bufferView\":0,\"byteOffset\":24," : "", cases[i].component,
                cases[i].component == 5125 ? 8 : 4);
            check_rows(accessor, cases[i].bytes, (float[]){2.5f, -3}, !over);
        }
}

#define AT "meshes/1/primitives/0/attributes/_A: "
#define CASE(accessor, reported)                                                                   \
    {                                                                                              \
        FILE_OF("\"uri\":\"rows.bin\",", "\"_A\":2", accessor "," NUMBER), AT reported             \
    }
#define SPARSE(parts, reported)                                                                    \
    CASE("{\"componentType\":5126,\"count\":7,\"type\":\"SCALAR\",\"sparse\":{" parts "}}",        \
         reported)
static void faults_have_places(void **state)
{
    (void)state;
#define NAMED(names, reported)                                                                     \
    {                                                                                              \
        FILE_OF("\"uri\":\"rows.bin\",", names, NUMBER "," NUMBER), reported                       \
    }
    static const struct {
        const char *text, *reported;
    } cases[] = {
        CASE("{\"bufferView\":0,\"componentType\":5126,\"count\":6,\"type\":\"SCALAR\"}",
             "its accessor has another count than"),
        CASE("{\"bufferView\":9,\"componentType\":5126,\"count\":7,\"type\":\"SCALAR\"}",
             "its bufferView does not exist"),
        CASE("{\"bufferView\":0,\"byteOffset\":25,\"componentType\":5126,\"count\":7,\"type\":"
             "\"SCALAR\"}",
             "its accessor exceeds"),
        CASE("{\"bufferView\":0,\"byteOffset\":4294967295,\"componentType\":5126,\"count\":7,"
             "\"type\":\"SCALAR\"}",
             "its accessor exceeds"),
        CASE("{\"bufferView\":0,\"byteOffset\":-4,\"componentType\":5126,\"count\":7,\"type\":"
             "\"SCALAR\"}",
             "its accessor's byteOffset is not"),
        CASE("{\"bufferView\":1,\"componentType\":5126,\"count\":7,\"type\":\"SCALAR\"}",
             "its accessor exceeds"),
        CASE("{\"bufferView\":0,\"componentType\":5125,\"count\":7,\"type\":\"SCALAR\"}",
             "its accessor's componentType is not"),
        CASE("{\"bufferView\":0,\"componentType\":5126,\"count\":7,\"type\":\"MAT4\"}",
             "its bufferView's byteStride is less"),
        SPARSE("", "its accessor has more sparse values than vertices"),
        SPARSE("\"count\":8", "its accessor has more sparse values than vertices"),
        SPARSE("\"count\":1", "its sparse indices' componentType is not"),
        SPARSE("\"count\":1,\"indices\":{\"componentType\":5126}",
               "its sparse indices' componentType is not"),
        SPARSE("\"count\":1,\"indices\":{\"componentType\":5121}", "its bufferView does not exist"),
        SPARSE("\"count\":1,\"indices\":{\"componentType\":5121,\"bufferView\":0}",
               "its bufferView does not exist"),
        SPARSE("\"count\":7,\"indices\":{\"componentType\":5125,\"bufferView\":1}",
               "its sparse values exceed"),
        SPARSE("\"count\":7,\"indices\":{\"componentType\":5121,\"bufferView\":0},\"values\":{"
               "\"bufferView\":1}",
               "its sparse values exceed"),
        SPARSE("\"count\":1,\"indices\":{\"componentType\":5121,\"bufferView\":0,\"byteOffset\":31}"
               ",\"values\":{"
               "\"bufferView\":1}",
               "its sparse indices exceed"),
        NAMED("\"_A\":7", AT "its accessor is not there"),
        NAMED("\"_A\":-1", AT "its accessor is not there"),
        NAMED("\"_A\":{}", AT "its accessor is not there"),
        NAMED("\"_A\":2,\"_a\":3",
              "meshes/1/primitives/0/attributes/_a: two names that differ in capitals alone"),
        {"{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{"
         "\"attributes\":{\"_A\":0}}"
         "]}]}",
         "meshes/0/primitives/0/attributes/_A: its primitive has no POSITION"},
        {"{\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,"
         "\"_A\":0}}]}],"
         "\"accessors\":[{\"count\":"
         "4294967295}]}",
         "meshes/0/primitives/0/attributes/_A: more vertices than are drawn"},
        {FILE_OF("\"uri\":\"gone.bin\",", "\"_A\":2", NUMBER "," NUMBER),
         "meshes/1/primitives/0/indices: the file does not exist"},
        {"{\"meshes\":[{\"primitives\":[{\"attributes\":{\"_A\":0", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[128], error[1024] = "";
        Shape shape;
        write_file("a.gltf", cases[i].text, strlen(cases[i].text));
        assert_false(model_read_in_place(path_of("a.gltf", path), &shape, error, sizeof error));
        assert_true(*error && !shape.vertices);
        if (strncmp(error, cases[i].reported, strlen(cases[i].reported)) != 0)
            fail_msg("%zu: %s, not %s", i, error, cases[i].reported);
    }
}

static int prepare(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    memcpy(buffer, rows, sizeof rows);
    memcpy(buffer + sizeof rows, indices, sizeof indices);
    write_file("rows.bin", buffer, 220);
    return 0;
}

static int clean(void **state)
{
    (void)state;
    static const char *const names[] = {"rows.bin", "whole.bin", "a.gltf"};
    char path[128];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        unlink(path_of(names[i], path));
    return rmdir(folder);
}

int main(void)
{
#ifndef MATC_ASSIMP
    return 77;
#endif
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_have_what_the_file_says),
        cmocka_unit_test(components_are_numbers),
        cmocka_unit_test(sparse_values_replace_others),
        cmocka_unit_test(faults_have_places),
    };
    return cmocka_run_group_tests(tests, prepare, clean);
}
