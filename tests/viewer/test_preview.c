/* The preview's pictures against their definition: a sphere in its lights by the Phong shading
 * of semantics.md 4.1, every slot. */
/* ctest: seconds=14 */
#include "tests/test.h"
#include "grammar/tables.h"
#include "runtime/viewer/slot.h"
#include "tests/preview.h"
#include <stdio.h>

/* The preview's room: lights in the eye's space, and light from all around. */
static const Vector light_direction[] = {
    {{-.4968, .6211, .6062}}, {{.8729, .0970, .4783}}, {{.3651, .5477, -.7528}}};
static const Vector light_color[] = {{{.88, .84, .77}}, {{.15, .19, .25}}, {{.42, .45, .5}}};
static const Vector above = {{.42, .44, .48}}, below = {{.11, .104, .098}};

/* A gray Phong without transparency: what it sends to the eye from where its normal is n, seen
 * along `ray`. */
typedef struct {
    double diffuse, specular, exponent, ambient, emissive;
} Phong;

static double step_smoothly(double low, double high, double x)
{
    double t = fmin(fmax((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

static double shade(const Phong *m, const View *view, Vector n, Vector ray, int component)
{
    Vector reflected = added(ray, scaled(n, -2 * dot(ray, n)));
    double up = .5 + .5 * n.at[2], mirror = step_smoothly(-.3, .5, reflected.at[2]);
    double around = below.at[component] * (1 - up) + above.at[component] * up;
    double mirrored = .6 * below.at[component] * (1 - mirror) + above.at[component] * mirror;
    double sum = m->emissive + (m->diffuse + m->ambient) * around + m->specular * mirrored;
    for (int i = 0; i < 3; i++) {
        Vector e = light_direction[i];
        Vector l = unit(added(added(scaled(view->right, e.at[0]), scaled(view->up, e.at[1])),
                              scaled(view->back, e.at[2])));
        double lobe = pow(fmax(dot(reflected, l), 0), m->exponent);
        sum +=
            (m->diffuse + m->specular * lobe) * fmax(dot(n, l), 0) * light_color[i].at[component];
    }
    return sum;
}

/* The tone curve: linear to 0.7, then bent. */
static double tone(double c)
{
    double over = fmax(c - .7, 0) / .3;
    return fmin(c, .7) + .3 * over / (1 + over);
}

/* The unit sphere; false: beside it, or within a pixel of its rim, where the mesh has corners. */
static bool meet_sphere(const View *view, Vector ray, Vector *normal)
{
    double middle = -dot(view->position, ray);
    double square = dot(view->position, view->position) - middle * middle;
    if (square > .97)
        return false;
    *normal = added(view->position, scaled(ray, middle - sqrt(1 - square)));
    return true;
}

static void spheres_are_lit(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        Phong phong;
    } cases[] = {
        {"{ material: Phong, diffuse: 0, specular: 0.5 }", {0, .5, 4, 0, 0}},
        {"{ material: Phong, diffuse: 0, specular: 0.5, shininess: 0.1 }", {0, .5, 1.204, 0, 0}},
        {"{ material: Phong, diffuse: 0, specular: 0.5, shininess: 0.75 }", {0, .5, 30.989, 0, 0}},
        {"{ material: Phong, diffuse: 0, specular: 0.8, shininess: 0.9 }", {0, .8, 198.997, 0, 0}},
        {"{ material: Phong, diffuse: 0.6 }", {.6, 0, 4, 0, 0}},
        {"{ material: Phong, diffuse: 0, ambient: 0.9, emissive: 0.1 }", {0, 0, 4, .9, .1}},
    };
    enum { SIDE = 96 };
    const double most = 1; /* a byte */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Drawn p = draw(cases[i].text, "gbuffer", SIDE, SIDE);
        Vector back = from_angles(-112 * RADIANS, 22 * RADIANS);
        View view = look(scaled(back, 4.55), back, 15 * RADIANS, SIDE, SIDE);
        double worst = 0;
        int seen = 0;
        for (int k = 0; k < SIDE * SIDE * 3; k++) {
            Vector normal, ray = ray_of(&view, k / 3 % SIDE, k / 3 / SIDE);
            if (!meet_sphere(&view, ray, &normal))
                continue;
            double want = byte_of(tone(shade(&cases[i].phong, &view, normal, ray, k % 3)));
            worst = fmax(worst, fabs(p.rgb[k] - want));
            seen++;
        }
        print_message("%s: %d values, within %.2f of 255, at most %.1f\n", cases[i].text, seen,
                      worst, most);
        assert_true(seen > SIDE * SIDE && worst <= most);
        discard(&p);
    }
}

/* Radiance that a mirror reflects: the squares that stand for the lamps, 4 away, which light a
 * surface facing them as much (a square's published form factor), before the horizon's light. -1:
 * near an edge. */
static double mirrored(const View *view, Vector at, Vector way, int component)
{
    static const double halves[] = {3.2, 3.2, 2.4};
    const double mirror = step_smoothly(-.3, .5, way.at[2]);
    double sum = .6 * below.at[component] * (1 - mirror) + above.at[component] * mirror;
    for (int i = 0; i < 3; i++) {
        const double *e = light_direction[i].at;
        const Vector to = unit(added(added(scaled(view->right, e[0]), scaled(view->up, e[1])),
                                     scaled(view->back, e[2])));
        const Vector high = unit(added(view->up, scaled(to, -dot(view->up, to)))),
                     wide = cross(to, high);
        const double along = (4 - dot(at, to)) / dot(way, to),
                     s = halves[i] / sqrt(halves[i] * halves[i] + 16);
        const Vector met = added(at, scaled(way, along));
        const double off = fmax(fabs(dot(met, high)), fabs(dot(met, wide))) / halves[i];
        if (dot(way, to) <= 0 || off > 1.2)
            continue;
        if (off > .8)
            return -1;
        sum += light_color[i].at[component] / (4 / M_PI * s * atan(s));
    }
    return sum;
}

/* Polished metal shows what stands around it, within a byte. */
static void mirrors_show_the_room(void **state)
{
    (void)state;
    enum { SIDE = 96 };
    Drawn p = draw("{ material: Principled, metalness: 1, baseColor: 1, roughness: 0 }", "gbuffer",
                   SIDE, SIDE);
    const Vector back = from_angles(-112 * RADIANS, 22 * RADIANS);
    const View view = look(scaled(back, 4.55), back, 15 * RADIANS, SIDE, SIDE);
    double worst = 0;
    int squares = 0, horizon = 0;
    for (int k = 0; k < SIDE * SIDE * 3; k++) {
        Vector normal, ray = ray_of(&view, k / 3 % SIDE, k / 3 / SIDE);
        if (!meet_sphere(&view, ray, &normal) || dot(normal, ray) > -.3)
            continue;
        const double want =
            mirrored(&view, normal, added(ray, scaled(normal, -2 * dot(ray, normal))), k % 3);
        if (want < 0)
            continue;
        worst = fmax(worst, fabs(p.rgb[k] - byte_of(tone(want))));
        squares += want > .5;
        horizon += want <= .5;
    }
    print_message("%d values of squares, %d of the horizon, within %.1f of 255\n", squares, horizon,
                  worst);
    assert_true(squares > 1000 && horizon > 4000 && worst <= 1);
    discard(&p);
}

/* A surface that only sends out light has the color that its document says, byte for byte:
 * decoded, drawn and encoded again. The preview bends what is brighter than 0.7, which is byte
 * 218. */
static void srgb_bytes_come_back(void **state)
{
    (void)state;
    enum { SIDE = 16 };
    static const int bytes[] = {0, 1, 9, 10, 11, 12, 64, 127, 128, 129, 188, 217};
    for (size_t i = 0; i < sizeof bytes / sizeof *bytes; i++) {
        const int red = bytes[i], green = 217 - red;
        char text[128];
        snprintf(text, sizeof text,
                 "{ colors: srgb, material: Phong, diffuse: 0, emissive: '#%02x%02x80' }", red,
                 green);
        Drawn p = draw(text, "gbuffer", SIDE, SIDE);
        const unsigned char *middle = p.rgb + 3 * (SIDE / 2 * SIDE + SIDE / 2);
        assert_int_equal(middle[0], red);
        assert_int_equal(middle[1], green);
        assert_int_equal(middle[2], 128);
        discard(&p);
    }
}

/* Every slot of a plain material, in the middle of the picture: what it was given, as a byte. */
static void slots_are_shown(void **state)
{
    (void)state;
    static const struct {
        const char *slot, *text;
        double bytes[3];
    } cases[] = {
        {"diffuse", "diffuse: [0.5, 0.2, 0]", {187.5, 123.6, 0}}, /* of the sRGB curve */
        {"alpha", "diffuse: [1, 1, 1, 0.25]", {63.75, 63.75, 63.75}},
        {"specular", "specular: [0.5, 0.2, 1]", {187.5, 123.6, 255}},
        /* an exponent of 30.99: 255 log2(30.99) / 16 */
        {"shininess", "shininess: 0.75", {78.9, 78.9, 78.9}},
        {"transparency", "transparency: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"transparencyShininess", "transparencyShininess: 0.75", {78.9, 78.9, 78.9}},
        {"interpolatedTransparency", "interpolatedTransparency: false", {0, 0, 0}},
        {"diffuseTransparency", "diffuseTransparency: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"ambient", "ambient: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"emissive", "emissive: [0.5, 0.2, 4]", {187.5, 123.6, 255}},
        {"ior", "{}", {0, 0, 0}},
        {"normal", "{}", {127.5, 127.5, 255}}, /* it faces the eye */
        {"metalness", "{ material: Principled, metalness: 0.25 }", {63.75, 63.75, 63.75}},
        {"roughness", "{ material: Principled, roughness: 0.75 }", {191.25, 191.25, 191.25}},
        /* ((3 - 1) / (3 + 1))^2 */
        {"reflectance", "{ material: Principled, ior: 3 }", {63.75, 63.75, 63.75}},
        {"coat", "{ material: Principled, coat: 0.25 }", {63.75, 63.75, 63.75}},
        {"coatTint",
         "{ material: Principled, coat: 1, coatDarkening: 0, coatColor: [0.5, 0.2, 0] }",
         {187.5, 123.6, 0}},
        {"coatRoughness",
         "{ material: Principled, coat: 1, coatRoughness: 0.75 }",
         {191.25, 191.25, 191.25}},
        {"coatReflectance", "{ material: Principled, coat: 1, coatIor: 3 }", {63.75, 63.75, 63.75}},
        {"fuzz", "{ material: Principled, fuzz: 0.25 }", {63.75, 63.75, 63.75}},
        {"fuzzColor",
         "{ material: Principled, fuzz: 1, fuzzColor: [0.5, 0.2, 0] }",
         {187.5, 123.6, 0}},
        {"fuzzRoughness",
         "{ material: Principled, fuzz: 1, fuzzRoughness: 0.75 }",
         {191.25, 191.25, 191.25}},
        /* along the horizon, where the eye's x is */
        {"anisotropy", "{ material: Principled, anisotropy: 0.5 }", {191.25, 127.5, 127.5}},
        {"transmission", "{ material: Principled, transmission: 0.75 }", {191.25, 191.25, 191.25}},
        {"film", "{ material: Principled, film: 0.75 }", {191.25, 191.25, 191.25}},
        /* 2.5 of 5 micrometers */
        {"filmPath",
         "{ material: Principled, film: 1, filmThickness: 0.625, filmIor: 2 }",
         {127.5, 127.5, 127.5}},
        {"filmIor", "{ material: Principled, film: 1, filmIor: 1.5 }", {127.5, 127.5, 127.5}},
        {"diffuseRoughness",
         "{ material: Principled, diffuseRoughness: 0.25 }",
         {63.75, 63.75, 63.75}},
        /* as smooth as the sphere */
        {"coatNormal",
         "{ material: Principled, coat: 1, input: { map: BumpMap } }",
         {127.5, 127.5, 255}},
        {"model", "{ material: Principled }", {255, 255, 255}},
        {"model", "{}", {0, 0, 0}},
    };
    enum { SIDE = 65, MIDDLE = (SIDE / 2 * SIDE + SIDE / 2) * 3 };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[128];
        const char *given = cases[i].text;
        const bool whole = !strncmp(given, "{ material", 10), plain = !strcmp(given, "{}");
        snprintf(text, sizeof text, whole ? "%s%s" : "{ material: Phong%s%s }",
                 whole || plain ? "" : ", ", plain ? "" : given);
        Drawn p = draw_slot(text, "gbuffer", cases[i].slot, SIDE, SIDE);
        for (int component = 0; component < 3; component++)
            if (fabs(p.rgb[MIDDLE + component] - cases[i].bytes[component]) > 1.5)
                fail_msg("%s.%d: %d, not %g", cases[i].slot, component, p.rgb[MIDDLE + component],
                         cases[i].bytes[component]);
        assert_int_equal(p.rgb[0], p.rgb[2]); /* beside the sphere */
        assert_true(p.rgb[0] < 45);
        discard(&p);
    }
    assert_int_equal(sizeof cases / sizeof *cases, SLOT_COUNT + 1); /* `model` twice */
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        assert_non_null(slot_look_find(slot_table[slot].name));
}

/* The light and the slot normal stand in eye space, whichever space the G-buffer's normals are
 * in. */
static void normals_of_the_world_look_alike(void **state)
{
    (void)state;
    static const char text[] =
        "{ material: Phong, diffuse: 0.5, specular: 0.5, input: { map: WaveMap, amplitude: 0.1 } }";
    static const char *const slots[] = {NULL, "normal"};
    enum { SIDE = 48, BYTES = SIDE * SIDE * 3 };
    for (int i = 0; i < 2; i++) {
        Drawn eye = draw_subject(&(Subject){text, "gbuffer", "eye", slots[i]}, SIDE, SIDE);
        Drawn world = draw_subject(&(Subject){text, "gbuffer", "world", slots[i]}, SIDE, SIDE);
        int most = 0, bright = 0;
        for (int k = 0; k < BYTES; k++) {
            most = abs(eye.rgb[k] - world.rgb[k]) > most ? abs(eye.rgb[k] - world.rgb[k]) : most;
            bright += world.rgb[k] > 100;
        }
        print_message("at most %d of 255 apart, %d bytes are bright\n", most, bright);
        assert_true(most <= 1 && bright > BYTES / 20);
        discard(&eye);
        discard(&world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spheres_are_lit),
        cmocka_unit_test(mirrors_show_the_room),
        cmocka_unit_test(srgb_bytes_come_back),
        cmocka_unit_test(slots_are_shown),
        cmocka_unit_test(normals_of_the_world_look_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
