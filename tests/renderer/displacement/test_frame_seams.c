/* Pictures are sampled with one footprint all over a flat face, also along its triangles' edges:
 * there a 2 x 2 quad of pixels has helper invocations, which read 0 from a storage buffer in
 * Mesa's software driver. Two materials share a program and differ in a constant of their
 * texture coordinate, so that a buffer holds it. The reference is --aa=none, which uses no
 * footprint. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 256, HEIGHT = 128, LONGEST = 4096 };
/* All is magnified, 64 texels to 80 pixels and more, so that no mipmap but the first has a part.
 * The sampler's weights have eight bits, of texels that differ by 1 at most; the layout keeps
 * sqrt(v) in 8 bits: steps of 2 sqrt(v) / 255. */
static const double bound = 1.0 / 256 + 2.0 / 255;

static GlKind kind;

/* Draws a slot of both materials on faces that fill most of the picture. */
static float *draw(const char *text, const char *slot, const char *aa)
{
    MatcOptions options;
    MatcDocument *document;
    matc_options_init(&options);
    options.pixels = true;
    options.aa = aa;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = slot});
    frame_forget(scene, document);
    gl_close(gl);
    return rgba;
}

/* A face of six triangles around a point off its middle; a Box's has two. The y of a file points
 * up. */
static void write_fan(const char *path)
{
    static const double around[6][2] = {{0, 0}, {.6, 0}, {1, 0}, {1, 1}, {.3, 1}, {0, 1}};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < 7; i++) {
        const double u = i < 6 ? around[i][0] : .37, v = i < 6 ? around[i][1] : .58;
        fprintf(file, "v %g %g 0\nvt %g %g\n", u - .5, v - .5, u, v);
    }
    fprintf(file, "vn 0 0 1\n");
    for (int i = 0; i < 6; i++)
        fprintf(file, "f %d/%d/1 %d/%d/1 7/7/1\n", i + 1, i + 1, (i + 1) % 6 + 1, (i + 1) % 6 + 1);
    assert_int_equal(fclose(file), 0);
}

typedef struct {
    const char *material, *slot; /* text before the picture, and the slot that contains it */
} Surface;
typedef struct {
    const char *first, *second; /* the coordinate of each material */
} Coordinates;

static void compare(const Surface *k, const Coordinates *c, const char *object)
{
    char text[LONGEST];
    int seen = 0, off = 0;
    double greatest = 0;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\n"
             "camera: { camera: Orthographic, position: [0, -4, 0], target: [0, 0, 0], size: 1.5, "
             "depth: 9 }\nmaterials:\n"
             "  a: { %s { map: ImageMap, image: " SOURCE_FOLDER
             "/examples/tiles.png, input: %s } }\n"
             "  b: { %s { map: ImageMap, image: " SOURCE_FOLDER
             "/examples/tiles.png, input: %s } }\nobjects:\n"
             "- { object: %s, material: a, transform: { translation: [-.7, 0, 0], rotation: [0, "
             ".35, 0] } }\n"
             "- { object: %s, material: b, transform: { translation: [.7, 0, 0], rotation: [0, "
             "-.1, 0] } }\n",
             WIDTH, HEIGHT, k->material, c->first, k->material, c->second, object, object);
    float *read = draw(text, k->slot, "auto"), *truth = draw(text, k->slot, "none");
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double apart = 0;
        for (int component = 0; component < 3 && truth[4 * i + 3] > 0; component++)
            apart = fmax(apart,
                         fabs((double)read[4 * i + component] - (double)truth[4 * i + component]));
        seen += truth[4 * i + 3] > 0;
        off += apart > bound;
        greatest = fmax(greatest, apart);
    }
    if (off || seen < 9000)
        fail_msg("%s, %s and %s on %s: %d of %d pixels are off, by %g at most", k->material,
                 c->first, c->second, object, off, seen, greatest);
    free(read);
    free(truth);
}

static void faces_have_no_seams(void **state)
{
    (void)state;
    static const Surface kinds[] = {
        {"material: Phong, diffuse:", "diffuse"},
        {"material: Principled, specular: 0, baseColor:", "diffuse"},
        {"material: glTF, metallicFactor: 0, baseColorTexture:", "diffuse"}};
    static const Coordinates coordinates[] = {
        {"{ map: UVTransform, offsetU: .25 }", "{ map: UVTransform, offsetU: .5 }"},
        {"{ map: UVTransform, scaleU: .9 }", "{ map: UVTransform, scaleU: .7 }"},
        {"{ map: UVTransform, scaleU: .8, angle: .3 }",
         "{ map: UVTransform, scaleU: .8, angle: .7 }"},
        {"\"= vec2(u * .9, v)\"", "\"= vec2(u * .6, v)\""}};
    char folder[] = "/tmp/matc_seams_XXXXXX", path[64], mesh[96];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/fan.obj", folder);
    snprintf(mesh, sizeof mesh, "Mesh, file: %s", path);
    write_fan(path);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (size_t k = 0; k < sizeof coordinates / sizeof *coordinates; k++) {
            compare(&kinds[i], &coordinates[k], "Box");
            compare(&kinds[i], &coordinates[k], mesh);
        }
    assert_true(!remove(path) && !rmdir(folder));
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(faces_have_no_seams)};
    kind = frame_kind(count, arguments);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
