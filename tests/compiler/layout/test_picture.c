/* Pictures: the same material through every layout. */
/* ctest: quick */
#include "tests/test.h"
#include "grammar/layout_tables.h"
#include "tests/preview.h"

/* Pictures equal up to quantization: mean and greatest difference from that of the thesis' layout,
 * in steps of 1/255. */
static void pictures_are_alike(void **state)
{
    (void)state;
    enum { PIXELS = 96 * 96 };
    static unsigned char first[3 * PIXELS], picture[3 * PIXELS];
    static const char text[] =
        "material: Phong\n"
        "diffuse: { map: Checker, color1: [0.2, 0.5, 0.8], color2: [0.6, 0.3, 0.1] }\n"
        "specular: [0.4, 0.35, 0.3]\nshininess: 0.8\ntransparency: [0.1, 0.2, 0.05]\n"
        "diffuseTransparency: [0.1, 0.05, 0.2]\nemissive: [0.02, 0.05, 0.01]\n";
    MatcOptions compile;
    matc_options_init(&compile);
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &compile);
    assert_int_equal(matc_material_count(document), 1);
    for (int layout = 0; layout < LAYOUT_COUNT; layout++) {
        const MaterialPictureOptions options = {
            .pictures = {.renderer = {.compile = &compile, .samples = 2}},
            .preview = {.width = 96, .height = 96}};
        double sum = 0;
        int greatest = 0;
        compile.layout = layout_table[layout].name;
        draw_pixels(document, &options, layout ? picture : first);
        for (int i = 0; layout && i < 3 * PIXELS; i++) {
            int difference = abs(picture[i] - first[i]);
            sum += difference;
            greatest = difference > greatest ? difference : greatest;
        }
        print_message("%s: mean %.4f, greatest %d\n", layout_table[layout].name, sum / (3 * PIXELS),
                      greatest);
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

/* All by one context, which each leaves as clean as it was. */
static void shapes_are_seen(void **state)
{
    (void)state;
    enum { SIZE = 96 };
    static unsigned char rgb[3 * SIZE * SIZE];
    static const char text[] =
        "{ material: Phong, diffuse: { map: Checker, color1: 0.6, color2: [0.1, 0.3, 0.5], "
        "input: { map: UVTransform, scaleU: 8, scaleV: 4 } }, shininess: 0.7 }";
    char error[512] = "";
    MatcOptions compile;
    MaterialReport reported;
    matc_options_init(&compile);
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &compile);
    GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    for (int shape = 0; shape < SHAPE_count; shape++) {
        const MaterialPictureOptions options = {
            .pictures = {.renderer = {.compile = &compile}},
            .preview = {.shape = (ShapeKind)shape, .width = SIZE, .height = SIZE}};
        MaterialPictures *pictures = material_pictures_open(gl, &options);
        if (!pictures || !material_pictures_show(pictures, document, 0, &reported) ||
            !scene_pictures_pixels(material_pictures_of(pictures), rgb))
            fail_msg("%s", gl->error);
        free(reported.diagnostics);
        material_pictures_close(pictures);
        assert_shows_something(rgb, SIZE);
        assert_true(gl_check(gl, "drawing a picture"));
    }
    gl_close(gl);
    matc_document_free(document);
}

/* One renderer for all: each picture is what a renderer of its own draws, whatever was drawn
 * before. */
static void pictures_do_not_mix(void **state)
{
    (void)state;
    enum { SIZE = 24, BYTES = 3 * SIZE * SIZE };
    static const char text[] =
        "materials: { a: { material: Phong, diffuse: [0.6, 0.3, 0.1] }, b: { material: Phong, "
        "transparency: 0.5 }, c: { material: Phong, diffuse: [0.1, 0.3, 0.1] } }";
    static const int order[] = {0, 1, 2, 1, 0};
    static unsigned char alone[3][BYTES], rgb[BYTES];
    MatcOptions compile;
    MaterialReport reported;
    char error[512];
    matc_options_init(&compile);
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &compile);
    GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    assert_non_null(gl);
    const MaterialPictureOptions options = {
        .pictures = {.renderer = {.compile = &compile}},
        .preview = {.shape = SHAPE_torus, .width = SIZE, .height = SIZE}};
    for (int i = -3; i < (int)(sizeof order / sizeof *order); i++) {
        static MaterialPictures *all;
        MaterialPictures *pictures = i < 0 || !all ? material_pictures_open(gl, &options) : all;
        const int material = i < 0 ? i + 3 : order[i];
        assert_true(pictures && material_pictures_show(pictures, document, material, &reported));
        assert_true(
            scene_pictures_pixels(material_pictures_of(pictures), i < 0 ? alone[material] : rgb));
        free(reported.diagnostics);
        all = i < 0 ? NULL : pictures;
        if (i < 0 || i + 1 == (int)(sizeof order / sizeof *order))
            material_pictures_close(pictures);
        if (i >= 0)
            assert_memory_equal(rgb, alone[material], BYTES);
    }
    assert_memory_not_equal(alone[0], alone[1], BYTES);
    assert_memory_not_equal(alone[0], alone[2], BYTES);
    gl_close(gl);
    matc_document_free(document);
}

/* Faults of the compiler are passed on unchanged; a slot that a layout lacks is named by the error.
 * */
static void faults_are_reported(void **state)
{
    (void)state;
    static const struct {
        const char *text, *layout, *slot, *reported;
    } cases[] = {
        {"{ material: Phong }", "compact", "ior", "the layout does not store that slot"},
        {"{ material: Phong }", "unknown", NULL, "error: layout: unknown value 'unknown'"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char error[512];
        MatcOptions compile;
        MaterialReport reported;
        matc_options_init(&compile);
        MatcDocument *document =
            matc_read("test.yaml", cases[i].text, strlen(cases[i].text), &compile);
        compile.layout = cases[i].layout;
        GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
        const MaterialPictureOptions options = {.pictures = {.renderer = {.compile = &compile}},
                                                .preview = {.width = 8, .height = 8},
                                                .slot = cases[i].slot};
        MaterialPictures *pictures = gl ? material_pictures_open(gl, &options) : NULL;
        assert_non_null(pictures);
        assert_false(material_pictures_show(pictures, document, 0, &reported));
        if (!strstr(reported.diagnostics ? reported.diagnostics : reported.error,
                    cases[i].reported))
            fail_msg("%s%s", reported.diagnostics ? reported.diagnostics : "", reported.error);
        free(reported.diagnostics);
        material_pictures_close(pictures);
        gl_close(gl);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_alike),
        cmocka_unit_test(shapes_are_seen),
        cmocka_unit_test(pictures_do_not_mix),
        cmocka_unit_test(faults_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
