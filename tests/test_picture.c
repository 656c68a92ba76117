/* Pictures: the same material through every layout. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "grammar/layout_tables.h"
#include "runtime/view/picture.h"
#include <stdlib.h>
#include <string.h>

extern const char view_text_screen[], view_text_light[];

/* The same picture but for quantisation: mean and greatest difference to that of the thesis' layout, in steps of 255. */
static void pictures_are_alike(void **state)
{
    (void)state;
    enum { PIXELS = 96 * 96 };
    static unsigned char first[3 * PIXELS], picture[3 * PIXELS];
    static const char text[] = "material: Phong\n"
                               "diffuse: { map: Checker, color1: [0.2, 0.5, 0.8], color2: [0.6, 0.3, 0.1] }\n"
                               "specular: [0.4, 0.35, 0.3]\nshininess: 0.8\ntransparency: [0.1, 0.2, 0.05]\n"
                               "diffuseTransparency: [0.1, 0.05, 0.2]\nemissive: [0.02, 0.05, 0.01]\n";
    MatcOptions compile;
    matc_options_init(&compile);
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &compile);
    assert_int_equal(matc_material_count(document), 1);
    for (int layout = 0; layout < LAYOUT_COUNT; layout++) {
        Picture drawn = {.rgb = layout ? picture : first};
        PictureOptions options = {.compile = compile,
                                  .view = {.width = 96,
                                           .height = 96,
                                           .supersampling = 2,
                                           .screen_text = view_text_screen,
                                           .light_text = view_text_light}};
        double sum = 0;
        int greatest = 0;
        options.compile.layout = layout_table[layout].name;
        if (!picture_draw(document, 0, &options, &drawn))
            fail_msg("%s%s", drawn.diagnostics, drawn.error);
        free(drawn.diagnostics);
        for (int i = 0; layout && i < 3 * PIXELS; i++) {
            int difference = abs(picture[i] - first[i]);
            sum += difference;
            greatest = difference > greatest ? difference : greatest;
        }
        print_message("%s: mean %.4f, greatest %d\n", layout_table[layout].name, sum / (3 * PIXELS), greatest);
        assert_true(sum / (3 * PIXELS) < 1.5 && greatest <= 12);
    }
    matc_document_free(document);
}

/* Something is seen: the middle is not as the corner, and not all is of one brightness. */
static void assert_shows_something(const unsigned char *rgb, int size)
{
    const unsigned char *middle = rgb + 3 * (size / 2 * size + size / 2);
    int least = 255, most = 0;
    for (int i = 0; i < size * size * 3; i++) {
        least = rgb[i] < least ? rgb[i] : least;
        most = rgb[i] > most ? rgb[i] : most;
    }
    assert_memory_not_equal(middle, rgb, 3);
    assert_true(most - least > 60);
}

static MatcProgram *compile(const char *text, unsigned outputs, MatcDocument **document)
{
    MatcOptions options;
    matc_options_init(&options);
    *document = matc_read("test.yaml", text, strlen(text), &options);
    assert_int_equal(matc_material_count(*document), 1);
    MatcProgram *program = matc_compile(*document, 0, outputs, &options);
    assert_true(matc_ok(program));
    return program;
}

/* In the caller's context and in the picture's own. */
static void shapes_are_seen(void **state)
{
    (void)state;
    enum { SIZE = 96 };
    static unsigned char rgb[3 * SIZE * SIZE];
    char error[1024] = "";
    MatcDocument *document;
    MatcProgram *program = compile("{ material: Phong, diffuse: { map: Checker, color1: 0.6, color2: [0.1, 0.3, 0.5], "
                                   "input: { map: UVTransform, scaleU: 8, scaleV: 4 } }, shininess: 0.7 }",
                                   MATC_VERTEX | MATC_FRAGMENT | MATC_UNPACK, &document);
    GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    for (int shape = 0; shape < 2 * SHAPE_count; shape++) {
        const ViewOptions options = {.shape = (ShapeKind)(shape / 2),
                                     .width = SIZE,
                                     .height = SIZE,
                                     .screen_text = view_text_screen,
                                     .light_text = view_text_light,
                                     .gl = shape % 2 ? NULL : gl};
        if (!view_render(&options, program, rgb, error, sizeof error))
            fail_msg("%s", error);
        assert_shows_something(rgb, SIZE);
        assert_true(gl_use(gl)); /* a context of its own took ours away */
        assert_true(gl_check(gl, "drawing a picture"));
    }
    gl_close(gl);
    matc_program_free(program);
    matc_document_free(document);
}

static void assert_refused(const ViewOptions *options, MatcProgram *program, const char *why)
{
    char error[4096] = "";
    unsigned char rgb[3];
    assert_false(view_render(options, program, rgb, error, sizeof error));
    if (strncmp(error, why, strlen(why)) != 0)
        fail_msg("%s", error);
}

static void view_refuses(void **state)
{
    (void)state;
    MatcDocument *documents[2];
    MatcProgram *whole = compile("material: Phong", MATC_VERTEX | MATC_FRAGMENT | MATC_UNPACK, &documents[0]);
    MatcProgram *part = compile("material: Phong", MATC_FRAGMENT, &documents[1]);
    ViewOptions options = {.width = 1, .height = 1, .screen_text = "void main() { }", .light_text = "wrong"};
    assert_refused(&options, part, "the material's program lacks a text");
    assert_refused(&options, whole, "fragment: ");
    options.width = 100000;
    assert_refused(&options, whole, "the picture with its supersampling is larger than 8192 pixels");
    options.width = 1, options.supersampling = 9;
    assert_refused(&options, whole, "supersampling is 1 to 8");
    matc_program_free(whole);
    matc_program_free(part);
    matc_document_free(documents[0]);
    matc_document_free(documents[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_alike),
        cmocka_unit_test(shapes_are_seen),
        cmocka_unit_test(view_refuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
