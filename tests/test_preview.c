/* The preview's pictures against what they should show: a sphere in its lights by the Phong shading of semantics.md 4.1, a sky by the C
 * reference in directions from the camera's definition. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/matc.h"
#include "grammar/tables.h"
#include "runtime/view/picture.h"
#include "runtime/view/slot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

extern const char view_text_screen[], view_text_light[], view_text_slot[];

#define RADIANS (M_PI / 180)
typedef struct {
    double at[3];
} Vector;

static double dot(Vector a, Vector b) { return a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2]; }
static Vector scaled(Vector a, double factor)
{
    return (Vector){{a.at[0] * factor, a.at[1] * factor, a.at[2] * factor}};
}
static Vector added(Vector a, Vector b) { return (Vector){{a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2]}}; }
static Vector unit(Vector a) { return scaled(a, 1 / sqrt(dot(a, a))); }

static Vector cross(Vector a, Vector b)
{
    const double *p = a.at, *q = b.at;
    return (Vector){{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}};
}

static Vector from_angles(double azimuth, double elevation)
{
    return (Vector){{cos(azimuth) * cos(elevation), sin(azimuth) * cos(elevation), sin(elevation)}};
}

/* Where the camera stands, and its axes in the world: to the right, up, towards the viewer. The world's z is up. */
typedef struct {
    Vector position, right, up, back;
    double tangent; /* of half the angle of the shorter side */
    int width, height;
} View;

static View look(Vector position, Vector back, double half_angle, int width, int height)
{
    View view = {.position = position, .back = back, .tangent = tan(half_angle), .width = width, .height = height};
    view.right = unit(cross((Vector){{0, 0, 1}}, back));
    view.up = cross(back, view.right);
    return view;
}

/* Through the middle of a pixel; row 0 is the lowest. */
static Vector ray_of(const View *view, int x, int y)
{
    int shorter = view->width < view->height ? view->width : view->height;
    double right = (2 * x + 1 - view->width) * view->tangent / shorter;
    double up = (2 * y + 1 - view->height) * view->tangent / shorter;
    return unit(added(added(scaled(view->right, right), scaled(view->up, up)), scaled(view->back, -1)));
}

/* A linear value as matview writes it. */
static double byte_of(double linear)
{
    double c = fmin(fmax(linear, 0), 1);
    return 255 * (c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055);
}

typedef struct {
    MatcDocument *document;
    MatcOptions options;
    View view;
    unsigned char *rgb;
} Preview;

/* A sample a pixel, in its middle. */
/* Of which material, as what. */
typedef struct {
    const char *text, *pass, *normals, *slot;
} Subject;

static Preview draw_subject(const Subject *subject, int width, int height)
{
    const char *text = subject->text;
    Preview p = {.rgb = malloc((size_t)width * (size_t)height * 3)};
    Picture drawn = {.rgb = p.rgb};
    matc_options_init(&p.options);
    p.options.pass = subject->pass;
    p.options.layout = "integer";
    p.options.normals = subject->normals;
    p.document = matc_read("preview.yaml", text, strlen(text), &p.options);
    assert_int_equal(matc_material_count(p.document), 1);
    const PictureOptions options = {.compile = p.options,
                                    .view = {.shape = SHAPE_sphere,
                                             .width = width,
                                             .height = height,
                                             .supersampling = 1,
                                             .screen_text = view_text_screen,
                                             .light_text = view_text_light,
                                             .slot_text = view_text_slot,
                                             .slot = subject->slot,
                                             .sky = !strcmp(subject->pass, "sky")}};
    if (!picture_draw(p.document, 0, &options, &drawn))
        fail_msg("%s%s", drawn.diagnostics, drawn.error);
    free(drawn.diagnostics);
    return p;
}

static Preview draw_slot(const char *text, const char *pass, const char *slot, int width, int height)
{
    return draw_subject(&(Subject){text, pass, NULL, slot}, width, height);
}

static Preview draw(const char *text, const char *pass, int width, int height)
{
    return draw_slot(text, pass, NULL, width, height);
}

static void discard(Preview *p)
{
    matc_document_free(p->document);
    free(p->rgb);
}

/* The preview's room, as light.glsl describes it: lights in the eye's space, and light from all around. */
static const Vector light_direction[] = {{{-.4968, .6211, .6062}}, {{.8729, .0970, .4783}}, {{.3651, .5477, -.7528}}};
static const Vector light_color[] = {{{1.04, .99, .91}}, {{.17, .21, .27}}, {{.42, .45, .5}}};
static const Vector above = {{.175, .185, .205}}, below = {{.062, .057, .053}};

/* A grey Phong without transparency: what it sends to the eye from where its normal is n, seen along `ray`. */
typedef struct {
    double diffuse, specular, exponent, ambient, emissive;
} Phong;

static double step_smoothly(double low, double high, double x)
{
    double t = fmin(fmax((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

static double shade(const Phong *m, const View *view, Vector n, Vector ray, int lane)
{
    Vector reflected = added(ray, scaled(n, -2 * dot(ray, n)));
    double up = .5 + .5 * n.at[2], mirror = step_smoothly(-.3, .5, reflected.at[2]);
    double around = below.at[lane] * (1 - up) + above.at[lane] * up;
    double mirrored = .6 * below.at[lane] * (1 - mirror) + above.at[lane] * mirror;
    double sum = m->emissive + (m->diffuse + m->ambient) * around + m->specular * mirrored;
    for (int i = 0; i < 3; i++) {
        Vector e = light_direction[i];
        Vector l = added(added(scaled(view->right, e.at[0]), scaled(view->up, e.at[1])), scaled(view->back, e.at[2]));
        double lobe = pow(fmax(dot(reflected, l), 0), m->exponent);
        sum += (m->diffuse + m->specular * lobe) * fmax(dot(n, l), 0) * light_color[i].at[lane];
    }
    return sum;
}

/* Straight to 0.7, then bent. */
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
        Preview p = draw(cases[i].text, "gbuffer", SIDE, SIDE);
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
        print_message("%s: %d values, within %.2f of 255, at most %.1f\n", cases[i].text, seen, worst, most);
        assert_true(seen > SIDE * SIDE && worst <= most);
        discard(&p);
    }
}

/* A surface that only sends out light has the colour that its document says, byte for byte: decoded, drawn and encoded again. The
 * preview bends what is brighter than 0.7, which is byte 218. */
static void srgb_bytes_come_back(void **state)
{
    (void)state;
    enum { SIDE = 16 };
    static const int bytes[] = {0, 1, 9, 10, 11, 12, 64, 127, 128, 129, 188, 217};
    for (size_t i = 0; i < sizeof bytes / sizeof *bytes; i++) {
        const int red = bytes[i], green = 217 - red;
        char text[128];
        snprintf(text, sizeof text, "{ colors: srgb, material: Phong, diffuse: 0, emissive: '#%02x%02x80' }", red,
                 green);
        Preview p = draw(text, "gbuffer", SIDE, SIDE);
        const unsigned char *middle = p.rgb + 3 * (SIDE / 2 * SIDE + SIDE / 2);
        assert_int_equal(middle[0], red);
        assert_int_equal(middle[1], green);
        assert_int_equal(middle[2], 128);
        discard(&p);
    }
}

/* A sky's own brightness by the C reference, exposed as the preview does. */
static void want_sky(const Preview *p, Vector ray, double want[3])
{
    char point[128];
    const char *fault;
    snprintf(point, sizeof point, "x=%.9f y=%.9f z=%.9f", ray.at[0], ray.at[1], ray.at[2]);
    char *values = matc_eval(p->document, 0, point, &p->options, &fault);
    const char *line = values ? strstr(values, "\nemissive ") : NULL;
    assert_non_null(line);
    assert_int_equal(sscanf(line, " emissive %lf %lf %lf", &want[0], &want[1], &want[2]), 3);
    free(values);
    double most = fmax(fmax(want[0], want[1]), fmax(want[2], 1e-6));
    for (int lane = 0; lane < 3; lane++)
        want[lane] = byte_of(want[lane] * (1 - exp(-.9 * most)) / most);
}

/* The camera of the sky stands at the origin and looks 41 degrees up, towards the sun as far as steps of 5 degrees let it. */
static View sky_view(Vector sun, int width, int height)
{
    double step = 5 * RADIANS, azimuth = step * round(atan2(sun.at[1], sun.at[0]) / step);
    return look((Vector){{0, 0, 0}}, scaled(from_angles(azimuth, 41 * RADIANS), -1), 45 * RADIANS, width, height);
}

/* What is near the horizon jumps to black. */
static const double horizon = .01;

static void compare_sky(const Preview *p, const View *view)
{
    double worst = 0;
    int ground = 0;
    for (int i = 0; i < view->width * view->height; i++) {
        Vector ray = ray_of(view, i % view->width, i / view->width);
        double want[3];
        if (fabs(ray.at[2]) < horizon)
            continue;
        want_sky(p, ray, want);
        for (int lane = 0; lane < 3; lane++)
            worst = fmax(worst, fabs(p->rgb[3 * i + lane] - want[lane]));
        ground += want[0] + want[1] + want[2] == 0;
    }
    print_message("%d x %d: within %.2f of 255, %d pixels of ground\n", view->width, view->height, worst, ground);
    assert_true(worst <= .75 && ground > 0);
}

/* Of the brightest pixel. */
static Vector brightest(const Preview *p, const View *view)
{
    int most = 0, at = 0;
    for (int i = 0; i < view->width * view->height; i++) {
        const unsigned char *c = p->rgb + 3 * i;
        if (c[0] + c[1] + c[2] > most) {
            most = c[0] + c[1] + c[2];
            at = i;
        }
    }
    return ray_of(view, at % view->width, at / view->width);
}

static const struct {
    const char *text;
    Vector sun;
    int width, height;
} skies[] = {
    {"{ material: SunSkyLight, sun: [0.4, -1, 0.5], turbidity: 3, radianceFactor: 0.05 }", {{.4, -1, .5}}, 64, 64},
    {"{ material: SunSkyLight, sun: [-1, 0.1, 0.8], turbidity: 2.5, radianceFactor: 0.05 }", {{-1, .1, .8}}, 80, 48},
    {"{ material: SunSkyLight, sun: [0.2, 0.9, 1.3], turbidity: 4, radianceFactor: 0.05 }", {{.2, .9, 1.3}}, 48, 80},
};

static void skies_stand_upright(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        Preview p = draw(skies[i].text, "sky", skies[i].width, skies[i].height);
        View view = sky_view(skies[i].sun, skies[i].width, skies[i].height);
        compare_sky(&p, &view);
        double apart = acos(dot(brightest(&p, &view), unit(skies[i].sun))) / RADIANS;
        print_message("brightest %.1f degrees from the sun\n", apart);
        assert_true(apart < 2);
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
        {"shininess", "shininess: 0.75", {78.9, 78.9, 78.9}}, /* an exponent of 30.99: 255 log2(30.99) / 16 */
        {"transparency", "transparency: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"transparencyShininess", "transparencyShininess: 0.75", {78.9, 78.9, 78.9}},
        {"interpolatedTransparency", "interpolatedTransparency: false", {0, 0, 0}},
        {"diffuseTransparency", "diffuseTransparency: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"ambient", "ambient: [0.5, 0.2, 0]", {187.5, 123.6, 0}},
        {"emissive", "emissive: [0.5, 0.2, 4]", {187.5, 123.6, 255}},
        {"ior", "{}", {0, 0, 0}},
        {"normal", "{}", {127.5, 127.5, 255}}, /* it faces the eye */
    };
    enum { SIDE = 65, MIDDLE = (SIDE / 2 * SIDE + SIDE / 2) * 3 };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[128];
        snprintf(text, sizeof text, "{ material: Phong%s%s }", *cases[i].text == '{' ? "" : ", ",
                 *cases[i].text == '{' ? "" : cases[i].text);
        Preview p = draw_slot(text, "gbuffer", cases[i].slot, SIDE, SIDE);
        for (int lane = 0; lane < 3; lane++)
            if (fabs(p.rgb[MIDDLE + lane] - cases[i].bytes[lane]) > 1.5)
                fail_msg("%s.%d: %d, not %g", cases[i].slot, lane, p.rgb[MIDDLE + lane], cases[i].bytes[lane]);
        assert_int_equal(p.rgb[0], p.rgb[2]); /* beside the sphere */
        assert_true(p.rgb[0] < 45);
        discard(&p);
    }
    assert_int_equal(sizeof cases / sizeof *cases, SLOT_COUNT);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        assert_non_null(slot_look_find(slot_table[slot].name));
}

/* The light and the slot normal stand in eye space, whichever space the G-buffer's normals are in. */
static void normals_of_the_world_look_alike(void **state)
{
    (void)state;
    static const char text[] =
        "{ material: Phong, diffuse: 0.5, specular: 0.5, input: { map: WaveMap, amplitude: 0.1 } }";
    static const char *const slots[] = {NULL, "normal"};
    enum { SIDE = 48, BYTES = SIDE * SIDE * 3 };
    for (int i = 0; i < 2; i++) {
        Preview eye = draw_subject(&(Subject){text, "gbuffer", "eye", slots[i]}, SIDE, SIDE);
        Preview world = draw_subject(&(Subject){text, "gbuffer", "world", slots[i]}, SIDE, SIDE);
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

/* A camera sees what it looks at in the middle, and a point beside it where the angle says. */
static void cameras_look(void **state)
{
    (void)state;
    Viewpoint viewpoint = camera_viewpoint_for(SHAPE_sphere);
    assert_true(camera_viewpoint_read("3,-4,2,1,0,0.5,40", &viewpoint));
    const Camera camera = camera_at(&viewpoint, 200, 100);
    const Mat4 all = mat4_multiply(&camera.clip_from_eye, &camera.eye_from_world);
    const View view = look((Vector){{3, -4, 2}}, unit((Vector){{2, -4, 1.5}}), 20 * RADIANS, 200, 100);
    static const double steps[][2] = {{0, 0}, {0.5, 0.25}, {-1, 0.5}};
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        Vector at = added(added((Vector){{1, 0, .5}}, scaled(view.right, steps[i][0])), scaled(view.up, steps[i][1]));
        double clip[4];
        for (int row = 0; row < 4; row++)
            clip[row] = all.m[row] * at.at[0] + all.m[4 + row] * at.at[1] + all.m[8 + row] * at.at[2] + all.m[12 + row];
        double distance = sqrt(dot((Vector){{2, -4, 1.5}}, (Vector){{2, -4, 1.5}}));
        assert_float_equal(clip[0] / clip[3], steps[i][0] / distance / view.tangent / 2, 1e-5);
        assert_float_equal(clip[1] / clip[3], steps[i][1] / distance / view.tangent, 1e-5);
        assert_true(fabs(clip[2]) < clip[3]); /* between near and far */
    }
    viewpoint = camera_viewpoint_for(SHAPE_sphere);
    static const char *const wrong[] = {"",
                                        "above",
                                        "1",
                                        "1,2",
                                        "1,2,3,4",
                                        "1,2,3,4,5",
                                        "1,2,3,1,2,3",
                                        "0,0,5",
                                        "1,2,nan",
                                        "1,2,3,0,0,0,0",
                                        "1,2,3,0,0,0,170",
                                        "1,2,3,0,0,0,30,1",
                                        "1,2,3 ",
                                        "1e9,0,0"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_false(camera_viewpoint_read(wrong[i], &viewpoint));
    static const char *const right[] = {"front", "left", "top", "low", "close", "1,2,3", "1,2,3,0,0,0"};
    for (size_t i = 0; i < sizeof right / sizeof *right; i++)
        assert_true(camera_viewpoint_read(right[i], &viewpoint));
}

/* The program's file, read by the compiler's reader of pictures, in which v = 1 is the top. */
static double brightness_of_file(const char *path, double v)
{
    char text[512];
    const char *fault;
    double c[3];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    int size = snprintf(text, sizeof text, "{ material: Phong, emissive: { map: ImageMap, image: %s } }", path);
    MatcDocument *document = matc_read("file.yaml", text, (size_t)size, &options);
    assert_int_equal(matc_material_count(document), 1);
    snprintf(text, sizeof text, "u=0.5 v=%g", v);
    char *values = matc_eval(document, 0, text, &options, &fault);
    const char *line = values ? strstr(values, "\nemissive ") : NULL;
    assert_non_null(line);
    assert_int_equal(sscanf(line, " emissive %lf %lf %lf", &c[0], &c[1], &c[2]), 3);
    free(values);
    matc_document_free(document);
    return c[0] + c[1] + c[2];
}

/* matview itself: the ground lies below. */
static void the_program_writes_it_upright(void **state)
{
    (void)state;
    char folder[] = "/tmp/matc-preview-XXXXXX", path[64], command[1024];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/sky.png", folder);
    snprintf(command, sizeof command, "'%s' --pass=sky --samples=1 --size=64 -o %s '%s' > /dev/null", MATVIEW_PROGRAM,
             path, SOURCE_FOLDER "/examples/materials/sunSky.yaml");
    assert_int_equal(system(command), 0);
    double low = brightness_of_file(path, .01), high = brightness_of_file(path, .97);
    assert_true(low == 0 && high > .3);
    assert_int_equal(remove(path), 0);
    assert_int_equal(rmdir(folder), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spheres_are_lit),
        cmocka_unit_test(srgb_bytes_come_back),
        cmocka_unit_test(slots_are_shown),
        cmocka_unit_test(skies_stand_upright),
        cmocka_unit_test(normals_of_the_world_look_alike),
        cmocka_unit_test(cameras_look),
        cmocka_unit_test(the_program_writes_it_upright),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
