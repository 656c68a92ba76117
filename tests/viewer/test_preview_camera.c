/* The preview's cameras: a sky by the C reference in directions from the camera's definition,
 * points away from the center, files the right way up. */
#include "tests/test.h"
#include "tests/preview.h"
#include <stdio.h>
#include <unistd.h>

/* A sky's own brightness by the C reference, exposed as the preview does. */
static void want_sky(const Drawn *p, Vector ray, double want[3])
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
    for (int component = 0; component < 3; component++)
        want[component] = byte_of(want[component] * (1 - exp(-.9 * most)) / most);
}

/* The camera of the sky stands at the origin and looks 41 degrees up, towards the sun as far as
 * steps of 5 degrees let it. */
static View sky_view(Vector sun, int width, int height)
{
    double step = 5 * RADIANS, azimuth = step * round(atan2(sun.at[1], sun.at[0]) / step);
    return look((Vector){{0, 0, 0}}, scaled(from_angles(azimuth, 41 * RADIANS), -1), 45 * RADIANS,
                width, height);
}

/* Near the horizon the sky jumps to black. */
static const double horizon = .01;

static void compare_sky(const Drawn *p, const View *view)
{
    double worst = 0;
    int ground = 0;
    for (int i = 0; i < view->width * view->height; i++) {
        Vector ray = ray_of(view, i % view->width, i / view->width);
        double want[3];
        if (fabs(ray.at[2]) < horizon)
            continue;
        want_sky(p, ray, want);
        for (int component = 0; component < 3; component++)
            worst = fmax(worst, fabs(p->rgb[3 * i + component] - want[component]));
        ground += want[0] + want[1] + want[2] == 0;
    }
    print_message("%d x %d: within %.2f of 255, %d pixels of ground\n", view->width, view->height,
                  worst, ground);
    assert_true(worst <= .75 && ground > 0);
}

/* Direction of the brightest pixel. */
static Vector brightest(const Drawn *p, const View *view)
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
    {"{ material: SunSkyLight, sun: [0.4, -1, 0.5], turbidity: 3, radianceFactor: 0.05 }",
     {{.4, -1, .5}},
     64,
     64},
    {"{ material: SunSkyLight, sun: [-1, 0.1, 0.8], turbidity: 2.5, radianceFactor: 0.05 }",
     {{-1, .1, .8}},
     80,
     48},
    {"{ material: SunSkyLight, sun: [0.2, 0.9, 1.3], turbidity: 4, radianceFactor: 0.05 }",
     {{.2, .9, 1.3}},
     48,
     80},
};

static void skies_stand_upright(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        Drawn p = draw(skies[i].text, "sky", skies[i].width, skies[i].height);
        View view = sky_view(skies[i].sun, skies[i].width, skies[i].height);
        compare_sky(&p, &view);
        double apart = acos(dot(brightest(&p, &view), unit(skies[i].sun))) / RADIANS;
        print_message("brightest %.1f degrees from the sun\n", apart);
        assert_true(apart < 2);
        discard(&p);
    }
}

/* A camera stands and looks as its numbers say. */
static void cameras_look(void **state)
{
    (void)state;
    Viewpoint viewpoint = camera_viewpoint_for(SHAPE_sphere);
    assert_true(camera_viewpoint_read("3,-4,2,1,0,0.5,40", &viewpoint));
    const SceneCamera camera = camera_at(&viewpoint);
    const View view =
        look((Vector){{3, -4, 2}}, unit((Vector){{2, -4, 1.5}}), 20 * RADIANS, 200, 100);
    assert_true(fabs(camera.half - view.tangent) < 1e-12);
    for (int i = 0; i < 3; i++) {
        assert_true(camera.position[i] == view.position.at[i]);
        assert_true(fabs(camera.right[i] - view.right.at[i]) < 1e-12);
        assert_true(fabs(camera.up[i] - view.up.at[i]) < 1e-12);
        assert_true(fabs(camera.back[i] - view.back.at[i]) < 1e-12);
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
    static const char *const right[] = {"front", "left",  "top",        "low",
                                        "close", "1,2,3", "1,2,3,0,0,0"};
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
    int size = snprintf(text, sizeof text,
                        "{ material: Phong, emissive: { map: ImageMap, image: %s } }", path);
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
    snprintf(command, sizeof command,
             "'%s' --pass=sky --samples=1 --size=64 -o %s '%s' > /dev/null", MATVIEW_PROGRAM, path,
             SOURCE_FOLDER "/examples/materials/sunSky.yaml");
    assert_int_equal(system(command), 0);
    double low = brightness_of_file(path, .01), high = brightness_of_file(path, .97);
    assert_true(low == 0 && high > .3);
    assert_int_equal(remove(path), 0);
    assert_int_equal(rmdir(folder), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skies_stand_upright),
        cmocka_unit_test(cameras_look),
        cmocka_unit_test(the_program_writes_it_upright),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
