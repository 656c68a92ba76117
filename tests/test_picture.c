/* Pictures: the same material through every layout. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "grammar/tables.h"
#include "runtime/view/picture.h"
#include <stdlib.h>

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
        char error[1024], *diagnostics;
        PictureOptions options = {.compile = compile,
                                  .view = {.width = 96,
                                           .height = 96,
                                           .supersampling = 2,
                                           .screen_text = view_text_screen,
                                           .light_text = view_text_light}};
        double sum = 0;
        int greatest = 0;
        options.compile.layout = layout_table[layout].name;
        if (!picture_draw(document, 0, &options, layout ? picture : first, &diagnostics, error, sizeof error))
            fail_msg("%s%s", diagnostics, error);
        free(diagnostics);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
