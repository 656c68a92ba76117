/* Meshes from files: a square with known tangents, in every format; missing attributes; damaged
 * or hostile files. */
#include "tests/test.h"
#include "runtime/mesh_import/model.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/matc_modelXXXXXX";

static const char *path_of(const char *name, char path[128])
{
    snprintf(path, 128, "%s/%s", folder, name);
    return path;
}

static void write_bytes(const char *name, const void *bytes, size_t size)
{
    char path[128];
    FILE *file = fopen(path_of(name, path), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void write_text(const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
}

/* A square of edge 2 that faces up: its diagonal becomes 2, so dP/du and dP/dv are sqrt(2) long,
 * along x and y. */
static void assert_square(const char *name)
{
    char path[128], error[1024] = "";
    Shape shape;
    if (!model_read(path_of(name, path), &shape, error, sizeof error))
        fail_msg("%s: %s", name, error);
    assert_int_equal(shape.index_count, 6);
    assert_int_equal(shape.vertex_count, 4);
    const float edge = sqrtf(2);
    for (int i = 0; i < shape.vertex_count; i++) {
        const ShapeVertex *w = &shape.vertices[i];
        const float wanted[][3] = {{edge * (w->uv[0] - .5f), edge * (w->uv[1] - .5f), 0},
                                   {0, 0, 1},
                                   {edge, 0, 0},
                                   {0, edge, 0}};
        const float *got[] = {w->position, w->normal, w->tangentU, w->tangentV};
        for (int k = 0; k < 12; k++)
            if (fabsf(got[k / 3][k % 3] - wanted[k / 3][k % 3]) > 1e-5f)
                fail_msg("%s: vertex %d, %d.%d: %g, not %g", name, i, k / 3, k % 3,
                         got[k / 3][k % 3], wanted[k / 3][k % 3]);
    }
    shape_free(&shape);
}

#define GLTF_HEAD                                                                                  \
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{"       \
    "\"mesh\":0,"                                                                                  \
    "\"translation\":[5,6,7]}],"                                                                   \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":"  \
    "2}]}],"
#define GLTF_VIEWS                                                                                 \
    "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},{\"buffer\":0,"            \
    "\"byteOffset\":48,"                                                                           \
    "\"byteLength\":32},"                                                                          \
    "{\"buffer\":0,\"byteOffset\":80,\"byteLength\":12}],"
#define GLTF_TAIL(count, index_count)                                                              \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" count                     \
    ",\"type\":\"VEC3\",\"min\":[-1,0,-1],\"max\":[1,0,1]},"                                       \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"                     \
    "{\"bufferView\":2,\"componentType\":5123,\"count\":" index_count ",\"type\":\"SCALAR\"}]}"

/* v = 0 is the upper edge in glTF. */
static const struct {
    float positions[4][3], uv[4][2];
    uint16_t indices[6];
} square = {{{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}},
            {{0, 1}, {1, 1}, {1, 0}, {0, 0}},
            {0, 1, 2, 0, 2, 3}};

static void a_square_is_one_in_every_format(void **state)
{
    (void)state;
    write_text("square.obj", "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 "
                             "1\nf 1/1 2/2 3/3 4/4\n");
    write_text("square.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
                             "float y\nproperty float z\n"
                             "property float s\nproperty float t\nelement face 2\nproperty list "
                             "uchar int vertex_indices\nend_header\n"
                             "3 3 7 0 0\n5 3 7 1 0\n5 5 7 1 1\n3 5 7 0 1\n3 0 1 2\n3 0 2 3\n");
    write_bytes("square.bin", &square, sizeof square);
    write_text(
        "square.gltf", GLTF_HEAD
        "\"buffers\":[{\"uri\":\"square.bin\",\"byteLength\":92}]," GLTF_VIEWS GLTF_TAIL("4", "6"));
    assert_square("square.obj");
    assert_square("square.ply");
    assert_square("square.gltf");
    static const char json[] =
        GLTF_HEAD "\"buffers\":[{\"byteLength\":92}]," GLTF_VIEWS GLTF_TAIL("4", "6") "   ";
    enum { TEXT = (sizeof json - 1) / 4 * 4, WHOLE = 12 + 8 + TEXT + 8 + sizeof square };
    unsigned char binary[WHOLE];
    const uint32_t words[] = {0x46546C67, 2, WHOLE, TEXT, 0x4E4F534A},
                   chunk[] = {sizeof square, 0x004E4942};
    memcpy(binary, words, sizeof words);
    memcpy(binary + 20, json, TEXT);
    memcpy(binary + 20 + TEXT, chunk, sizeof chunk);
    memcpy(binary + 28 + TEXT, &square, sizeof square);
    write_bytes("square.glb", binary, sizeof binary);
    assert_square("square.glb");
    /* cut anywhere, it is a fault or a square */
    for (size_t size = 1; size < sizeof binary; size += 97) {
        char path[128], error[1024] = "";
        Shape shape;
        write_bytes("cut.glb", binary, size);
        assert_false(model_read(path_of("cut.glb", path), &shape, error, sizeof error));
        assert_true(*error && !shape.vertices);
    }
}

/* A cube of corners alone: its normals point outwards, tangents lie across them and turn as on
 * every shape. */
static void what_is_missing_is_made(void **state)
{
    (void)state;
    char path[128], error[1024] = "";
    Shape shape;
    write_text("cube.obj",
               "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
               "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    assert_true(model_read(path_of("cube.obj", path), &shape, error, sizeof error));
    assert_int_equal(shape.index_count, 36);
    for (int i = 0; i < shape.vertex_count; i++) {
        const ShapeVertex *w = &shape.vertices[i];
        const float *a = w->tangentU, *b = w->tangentV, *n = w->normal, *p = w->position;
        const float c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0]};
        assert_float_equal(p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 1, 1e-5);
        assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
        assert_true(n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.5f);
        assert_float_equal(a[0] * n[0] + a[1] * n[1] + a[2] * n[2], 0, 1e-4);
        assert_true(fabsf(c[0] * n[0] + c[1] * n[1] + c[2] * n[2]) > 1e-6f);
        assert_true(w->uv[0] >= 0 && w->uv[0] <= 1 && w->uv[1] >= 0 && w->uv[1] <= 1);
    }
    shape_free(&shape);
}

/* Two triangles with legs 3, 3 and 3, 1 meet at a right angle. Their cross products are (0, 0, 9)
 * and (3, 0, 0), so weights by area give shared corners the normal (1, 0, 3) / sqrt(10). Weights by
 * angle or by face would give (1, 0, 1) / sqrt(2). u and v identify the corners. */
static void missing_normals_are_weighed_by_area(void **state)
{
    (void)state;
    static const struct {
        float uv[2], normal[3];
    } corners[] = {{{1, 0}, {.3162278f, 0, .9486833f}},
                   {{1, 1}, {.3162278f, 0, .9486833f}},
                   {{2, 0}, {0, 0, 1}},
                   {{0, 0}, {1, 0, 0}}};
    char path[128], error[1024] = "";
    Shape shape;
    write_text("corner.ply",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nproperty float s\nproperty float t\nelement face 2\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0 1 0\n3 0 0 2 0\n0 3 0 1 1\n0 0 1 0 0\n3 0 1 2\n3 0 2 3\n");
    if (!model_read(path_of("corner.ply", path), &shape, error, sizeof error))
        fail_msg("%s", error);
    assert_int_equal(shape.index_count, 6);
    for (int i = 0; i < shape.vertex_count; i++) {
        const ShapeVertex *vertex = &shape.vertices[i];
        int corner = 0;
        while (corner < 4 && memcmp(vertex->uv, corners[corner].uv, sizeof vertex->uv) != 0)
            corner++;
        assert_true(corner < 4);
        for (int k = 0; k < 3; k++)
            assert_float_equal(vertex->normal[k], corners[corner].normal[k], 1e-5);
    }
    shape_free(&shape);
}

/* Two squares left and right of x = 0, u = |x|: dP/du runs away from the middle on both. Their two
 * corners in the middle become four. */
static void assert_mirrored(bool (*read)(const char *, Shape *, char *, size_t), float size)
{
    char path[128], error[1024] = "";
    Shape shape;
    if (!read(path_of("mirrored.obj", path), &shape, error, sizeof error))
        fail_msg("%s", error);
    assert_int_equal(shape.index_count, 12);
    assert_int_equal(shape.vertex_count, 8);
    for (int i = 0; i < shape.index_count; i += 3) {
        const ShapeVertex *corner[3];
        float middle = 0;
        for (int k = 0; k < 3; k++) {
            corner[k] = &shape.vertices[shape.indices[i + k]];
            middle += corner[k]->position[0] / 3;
        }
        for (int k = 0; k < 3; k++) {
            const float away = middle < 0 ? -size : size;
            const float wanted[][3] = {
                {away * corner[k]->uv[0], size * (corner[k]->uv[1] - .5f), 0},
                {0, 0, 1},
                {away, 0, 0},
                {0, size, 0}};
            const float *got[] = {corner[k]->position, corner[k]->normal, corner[k]->tangentU,
                                  corner[k]->tangentV};
            for (int component = 0; component < 12; component++)
                assert_float_equal(got[component / 3][component % 3],
                                   wanted[component / 3][component % 3], 1e-5);
        }
    }
    shape_free(&shape);
}

static void mirrored_halves_keep_their_tangents(void **state)
{
    (void)state;
    write_text("mirrored.obj",
               "v -3 0 1.5\nv 0 0 1.5\nv 3 0 1.5\nv -3 0 -1.5\nv 0 0 -1.5\nv 3 0 -1.5\n"
               "vt 1 0\nvt 0 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 5/4 4/3\nf 2/2 3/1 6/3 5/4\n");
    assert_mirrored(model_read, 2 / sqrtf(5));
    assert_mirrored(model_read_in_place, 3);
}

/* Normals are the file's, whichever way its triangles turn: tangents are those of its coordinates
 * all the same. */
static void normals_may_face_the_other_way(void **state)
{
    (void)state;
    char path[128], error[1024] = "";
    Shape shape;
    write_text("under.obj",
               "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 -1 0\n"
               "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
    assert_true(model_read_in_place(path_of("under.obj", path), &shape, error, sizeof error));
    for (int i = 0; i < shape.vertex_count; i++) {
        const ShapeVertex *w = &shape.vertices[i];
        const float wanted[][3] = {{0, 0, -1}, {2, 0, 0}, {0, 2, 0}},
                    *got[] = {w->normal, w->tangentU, w->tangentV};
        for (int component = 0; component < 9; component++)
            assert_float_equal(got[component / 3][component % 3],
                               wanted[component / 3][component % 3], 1e-5);
    }
    shape_free(&shape);
}

/* Rows of hills without texture coordinates: longitude and latitude turn back on every slope that
 * faces the middle. The tangents of a triangle's corners turn as its own coordinates do, all
 * three. */
static void tangents_turn_as_their_triangle(void **state)
{
    (void)state;
    enum { SIDE = 24 };
    static char text[SIDE * SIDE * 80];
    size_t used = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "v %d %.3f %d\n", i % SIDE,
                                 2 * sin(0.7 * (i % SIDE)) * cos(0.5 * (i / SIDE)), -(i / SIDE));
    for (int i = 1; i < SIDE * SIDE - SIDE; i++)
        if (i % SIDE)
            used += (size_t)snprintf(text + used, sizeof text - used, "f %d %d %d %d\n", i, i + 1,
                                     i + 1 + SIDE, i + SIDE);
    write_text("hills.obj", text);
    char path[128], error[1024] = "";
    Shape shape;
    assert_true(model_read(path_of("hills.obj", path), &shape, error, sizeof error));
    int left = 0, right = 0;
    for (int i = 0; i < shape.index_count; i++) {
        const ShapeVertex *w = &shape.vertices[shape.indices[i]],
                          *first = &shape.vertices[shape.indices[i - i % 3]];
        const ShapeVertex *second = &shape.vertices[shape.indices[i - i % 3 + 1]],
                          *third = &shape.vertices[shape.indices[i - i % 3 + 2]];
        const float area = (second->uv[0] - first->uv[0]) * (third->uv[1] - first->uv[1]) -
                           (second->uv[1] - first->uv[1]) * (third->uv[0] - first->uv[0]);
        const float *a = w->tangentU, *b = w->tangentV, *n = w->normal;
        const float turn = n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) +
                           n[2] * (a[0] * b[1] - a[1] * b[0]);
        if (!(area * turn > 0))
            fail_msg("triangle %d, corner %d: area %g in u and v, turn %g", i / 3, i % 3, area,
                     turn);
        left += turn < 0;
        right += turn > 0;
    }
    assert_true(left > 300 && right > 300);
    shape_free(&shape);
}

static void faults_are_reported(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text;
        const char *why; /* part of the expected message; NULL: any */
    } cases[] = {
        {"empty.obj", "", NULL},
        {"empty.ply", "", NULL},
        {"empty.gltf", "", NULL},
        {"empty.glb", "", NULL},
        {"prose.obj", "a mesh, it says\n", NULL},
        {"prose.gltf", "{ \"asset\": 3 }", NULL},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n", NULL},
        {"far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", NULL},
        {"back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -9 1 2\n", NULL},
        {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", NULL},
        {"far.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face "
         "1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
         NULL},
        {"large.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float "
         "x\nproperty float "
         "y\nproperty float z\n"
         "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n0",
         NULL},
        {"point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", NULL},
        {"large.gltf",
         GLTF_HEAD "\"buffers\":[{\"uri\":\"square.bin\",\"byteLength\":92}]," GLTF_VIEWS GLTF_TAIL(
             "4000000", "4000000"),
         NULL},
        {"away.gltf",
         GLTF_HEAD
         "\"buffers\":[{\"uri\":\"nothing.bin\",\"byteLength\":92}]," GLTF_VIEWS GLTF_TAIL("4",
                                                                                           "6"),
         NULL},
        {"mesh.stl", "solid a\n", "a mesh is a file .obj, .gltf, .glb or .ply"},
        {"mesh", "v 0 0 0\n", "a mesh is a file"},
    };
    char path[128], error[1024];
    Shape shape;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_text(cases[i].name, cases[i].text);
        *error = 0;
        if (model_read(path_of(cases[i].name, path), &shape, error, sizeof error))
            fail_msg("%s is a mesh", cases[i].name);
        print_message("%s: %s\n", cases[i].name, error);
        assert_true(*error && !shape.vertices && !shape.indices);
        assert_true(!cases[i].why || strstr(error, cases[i].why));
    }
    assert_false(model_read(path_of("nothing.obj", path), &shape, error, sizeof error));
    assert_non_null(strstr(error, "No such file"));
    assert_false(model_read("/dev/null.obj", &shape, error, sizeof error));
}

/* With the process that waits, whose end nobody would see. */
static void end_all(int signal)
{
    (void)signal;
    kill(0, SIGKILL);
}

/* A file's references must be regular files, and not too large: nobody writes into a pipe, and a
 * device has no end. A list of materials is not needed. */
static void named_files_are_files(void **state)
{
    (void)state;
    static const char *const names[] = {"pipe", "folder", "/dev/zero", "large", "nowhere"};
    char path[128], error[1024], text[2048];
    Shape shape;
    assert_int_equal(mkfifo(path_of("pipe", path), 0600), 0);
    assert_int_equal(mkdir(path_of("folder", path), 0700), 0);
    write_text("large", "");
    assert_int_equal(truncate(path_of("large", path), ((off_t)MODEL_FILE_MIB << 20) + 1), 0);
    setpgid(0, 0); /* one that leads a session has a group of its own */
    signal(SIGALRM, end_all);
    alarm(60); /* to wait for ever is a fault */
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        snprintf(text, sizeof text, "mtllib %s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", names[i]);
        write_text("names.obj", text);
        if (!model_read(path_of("names.obj", path), &shape, error, sizeof error))
            fail_msg("%s as a list of materials: %s", names[i], error);
        assert_int_equal(shape.index_count, 3);
        shape_free(&shape);
        snprintf(text, sizeof text,
                 GLTF_HEAD "\"buffers\":[{\"uri\":\"%s\",\"byteLength\":92}]," GLTF_VIEWS "%s",
                 names[i], GLTF_TAIL("4", "6"));
        write_text("names.gltf", text);
        assert_false(model_read(path_of("names.gltf", path), &shape, error, sizeof error));
        if (!strstr(error, "the file does not exist or is too large"))
            fail_msg("%s as a buffer: %s", names[i], error);
    }
    alarm(0);
}

/* Data from the pipe is checked as the file is. */
static void parts_are_checked(void **state)
{
    (void)state;
    static const struct {
        float x, u;
        uint32_t index;
        int indices;
        const char *why;
    } cases[] = {
        {1, 1, 2, 3, NULL},
        {1, 1, 3, 3, "a corner that is not there"},
        {1, 1, UINT32_MAX, 3, "a corner that is not there"},
        {1, 1, 2, 2, "no triangle"},
        {1, 1, 2, 0, "no triangle"},
        {1, 1, 2, 4, "lacks corners"},
        {NAN, 1, 2, 3, "a position is no number"},
        {INFINITY, 1, 2, 3, "a position is no number"},
        {1e30f, 1, 2, 3, "a position is no number"},
        {1, NAN, 2, 3, "a texture coordinate is no number"},
        {1, INFINITY, 2, 3, "a texture coordinate is no number"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ShapeVertex vertices[3] = {{{0, 0, 0}, {0}, {0, 0}, {0}, {0}},
                                   {{cases[i].x, 0, 0}, {0}, {cases[i].u, 0}, {0}, {0}},
                                   {{0, 1, 0}, {NAN, 0, 0}, {0, 1}, {0}, {0}}};
        uint32_t indices[4] = {0, 1, cases[i].index, 0};
        Shape shape = {.vertices = vertices,
                       .indices = indices,
                       .vertex_count = 3,
                       .index_count = cases[i].indices};
        const char *why = model_complete(&shape, true, true);
        if (!why != !cases[i].why || (why && !strstr(why, cases[i].why)))
            fail_msg("%zu: %s", i, why ? why : "fine");
        for (int k = 0; !why && k < 3; k++)
            assert_true(vertices[k].normal[2] == 1); /* an invalid normal is replaced */
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
#ifndef MATC_ASSIMP
    puts("SKIPPED: assimp is not installed (Debian: libassimp-dev), so no mesh was read");
    return 77;
#endif
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_square_is_one_in_every_format),
        cmocka_unit_test(what_is_missing_is_made),
        cmocka_unit_test(missing_normals_are_weighed_by_area),
        cmocka_unit_test(mirrored_halves_keep_their_tangents),
        cmocka_unit_test(normals_may_face_the_other_way),
        cmocka_unit_test(tangents_turn_as_their_triangle),
        cmocka_unit_test(faults_are_reported),
        cmocka_unit_test(named_files_are_files),
        cmocka_unit_test(parts_are_checked),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
