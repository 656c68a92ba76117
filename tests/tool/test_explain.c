/* The example of every map and material that --explain shows: it compiles without messages, and
 * its picture is neither black nor flat. A small sphere is drawn, and judged in its middle,
 * where lighting varies little. */
/* ctest: seconds=12 */
#include "tests/test.h"
#include "grammar/tables.h"
#include "tests/preview.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 48, FROM = 12, TO = 36 };

/* Brightness of the pixels in the center, as shares of white. */
typedef struct {
    double mean, deviation;
} Look;

/* Text below "Example", without its indentation. From malloc. */
static char *example_of(const char *name)
{
    char *page = matc_explain(name), *text = NULL;
    size_t size;
    assert_non_null(page);
    const char *at = strstr(page, "\nExample\n  ");
    assert_non_null(at);
    FILE *out = open_memstream(&text, &size);
    for (at += strlen("\nExample\n"); !strncmp(at, "  ", 2); at += strcspn(at, "\n") + 1)
        fprintf(out, "%.*s\n", (int)strcspn(at + 2, "\n"), at + 2);
    fclose(out);
    free(page);
    return text;
}

static Look look_at(const unsigned char *rgb)
{
    Look look = {0, 0};
    double squares = 0;
    const int count = (TO - FROM) * (TO - FROM) * 3;
    for (int y = FROM; y < TO; y++)
        for (int x = FROM * 3; x < TO * 3; x++) {
            double value = rgb[y * SIDE * 3 + x] / 255.0;
            look.mean += value / count;
            squares += value * value / count;
        }
    look.deviation = sqrt(fmax(0, squares - look.mean * look.mean));
    return look;
}

static Look look_of(const char *text, bool sky)
{
    static unsigned char rgb[SIDE * SIDE * 3];
    MatcOptions compile;
    matc_options_init(&compile);
    compile.pixels = true;
    compile.pass = sky ? "sky" : NULL;
    MatcDocument *document = matc_read("examples/example.yaml", text, strlen(text), &compile);
    assert_string_equal(matc_diagnostics(document, MATC_TEXT), "");
    const MaterialPictureOptions options = {.pictures = {.renderer = {.compile = &compile}},
                                            .preview = {.width = SIDE, .height = SIDE, .sky = sky}};
    draw_pixels(document, &options, rgb);
    matc_document_free(document);
    return look_at(rgb);
}

static void examples_show_something(void **state)
{
    static const double black = 8 / 255.0, flat = 8 / 255.0;
    (void)state;
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        char *text = example_of(kind_table[kind].name);
        const Look look = look_of(text, !strcmp(kind_table[kind].name, "SunSkyLight"));
        print_message("%-16s mean %.3f deviation %.3f\n", kind_table[kind].name, look.mean,
                      look.deviation);
        assert_true(look.mean > black);
        assert_true(look.deviation > flat);
        free(text);
    }
}

/* The judge sees black. Its warning reports what is flat under the light: a transformer
 * alone. */
static void nothing_is_seen(void **state)
{
    (void)state;
    const Look none = look_of("material: Phong\ndiffuse: 0\n", false),
               grey = look_of("material: Phong\n", false);
    assert_true(none.mean < 8 / 255.0 && none.deviation < 8 / 255.0);
    assert_true(grey.mean > 0.3);
}

/* Keys are no maps: their examples are documents of which nothing is said, and that have the
 * key. */
static void examples_of_keys_are_documents(void **state)
{
    (void)state;
    static const char *const keys[] = {
#define KEY(name, where, doc, example) #name,
#include "grammar/keys.def"
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        char *text = example_of(keys[i]);
        MatcDocument *document = matc_read("example.yaml", text, strlen(text), NULL);
        if (!strstr(text, keys[i]) || *matc_diagnostics(document, MATC_TEXT))
            fail_msg("%s\n%s", text, matc_diagnostics(document, MATC_TEXT));
        assert_true(matc_material_count(document) > 0);
        matc_document_free(document);
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(examples_show_something),
                                       cmocka_unit_test(nothing_is_seen),
                                       cmocka_unit_test(examples_of_keys_are_documents)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
