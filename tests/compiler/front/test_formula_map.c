/* A map that a formula reads by name has all of its components, with the map's values. */
#include "tests/slot_values.h"
#include "grammar/tables.h"

enum { LONGEST = 4096 };

/* -- how many components there are: as many as the widest of what a map is made of, written by hand
 * from language.md */

static const struct {
    const char *map;
    int components;
} widths[] = {
    {"{ map: Combine, r: .1, g: .2, b: .3 }", 3},
    {"{ map: Separate, input: red }", 1},
    {"{ map: Separate, channel: a, input: '#ff00ff80' }", 1},
    {"{ map: Mix }", 1},
    {"{ map: Mix, a: 0, b: [1, .5, .2] }", 3},
    {"{ map: Mix, a: [1, .5], amount: '= [1, 0, 0]' }", 3}, /* two components and one number */
    {"{ map: Mix, a: 1, b: 0, amount: '= [1, 0, 0]' }", 1},
    {"{ map: Add, a: .5, b: red }", 3},
    {"{ map: Multiply, b: '#ff00ff80' }", 4},
    {"{ map: Remap, input: '= uv' }", 2},
    {"{ map: Contrast, input: '= u' }", 1},
    {"{ map: Clamp, input: '#ff00ff80' }", 4},
    {"{ map: Power, input: red }", 3},
    {"{ map: HSV, input: red }", 3},
    {"{ map: Switch, which: 1, maps: [1, red] }", 3},
    {"{ map: Switch, which: '= [1, 0, 0]', maps: [1, 0] }", 1},
    {"{ map: Switch }", 1},
    {"{ map: Ramp }", 1},
    {"{ map: Ramp, a: red }", 3},
    {"{ map: CornerRamp }", 1},
    {"{ map: CornerRamp, topLeft: red }", 3},
    {"{ map: Triplanar, z: { map: Checker } }", 1},
    {"{ map: Triplanar, x: 1, z: red }", 3},
    {"{ map: Smooth3D, input: '= u' }", 1},
    {"{ map: Checker }", 1},
    {"{ map: VolumeChecker, color2: red }", 3},
    {"{ map: Blend, blend: [{ input: 1 }, { value: 1, input: red }] }", 3},
    {"{ map: Blend, input: '= uv' }", 2},
    {"{ map: Blend, input: '= uv', blend: [{ input: 1 }] }", 1},
    {"{ map: Cells }", 1},
    {"{ map: Granite }", 1},
    {"{ map: Noise }", 1},
    {"{ map: UVTransform, input: '= u' }", 1},
    {"{ map: XYZTransform }", 3},
    {"{ map: ImageMap }", 3},
    {"{ map: ImageMap, channel: g }", 1},
    {"'#ff00ff80'", 4},
    {"{ map: RGBColor }", 3},
    {"{ map: Graytone }", 1},
};

/* With numbers that fill it up from so many components, vec4 takes the map. */
static bool fills_four(const char *map, int components)
{
    static const char *const rest[] = {"", ", u, u, u", ", u, u", ", u", ""};
    char text[LONGEST];
    snprintf(
        text, sizeof text,
        "material: Phong\ndiffuse: { map: Expression, is: \"vec4(c%s).x\", with: { c: %s } }\n",
        rest[components], map);
    const MatcOptions options = quick();
    MatcDocument *document = read_text(text, &options);
    const bool fills = !matc_error_count(document);
    matc_document_free(document);
    return fills;
}

static void a_map_has_the_components_of_its_widest(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++)
        for (int components = 1; components <= 4; components++) {
            const bool alone =
                components == 4 && widths[i].components == 1; /* one number makes four, too */
            if (fills_four(widths[i].map, components) !=
                (components == widths[i].components || alone))
                fail_msg("%s: not %d lanes", widths[i].map, widths[i].components);
        }
}

/* -- the formula that is a map's name is the map */

/* The lines of a map as those of `with: { c: }`. */
static void put_below(char *text, const char *lines)
{
    strcat(text, "  map: Expression\n  is: c\n  with:\n    c:\n");
    for (const char *end; *lines; lines = end + 1) {
        end = strchr(lines, '\n');
        if (!end)
            fail_msg("an example ends within a line: %s", lines);
        strcat(text, "    ");
        strncat(text, lines, (size_t)(end - lines) + 1);
    }
}

static int differences(const char *plain, const char *formula, const char *name)
{
    static const char *const points[] = {
        "u=.3 v=.4 x=.1 y=.2 z=.7", "u=.81 v=.13 x=-1.3 y=.9 z=2.4",
        "u=-.4 v=2.7 x=3.1 y=-.6 z=-.2 nx=.6 ny=0 nz=.8 dpxdu=.8 dpydu=0 dpzdu=-.6"};
    int count = 0;
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
        double want[3] = {0}, got[3] = {1};
        char *values = values_at(plain, points[i], NULL),
             *others = values_at(formula, points[i], NULL);
        assert_int_equal(read_slot(values, "diffuse", want), 3);
        assert_int_equal(read_slot(others, "diffuse", got), 3);
        for (int k = 0; k < 3; k++)
            if (!(fabs(got[k] - want[k]) <= 1e-9 * (1 + fabs(want[k])))) {
                print_error("%s at %s: %g as a map, %g as a formula of it\n", name, points[i],
                            want[k], got[k]);
                count++;
            }
        free(values), free(others);
    }
    return count;
}

static void its_name_is_all_of_it(void **state)
{
    (void)state;
    static const char head[] = "material: Phong\ndiffuse:\n";
    int wrong = 0, tried = 0;
    char text[LONGEST];
    for (int i = 0; i < KIND_COUNT; i++) {
        const char *example = kind_table[i].example;
        if (kind_table[i].lowering == LOWERING_MATERIAL || !example ||
            strncmp(example, head, strlen(head)) || strstr(example, "image:"))
            continue;
        assert_true(strlen(example) < LONGEST / 3);
        strcpy(text, head);
        put_below(text, example + strlen(head));
        wrong += differences(example, text, kind_table[i].name);
        tried++;
    }
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        char plain[LONGEST];
        snprintf(plain, sizeof plain, "material: Phong\ndiffuse: %s\n", widths[i].map);
        snprintf(text, sizeof text,
                 "material: Phong\ndiffuse: { map: Expression, is: c, with: { c: %s } }\n",
                 widths[i].map);
        wrong += differences(plain, text, widths[i].map);
    }
    print_message("%d maps' examples\n", tried);
    assert_true(tried > 15);
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_map_has_the_components_of_its_widest),
        cmocka_unit_test(its_name_is_all_of_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
