/* OBJ and PLY files against corners written by hand: each case lists the position, texture
 * coordinates and normal of every corner of every triangle, in the file's order and in the
 * scene's axes (OBJ turns y up to z up). To add a case, add a row. */
#include "tests/test.h"
#include "runtime/mesh_import/model.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { CORNERS = 12 };
#define ANY NAN /* a value that is not compared */

typedef struct {
    const char *name, *ending, *text;
    size_t size; /* of bytes; 0: a string */
    int corners;
    float expected[CORNERS][8];
    float colors[CORNERS][4];
    const char *error;
} Case;

#define PLY_HEAD(format, properties, faces)                                                        \
    "ply\r\nformat " format " 1.0\r\ncomment by hand\r\nelement vertex 3\r\n" properties           \
    "element face " faces "\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
#define PLY_XYZ "property float x\r\nproperty float y\r\nproperty float z\r\n"
#define BIG_BYTES                                                                                  \
    PLY_HEAD("binary_big_endian",                                                                  \
             "property short y\r\nproperty uchar w\r\nproperty double x\r\n"                       \
             "property char z\r\n",                                                                \
             "1")                                                                                  \
    "\xFF\xFE\x07\x3F\xF0\0\0\0\0\0\0\xFD"                                                         \
    "\x01\x00\x07\0\0\0\0\0\0\0\0\x05"                                                             \
    "\x00\x03\x07\x40\0\0\0\0\0\0\0\0"                                                             \
    "\x03\0\0\0\0\0\0\0\1\0\0\0\2"

static const Case cases[] = {
    {"marks, comments, tabs, a continued line, numbers in all forms",
     "obj",
     "\xEF\xBB\xBF# by hand\r\nv .5 0 -0\r\nv\t1.5e+0 \\\r\n 2. 0\r\nv 1 0 -2E-1 1 # a weight\r\n"
     "vt .25\r\nvn 0 0 1\r\nusemtl nothing\r\nf 1/1/1 2/1/1 -1/-1/-1#behind\r\n",
     0,
     3,
     {{.5f, 0, 0, .25f, 0, 0, -1, 0},
      {1.5f, 0, 2, .25f, 0, 0, -1, 0},
      {1, .2f, 0, .25f, 0, 0, -1, 0}},
     {{0}},
     NULL},
    {"an arrowhead, concave at its third corner",
     "obj",
     "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nl 1 2\nf 1 2 3 4\n",
     0,
     6,
     {{0, 0, 0, ANY, ANY, 0, -1, 0},
      {2, 0, -1, ANY, ANY, 0, -1, 0},
      {1, 0, 0, ANY, ANY, 0, -1, 0},
      {0, 0, 0, ANY, ANY, 0, -1, 0},
      {1, 0, 0, ANY, ANY, 0, -1, 0},
      {2, 0, 1, ANY, ANY, 0, -1, 0}},
     {{0}},
     NULL},
    {"a fold, flat behind `s off`",
     "obj",
     "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\ns off\nf 1 3 2\nf 1 2 4\n",
     0,
     6,
     {{0, 0, 0, ANY, ANY, 0, -1, 0},
      {1, 0, 0, ANY, ANY, 0, -1, 0},
      {0, 0, 1, ANY, ANY, 0, -1, 0},
      {0, 0, 0, ANY, ANY, 1, 0, 0},
      {0, 0, 1, ANY, ANY, 1, 0, 0},
      {0, -1, 0, ANY, ANY, 1, 0, 0}},
     {{0}},
     NULL},
    {"a fold, smooth without `s`",
     "obj",
     "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n",
     0,
     6,
     {{0, 0, 0, ANY, ANY, .7071068f, -.7071068f, 0},
      {1, 0, 0, ANY, ANY, 0, -1, 0},
      {0, 0, 1, ANY, ANY, .7071068f, -.7071068f, 0},
      {0, 0, 0, ANY, ANY, .7071068f, -.7071068f, 0},
      {0, 0, 1, ANY, ANY, .7071068f, -.7071068f, 0},
      {0, -1, 0, ANY, ANY, 1, 0, 0}},
     {{0}},
     NULL},
    {"faces with and without coordinates, and colors",
     "obj",
     "v 0 0 0 1 .5 0\nv 1 0 0 0 0 1\nv 0 1 0\nvt 3 4\nf 1 2 3\nf 1/1 2/1 3/1\n",
     0,
     6,
     {{0, 0, 0, 3, 4, 0, -1, 0},
      {1, 0, 0, 3, 4, 0, -1, 0},
      {0, 0, 1, 3, 4, 0, -1, 0},
      {0, 0, 0, ANY, ANY, 0, -1, 0},
      {1, 0, 0, ANY, ANY, 0, -1, 0},
      {0, 0, 1, ANY, ANY, 0, -1, 0}},
     {{1, .5f, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}, {1, .5f, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}},
     NULL},
    {"a zero index", "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 0 1 2\n", 0, 0, {{0}}, {{0}}, "line 5"},
    {"a text with colors and normals",
     "ply",
     PLY_HEAD("ascii",
              "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\n" PLY_XYZ
              "property float nx\r\nproperty float ny\r\nproperty float nz\r\n"
              "property float texture_u\r\nproperty float texture_v\r\n",
              "1") "255 0 51 1 2 3 0 0 1 .5 .25\r\n0 255 0 4 2 3 0 0 1 1 0\r\n0 0 0 1 5 3 0 1 0 0 "
                   "1\r\n3 0 1 2\r\n",
     0,
     3,
     {{1, 2, 3, .5f, .25f, 0, 0, 1}, {4, 2, 3, 1, 0, 0, 0, 1}, {1, 5, 3, 0, 1, 0, 1, 0}},
     {{1, 0, .2f, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}},
     NULL},
    {"bytes, highest first, in types of another order",
     "ply",
     BIG_BYTES,
     sizeof BIG_BYTES - 1,
     3,
     {{1, -2, -3, ANY, ANY, ANY, ANY, ANY},
      {0, 256, 5, ANY, ANY, ANY, ANY, ANY},
      {2, 3, 0, ANY, ANY, ANY, ANY, ANY}},
     {{0}},
     NULL},
    {"a strip",
     "ply",
     "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n"
     "element tristrips 1\nproperty list int int vertex_index\nend_header\n"
     "0 0 0 1 0 0 0 1 0 1 1 0\n6 0 1 2 3 -1 0\n",
     0,
     6,
     {{0, 0, 0, ANY, ANY, 0, 0, 1},
      {1, 0, 0, ANY, ANY, 0, 0, 1},
      {0, 1, 0, ANY, ANY, 0, 0, 1},
      {0, 1, 0, ANY, ANY, 0, 0, 1},
      {1, 0, 0, ANY, ANY, 0, 0, 1},
      {1, 1, 0, ANY, ANY, 0, 0, 1}},
     {{0}},
     NULL},
    {"a list beyond the file",
     "ply",
     PLY_HEAD("ascii", PLY_XYZ, "1") "0 0 0\n1 0 0\n0 1 0\n250 0 1 2\n",
     0,
     0,
     {{0}},
     {{0}},
     "line 14: a list is longer than the file"},
    {"an unknown type",
     "ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty flt x\n",
     0,
     0,
     {{0}},
     {{0}},
     "line 4: a property has an unknown type"},
};

static char path[32];

static bool read_case(const Case *c, size_t size, Shape *shape, char error[1024])
{
    memcpy(path + strlen(path) - 3, c->ending, 3);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(c->text, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    const bool done = model_read_in_place(path, shape, error, 1024);
    unlink(path);
    return done;
}

static void check_corner(const Case *c, const Shape *shape, int corner)
{
    const uint32_t index = shape->indices[corner];
    const ShapeVertex *v = &shape->vertices[index];
    const float got[] = {v->position[0], v->position[1], v->position[2], v->uv[0],
                         v->uv[1],       v->normal[0],   v->normal[1],   v->normal[2]};
    for (int k = 0; k < 8; k++)
        if (!isnan(c->expected[corner][k]) && !(fabsf(got[k] - c->expected[corner][k]) < 1e-6f))
            fail_msg("%s: corner %d, %d: %g, not %g", c->name, corner, k, got[k],
                     c->expected[corner][k]);
    for (int k = 0; k < 4 && c->colors[0][3] > 0; k++)
        assert_float_equal(shape->extra[SHAPE_EXTRA_color][index][k], c->colors[corner][k], 1e-6);
}

static void corners_are_those_of_the_file(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Case *c = &cases[i];
        Shape shape;
        char error[1024] = "";
        const bool done = read_case(c, c->size ? c->size : strlen(c->text), &shape, error);
        if (done != !c->error || (c->error && !strstr(error, c->error)))
            fail_msg("%s: %s", c->name, done ? "it was read" : error);
        if (!done)
            continue;
        if (shape.index_count != c->corners)
            fail_msg("%s: %d corners, not %d", c->name, shape.index_count, c->corners);
        for (int k = 0; k < c->corners; k++)
            check_corner(c, &shape, k);
        shape_free(&shape);
    }
}

/* A file cut anywhere is an error or a mesh, never a crash. */
static void cut_files_end(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (size_t size = 0; size < (cases[i].size ? cases[i].size : strlen(cases[i].text));
             size++) {
            Shape shape;
            char error[1024] = "";
            if (read_case(&cases[i], size, &shape, error))
                shape_free(&shape);
            else
                assert_true(*error && !shape.vertices);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(corners_are_those_of_the_file),
                                       cmocka_unit_test(cut_files_end)};
    snprintf(path, sizeof path, "/tmp/matc_obj_ply%06u.obj", (unsigned)getpid() % 1000000u);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
