/* Screen-space ambient occlusion and indirect light, against closed forms; their effect on the
 * lit picture. */
/* ctest: seconds=20 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_ray.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 72, PIXELS = WIDTH * HEIGHT, TEXT = 4096 };
#define IMAGE "image: { width: 96, height: 72 }\n"

typedef struct {
    MatcLayout *layout;
    MatcOptions options;
    GlContext *gl;
    MatcDocument *document;
    Scene *scene;
} Rig;

static Rig open_rig(void)
{
    Rig rig = {.gl = frame_context()};
    rig.options = frame_float_options(&rig.layout);
    return rig;
}

static void close_rig(Rig *rig)
{
    gl_close(rig->gl);
    matc_layout_free(rig->layout);
}

static float *draw(Rig *rig, const char *text, const char *view)
{
    rig->scene = frame_scene(text, &rig->options, &rig->document);
    return frame_floats(rig->gl, rig->scene,
                        &(RendererOptions){.compile = &rig->options, .view = view, .deep = true});
}

static void forget(Rig *rig, float *rgba)
{
    free(rgba);
    frame_forget(rig->scene, rig->document);
}

/* An isolated plane is unoccluded: no ray hits the plane that it starts from, at any view angle,
 * and no bit is set. A plane has no voxels. */
static void planes_are_open(void **state)
{
    (void)state;
    static const char *const cameras[] = {
        "camera: Perspective, position: [0, -5, 3]",
        "camera: Perspective, position: [0, -5, .2], target: [0, 0, .1]",
        "camera: Orthographic, position: [0, -5, 4], size: 5",
        "camera: Perspective, position: [1, 1, 9], up: [0, 1, 0]"};
    static const char *const objects[] = {
        "{ object: Plane }", "{ object: Parallelogram, u: [9, 0, 0], v: [0, 9, 0], transform: { "
                             "translation: [-4.5, -4.5, 0] } }"};
    static const char *const methods[] = {"march, steps: 24", "march, steps: 24, march: picture",
                                          "screen",           "screen, thickness: .1",
                                          "hybrid",           "points"};
    Rig rig = open_rig();
    char text[TEXT];
    for (int i = 0; i < 4 * 2 * 6; i++) {
        snprintf(text, sizeof text,
                 IMAGE "camera: { %s }\nindirect: { method: %s, radius: 2 }\nmaterials: { m: { "
                       "material: Phong } "
                       "}\nobjects: [{ object: Group, material: m, objects: [%s] }]\n",
                 cameras[i % 4], methods[i / 8], objects[i / 4 % 2]);
        float *open = draw(&rig, text, "ao");
        int kept = 0;
        for (int p = 0; p < PIXELS; p++)
            kept += open[4 * p] != 1;
        if (kept)
            print_message("%s, %s, %s: %d pixels\n", methods[i / 8], cameras[i % 4],
                          objects[i / 4 % 2], kept);
        assert_int_equal(kept, 0);
        forget(&rig, open);
    }
    close_rig(&rig);
}

/* Occlusion by a wall at a share c of the radius: the cosine-weighted share of directions whose
 * x exceeds c, a segment of the unit disc. Also with weights 1 - c / x and 1 - c^2 / x^2; for
 * uniform directions half a cap. */
static double segment(double c) { return (acos(c) - c * sqrt(1 - c * c)) / PI; }
static double segment_linear(double c)
{
    const double s = sqrt(1 - c * c);
    return segment(c) - 2 * c / PI * (log((1 + s) / c) - s);
}
static double segment_quadratic(double c)
{
    return segment(c) - 2 * c * c / PI * (sqrt(1 - c * c) / c - acos(c));
}
static double cap(double c) { return (1 - c) / 2; }
/* Share of uniform points in the half ball behind the plane: half of a ball's cap. */
static double cap_volume(double c) { return (1 - c) * (1 - c) * (2 + c) / 4; }

typedef struct {
    const char *keys;
    double (*kept)(double c);
    bool light; /* also compare the wall's light */
} Corner;

typedef struct {
    double most, mean;
    int count;
} Off;

static const double radius = 1.5;

/* Means of 24 pixels along the wall's foot, because single pixels are noisy; 24 pixels at the
 * picture's sides are excluded, because they lack information outside of the picture. Within two
 * pixels of the foot the picture has no more resolution. */
static Off off_by(Rig *rig, const Corner *c, const float *rgba)
{
    Off off = {0};
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 24; x + 24 <= WIDTH - 24; x += 24) {
            const Ray ray = reference_ray(rig->scene, x + .5, y + .5);
            Hit hit = {.distance = INFINITY};
            double sum = 0;
            reference_plane(&rig->scene->objects[0], &ray, 0, &hit);
            for (int i = 0; i < 24; i++)
                sum += (double)rgba[4 * (y * WIDTH + x + i)] / 24;
            if (!(hit.world[0] < -.25))
                continue;
            const double kept = hit.world[0] > -radius ? c->kept(-hit.world[0] / radius) : 0;
            const double error = fabs(sum - (c->light ? kept : 1 - kept));
            off.most = fmax(off.most, error);
            off.mean += error;
            off.count++;
        }
    off.mean /= off.count;
    return off;
}

/* Floor z = 0 in front of a wall x = 0 of radiance 1: the wall sends as much light as it
 * occludes. */
static Off corner(Rig *rig, const Corner *c)
{
    char text[TEXT];
    snprintf(text, sizeof text,
             IMAGE
             "camera: { camera: Orthographic, position: [-4, 0, 6], target: [-1, 0, 0], size: 8 }\n"
             "indirect: { method: %s, rays: 64, radius: 1.5, filter: none }\nobjects:\n"
             "- { object: Plane, material: { material: Phong, diffuse: 1 } }\n"
             "- { object: Plane, material: { material: Phong, diffuse: 0, emissive: 1 }, "
             "transform: { rotation: "
             "[0, -1.5707963267948966, 0] } }\n",
             c->keys);
    float *rgba = draw(rig, text, c->light ? "indirect" : "ao");
    const Off off = off_by(rig, c, rgba);
    forget(rig, rgba);
    return off;
}

static void corners_are_as_their_closed_forms(void **state)
{
    (void)state;
    static const Corner corners[] = {
        {"march, steps: 32", segment, false},
        {"march, steps: 32", segment, true},
        {"march, steps: 32, checked: false", segment, true},
        {"march, steps: 128, march: picture", segment, true},
        {"march, steps: 32, sequence: halton", segment, false},
        {"march, steps: 32, sequence: random, rotation: random", segment, false},
        {"march, steps: 32, rotation: random", segment, false},
        {"march, steps: 64, weight: linear", segment_linear, false},
        {"march, steps: 64, weight: quadratic", segment_quadratic, false},
        {"march, steps: 32, distribution: uniform", cap, false},
        {"march, steps: 32, distribution: uniform", segment, true},
        {"points, distribution: uniform, checked: false", cap_volume, false},
        {"points, distribution: uniform, checked: false, sequence: hammersley, rotation: random",
         cap_volume, false}};
    Rig rig = open_rig();
    for (size_t i = 0; i < sizeof corners / sizeof *corners; i++) {
        const Off off = corner(&rig, &corners[i]);
        print_message("%s, %s: %.4f off in the mean, %.4f at most, of %d places\n", corners[i].keys,
                      corners[i].light ? "light" : "openness", off.mean, off.most, off.count);
        assert_true(off.count > 60 && off.mean < .004 && off.most < .035);
    }
    close_rig(&rig);
}

#define BOX                                                                                        \
    IMAGE                                                                                          \
    "camera: { camera: Perspective, position: [0, -5, 2.5], target: [0, 0, .5] }\nmaterials: { "   \
    "m: { material: "                                                                              \
    "Phong, diffuse: [.5, .4, .3], ambient: [.2, .5, .6], emissive: [.03, .02, .01], specular: 0 " \
    "} }\nobjects:\n"                                                                              \
    "- { object: Plane, material: m }\n- { object: Box, material: m, transform: { translation: "   \
    "[0, 0, .5] } }\n"
#define AROUND                                                                                     \
    "{ light: Ambient, color: [.3, .2, .5] }, { light: Hemisphere, color: [.5, .6, .9], ground: "  \
    "[.2, .1, .1] }"
#define LAMP "{ light: Point, position: [2, -2, 3], intensity: 5 }"

static float *light_of(Rig *rig, const char *keys, const char *lights, const char *view)
{
    char text[TEXT];
    snprintf(text, sizeof text, BOX "lights: [%s]\n%s\n", lights, keys);
    float *rgba = draw(rig, text, view);
    frame_forget(rig->scene, rig->document);
    return rgba;
}

enum { UNSEEN, SEEN, NOTHING };

/* By rays in double: the visibility of a pixel's point from the point at the picture's center. */
static int is_seen(const Tracer *tracer, const Hit *middle, const Hit *hit)
{
    Ray ray;
    double far = 0, faces[2] = {0};
    if (!isfinite(hit->distance))
        return NOTHING;
    for (int k = 0; k < 3; k++) {
        ray.way[k] = hit->world[k] - middle->world[k];
        ray.at[k] = middle->world[k] + 1e-6 * middle->microfacet[k];
        far += ray.way[k] * ray.way[k];
        faces[0] += middle->microfacet[k] * ray.way[k];
        faces[1] -= hit->microfacet[k] * ray.way[k];
    }
    far = sqrt(far);
    for (int k = 0; k < 3; k++)
        ray.way[k] /= far;
    return far > .3 && faces[0] > 1e-6 && faces[1] > 1e-6 &&
                   reference_hit(tracer, &ray, 0).distance > far - 1e-3
               ? SEEN
               : UNSEEN;
}

/* The point at the picture's center, on a wall, sees the ground in front, partly hidden by a
 * box. Within two pixels of the border of the visible part, ray steps and voxels decide. */
static void middles_see(void **state)
{
    (void)state;
    static const struct {
        const char *keys;
        /* max share of wrong pixels: the march may hit a surface that is only behind the ray */
        double most;
    } methods[] = {{"march, steps: 96", .06},
                   {"march, march: voxels, steps: 96", .02},
                   {"voxels", .01},
                   {"hybrid", .01}};
    static int truth[PIXELS];
    Rig rig = open_rig();
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        char text[TEXT];
        int counts[2] = {0}, wrong = 0;
        snprintf(text, sizeof text,
                 IMAGE "camera: { camera: Perspective, position: [0, -5, 4], target: [0, 1.4, 1] "
                       "}\nindirect: { method: %s, "
                       "radius: 6 }\nmaterials: { m: { material: Phong } }\nobjects:\n"
                       "- { object: Box, material: m, size: [9, 9, 1], transform: { translation: "
                       "[0, 0, -.5] } }\n"
                       "- { object: Box, material: m, size: [1.2, .5, .9], transform: { "
                       "translation: [.5, 0, .45] } }\n"
                       "- { object: Box, material: m, size: [6, .4, 4], transform: { translation: "
                       "[0, 1.6, 2] } }\n",
                 methods[i].keys);
        float *seen = draw(&rig, text, "visibility");
        Tracer tracer = reference_open(rig.scene);
        const Ray own = reference_ray(rig.scene, WIDTH / 2 + .5, HEIGHT / 2 + .5);
        const Hit middle = reference_hit(&tracer, &own, 0);
        for (int p = 0; p < PIXELS; p++) {
            const Ray ray = reference_ray(rig.scene, p % WIDTH + .5, p / WIDTH + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            truth[p] = is_seen(&tracer, &middle, &hit);
        }
        reference_close(&tracer);
        for (int p = 3 * WIDTH + 3; p < PIXELS - 3 * WIDTH - 3; p++) {
            bool even = truth[p] != NOTHING;
            for (int k = 0; k < 49; k++)
                even = even && truth[p + (k / 7 - 3) * WIDTH + k % 7 - 3] == truth[p];
            if (!even || seen[4 * p] > 2 * seen[4 * p + 1])
                continue;
            counts[truth[p]]++;
            wrong += (seen[4 * p + 2] > 1.5f * seen[4 * p]) == (truth[p] == SEEN);
        }
        print_message("%s: the middle sees %d pixels, and %d not; %d are wrong\n", methods[i].keys,
                      counts[SEEN], counts[UNSEEN], wrong);
        assert_true(counts[SEEN] > 100 && counts[UNSEEN] > 400 &&
                    wrong <= methods[i].most * (counts[0] + counts[1]));
        forget(&rig, seen);
    }
    close_rig(&rig);
}

/* The light is ambient light times ambient occlusion, plus indirect light times diffuse and
 * gain, plus direct light, optionally dimmed. */
static void light_is_their_sum(void **state)
{
    (void)state;
    static const float diffuse[3] = {.5f, .4f, .3f};
    Rig rig = open_rig();
    for (int dims = 0; dims < 2; dims++) {
        char keys[TEXT / 16];
        snprintf(keys, sizeof keys, "indirect: { gain: 2.5, directional: false, dimsDirect: %s }",
                 dims ? "true" : "false");
        float *all = light_of(&rig, keys, AROUND ", " LAMP, "light"),
              *open = light_of(&rig, keys, AROUND ", " LAMP, "ao"),
              *sent = light_of(&rig, keys, AROUND ", " LAMP, "indirect"),
              *around = light_of(&rig, "", AROUND, "light"), *own = light_of(&rig, "", "", "light"),
              *lamp = light_of(&rig, "", LAMP, "light");
        double most = 0, dimmed = 0, sum = 0;
        for (int i = 0; i < 4 * PIXELS; i++) {
            if (i % 4 == 3)
                continue;
            const double o = (double)open[i - i % 4], ambient = (double)around[i] - (double)own[i];
            const double want = o * ambient + 2.5 * (double)diffuse[i % 4] * (double)sent[i] +
                                (dims ? o : 1) * (double)lamp[i];
            most = fmax(most, own[i] > 0 ? fabs(want - (double)all[i]) : 0);
            dimmed += own[i] > 0 && o < .9;
            sum += (double)sent[i];
        }
        print_message("light is %.2g off its sum at most; %g components dimmed, %.3g indirect\n",
                      most, dimmed, sum);
        assert_true(most < 1e-5 && dimmed > 100 && sum > 1);
        float *const drawn[] = {all, open, sent, around, own, lamp};
        for (size_t i = 0; i < sizeof drawn / sizeof *drawn; i++)
            free(drawn[i]);
    }
    close_rig(&rig);
}

/* Fragment programs draw the same as compute programs; a picture that exceeds the memory limit
 * is still drawn at once. */
static void fragments_and_memory_change_nothing(void **state)
{
    (void)state;
    Rig rig = open_rig();
    rig.scene = frame_scene(BOX "indirect: {}\nlights: [" AROUND ", " LAMP "]\n", &rig.options,
                            &rig.document);
    RendererOptions options = {.compile = &rig.options, .view = "light", .deep = true};
    float *computed = frame_floats(rig.gl, rig.scene, &options);
    options.fragment = true;
    options.memory = 100000;
    Renderer *renderer = renderer_open(rig.gl, &options);
    float *drawn = frame_floats_by(rig.gl, renderer, rig.scene);
    assert_int_equal(renderer_tile_height(renderer), HEIGHT);
    double most = 0;
    for (int i = 0; i < 4 * PIXELS; i++)
        most = fmax(most, fabs((double)computed[i] - (double)drawn[i]));
    print_message("fragments are %.2g off\n", most);
    assert_true(most < 2e-6);
    renderer_close(renderer);
    free(computed);
    free(drawn);
    frame_forget(rig.scene, rig.document);
    close_rig(&rig);
}

/* Screen-space methods do not know a wall outside the picture: it neither sends light nor
 * occludes. */
static void what_is_beside_the_picture_is_not_known(void **state)
{
    (void)state;
    Rig rig = open_rig();
    char text[TEXT];
    float *rgba;
    snprintf(text, sizeof text,
             IMAGE "camera: { camera: Orthographic, position: [0, 0, 6], target: [0, 0, 0], up: "
                   "[0, 1, 0], size: 2 }\n"
                   "indirect: { method: march, radius: 3 }\nobjects:\n- { object: Plane, material: "
                   "{ material: Phong, "
                   "emissive: .5 } }\n- { object: Box, size: [1, 20, 20], transform: { "
                   "translation: [1.9, 0, 0] }, "
                   "material: { material: Phong, emissive: 9 } }\n");
    rgba = draw(&rig, text, "indirect");
    for (int i = 0; i < 4 * PIXELS; i++)
        assert_true(i % 4 == 3 ? rgba[i] == 1 : rgba[i] == 0);
    forget(&rig, rgba);
    close_rig(&rig);
}

static void faults_say_why(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *view, *fault;
    } cases[] = {{"", "ao",
                  "view 'ao' is not available: the scene has no `indirect:`, which "
                  "--indirect=METHOD gives it"},
                 {"indirect: { method: none }", "bent",
                  "view 'bent' is not available: the scene has no `indirect:`, which "
                  "--indirect=METHOD gives it"}};
    Rig rig = open_rig();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[TEXT];
        snprintf(text, sizeof text, BOX "%s\n", cases[i].keys);
        rig.scene = frame_scene(text, &rig.options, &rig.document);
        char *fault = frame_graph_or_fault(
            rig.gl, rig.scene, &(RendererOptions){.compile = &rig.options, .view = cases[i].view});
        assert_string_equal(fault, cases[i].fault);
        free(fault);
        frame_forget(rig.scene, rig.document);
    }
    close_rig(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_are_open),
        cmocka_unit_test(corners_are_as_their_closed_forms),
        cmocka_unit_test(middles_see),
        cmocka_unit_test(light_is_their_sum),
        cmocka_unit_test(fragments_and_memory_change_nothing),
        cmocka_unit_test(what_is_beside_the_picture_is_not_known),
        cmocka_unit_test(faults_say_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
