/* Autotune: known errors are found, times are plausible, the Pareto front has no dominated
 * point, and choices keep their stated errors. */
/* ctest: seconds=11 */
#include "tests/test.h"
#include "runtime/autotune/pareto.h"
#include "runtime/autotune/plot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Meter *open_meter(void)
{
    char error[4096];
    Meter *meter = meter_open(GL_KIND_osmesa, error, sizeof error);
    if (!meter)
        fail_msg("%s", error);
    return meter;
}

static MatcDocument *read_document(const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document = matc_read("test.yaml", text, strlen(text), &options);
    if (matc_material_count(document) != 1)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    return document;
}

static void list_material(const char *text, const MatcOptions *options, double seconds,
                          MeasuredList *list)
{
    Meter *meter = open_meter();
    MatcDocument *document = read_document(text);
    const AutotuneRequest request = {.document = document,
                                     .options = options,
                                     .open = variant_open(options),
                                     .range = measure_range,
                                     .seconds = seconds,
                                     .aliasing = true};
    if (!autotune_variants(meter, &request, list))
        fail_msg("%s", meter->error);
    matc_document_free(document);
    meter_close(meter);
}

static MatcOptions defaults(void)
{
    MatcOptions options;
    matc_options_init(&options);
    return options;
}

/* All options fixed to fast choices. */
static MatcOptions fastest(const char *layout)
{
    MatcOptions options = defaults();
    options.layout = layout;
    options.noise = "lattice";
    options.precision = "fast";
    options.aa = "none";
    options.derivatives = "finite";
    return options;
}

/* All combinations, each once, the given one first. */
static void variants_are_all_there(void **state)
{
    (void)state;
    int count, product = LAYOUT_COUNT;
    Variant base;
    MatcOptions options = defaults();
    assert_true(variant_of(&options, &base));
    VariantAxes open = variant_open(&options);
    Variant *list = variant_list(&base, &open, &count);
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        product *= axis_choices((Axis)axis);
    assert_int_equal(count, product);
    assert_int_equal(variant_distance(&list[0], &base), 0);
    for (int i = 1; i < count; i++) {
        Variant back;
        MatcOptions named = variant_options(&list[i], &options);
        assert_true(variant_of(&named, &back) && !variant_distance(&back, &list[i]));
        assert_true(variant_distance(&list[i - 1], &base) <= variant_distance(&list[i], &base));
        assert_true(variant_distance(&list[i], &base) > 0);
    }
    free(list);
    options.noise = "groimp";
    options.precision = "exact";
    open = variant_open(&options);
    assert_false(open.axis[AXIS_noise] || open.axis[AXIS_powers] || open.axis[AXIS_coordinates]);
    assert_true(open.axis[AXIS_aa] && open.layout);
    options.aa = "nonsense";
    assert_false(variant_of(&options, &base));
}

static void front_has_no_beaten_member(void **state)
{
    (void)state;
    FrontPoint points[] = {{1, 9, 0}, {2, 5, 0},   {2, 6, 0}, {3, 5, 0},
                           {4, 1, 0}, {5, NAN, 0}, {1, 9, 0}};
    /* equals do not beat each other */
    const bool wanted[] = {true, true, false, false, true, false, true};
    front_mark(points, 7);
    for (int i = 0; i < 7; i++)
        assert_int_equal(points[i].front, wanted[i]);
}

/* 0.3 in a half float is 2^-12 off at most, for drivers may cut; the emissive of the thesis has
 * steps of 1 / 127.5. */
static void known_errors_are_found(void **state)
{
    (void)state;
    MeasuredList list;
    MatcOptions options = defaults();
    options.layout = "thesis";
    list_material("material: Phong\ndiffuse: 0.3\nemissive: 0.5\n", &options, 2, &list);
    const Measured *m = &list.at[0];
    double half = ldexp(1, -12), step = 0.5 - floor(0.5 * 127.5) / 127.5;
    assert_int_equal(list.count, 1);
    assert_true(m->packed[SLOT_diffuse].maximum > 1e-6 && m->packed[SLOT_diffuse].maximum <= half);
    assert_float_equal(m->packed[SLOT_emissive].maximum, step, 1e-6);
    assert_float_equal(m->packed[SLOT_emissive].rms, step, 1e-6);
    assert_true(m->computed[SLOT_diffuse].maximum < 1e-7);
    assert_true(isnan(m->packed[SLOT_ior].maximum));
    assert_true(m->aliasing == 0);
    autotune_free(&list);
}

/* A checker near the horizon is aliased; noise takes time. */
static void aliasing_and_time_are_found(void **state)
{
    (void)state;
    MeasuredList list;
    MatcOptions options = fastest("thesis");
    list_material("material: Phong\ndiffuse: { map: Checker, color1: 1, color2: 0 }\n"
                  "emissive: { map: Granite }\n",
                  &options, 2, &list);
    assert_int_equal(list.count, 1);
    assert_true(list.at[0].aliased[SLOT_diffuse].rms > 0.05 &&
                list.at[0].aliased[SLOT_diffuse].rms < 0.4);
    assert_true(list.at[0].nanoseconds > 0 && list.constant > 0);
    assert_true(list.at[0].front);
    assert_true(list.at[0].error < 0.05); /* not far from the reference */
    autotune_free(&list);
}

static int count_fields(const char *line)
{
    int fields = 1;
    bool quoted = false;
    for (; *line && *line != '\n'; line++) {
        quoted ^= *line == '"';
        fields += *line == ',' && !quoted;
    }
    return fields;
}

static void tables_are_well_formed(void **state)
{
    (void)state;
    MeasuredList list;
    MatcOptions options = defaults();
    Meter *meter = open_meter();
    list_material("material: Phong\ndiffuse: 0.3\n", &options, 1, &list);
    char *csv = autotune_csv(&list, "a \"name\", quoted", meter->gl, true),
         *svg = pareto_svg(&list, "<&>", meter->gl);
    int lines = 0, fields = count_fields(csv);
    for (const char *line = csv; *line; line = strchr(line, '\n') + 1, lines++)
        assert_int_equal(count_fields(line), fields);
    assert_int_equal(lines, list.count + 1);
    assert_non_null(strstr(csv, "\n\"a \"\"name\"\", quoted\",osmesa,"));
    assert_non_null(strstr(svg, "&lt;&amp;&gt;"));
    assert_string_equal(svg + strlen(svg) - 7, "</svg>\n");
    assert_null(strstr(svg, "nan"));
    free(csv);
    free(svg);
    autotune_free(&list);
    meter_close(meter);
}

static void choice_keeps_the_promise(void **state)
{
    (void)state;
    ParetoChoice answer = {0};
    MatcDocument *document = read_document("material: Phong\ndiffuse: 0.3\nemissive: 0.5\n");
    const ParetoSubject subject = {
        .document = document, .gl = GL_KIND_osmesa, .range = measure_range};
    MatcOptions options = defaults();
    assert_true(pareto_choose(&subject, 0.1, &options, &answer));
    assert_non_null(strstr(answer.text, "chosen: "));
    assert_non_null(options.layout);
    free(answer.text);
    options = defaults();
    options.layout = "thesis"; /* its pairs are not that exact */
    assert_false(pareto_choose(&subject, 1e-3, &options, &answer));
    assert_non_null(strstr(answer.error, "no choice keeps every slot within 0.001"));
    matc_document_free(document);
}

/* Far from the origin, where floats of the coordinate are a thousandth apart, its parts are not. */
static void long_coordinates_lose_nothing(void **state)
{
    (void)state;
    const char *far = "material: Phong\ndiffuse: { map: Checker, input: { map: UVTransform, "
                      "offsetU: -12345.678, scaleV: 3.3 } }\n"
                      "emissive: { map: Granite, input: { map: XYZTransform, transform: { "
                      "translation: [5000.1, 70.7, 9.3], "
                      "scale: [1.7, 1.1, 1.3] } } }\n";
    MeasuredList plain, parts;
    MatcOptions options = fastest("integer");
    list_material(far, &options, 1, &plain);
    options.coordinates = "long";
    list_material(far, &options, 1, &parts);
    assert_int_equal(plain.count + parts.count, 2);
    assert_true(plain.at[0].computed[SLOT_emissive].maximum > 1e-3);
    assert_true(parts.at[0].computed[SLOT_diffuse].maximum < 1e-6);
    assert_true(parts.at[0].computed[SLOT_emissive].maximum < 2e-6);
    autotune_free(&plain);
    autotune_free(&parts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(variants_are_all_there),
        cmocka_unit_test(front_has_no_beaten_member),
        cmocka_unit_test(known_errors_are_found),
        cmocka_unit_test(aliasing_and_time_are_found),
        cmocka_unit_test(tables_are_well_formed),
        cmocka_unit_test(choice_keeps_the_promise),
        cmocka_unit_test(long_coordinates_lose_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
