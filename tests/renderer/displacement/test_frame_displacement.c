/* Displaced objects in pictures: closed meshes have no hole, from 64 sides; outlines, light and
 * shadows of each method against Embree's rays, with the oracle's material at each point. */
/* ctest: seconds=82 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/shadow_ray.h"
#include "tests/draw/curved.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT };

/* Hard edges, seams of texture coordinates, a height that crosses both, and one that jumps. */
#define MATERIALS                                                                                  \
    "materials:\n"                                                                                 \
    "  rock: { material: Phong, diffuse: { map: Granite }, emissive: 0.2, displacementScale: "     \
    "0.2,\n"                                                                                       \
    "    displacement: { map: VolumeTurbulence, size: 2, octaves: 3, noiseRatio: 0.5 } }\n"        \
    "  tiles: { material: Phong, diffuse: [0.7, 0.4, 0.2], emissive: 0.2, displacementScale: "     \
    "0.1,\n"                                                                                       \
    "    displacement: { map: Checker, input: { map: UVTransform, scaleU: 5, scaleV: 4 } } }\n"    \
    "  leaning: { material: Phong, diffuse: 0.8, emissive: 0.2, displacementVector: { map: "       \
    "Blend, input: { map: Gradient, direction: "                                                   \
    "[2, 3, 1], waveForm: Sin }, blend: [{ value: -1, input: [0.1, 0, -0.1] }, { value: 1, "       \
    "input: [-0.1, 0.1, 0.2] }] } }\n"                                                             \
    "  floor: { material: Phong, diffuse: 0.6, emissive: 0.2 }\n"                                  \
    "displacement: { triangles: 20000, method: %s }\n"
static const char *const bodies[] = {
    "- { object: Box, size: [1.4, 1.4, 1.4], material: rock, transform: { rotation: [0.3, 0.5, "
    "0.1] } }\n",
    "- { object: Sphere, radius: 0.9, material: tiles, detail: 48 }\n",
    "- { object: Cylinder, radius: 0.6, height: 1.2, detail: 40, material: leaning, transform: { "
    "translation: [0, 0, -0.6] } }\n",
    "- { object: Cone, radius: 0.8, height: 1.5, detail: 40, material: rock, transform: { "
    "translation: [0, 0, -0.5], rotation: [2, 0, 0] } }\n",
};
static const char *const methods[] = {"mesh", "bisection"};
enum { BODIES = sizeof bodies / sizeof *bodies, VIEWS = 16 };

/* 1 if a ray and four rays a fiftieth of a pixel away all hit, 0 if all miss; -1: they disagree. */
static int covered(const Tracer *tracer, int x, int y)
{
    int met = 0;
    for (int i = 0; i < 5; i++) {
        const double aside = i ? .02 : 0;
        const Ray ray = reference_ray(tracer->scene, x + .5 + (i & 1 ? aside : -aside),
                                      y + .5 + (i & 2 ? aside : -aside));
        met += reference_hit(tracer, &ray, 0).object >= 0;
    }
    return met == 5 ? 1 : met ? -1 : 0;
}

/* 16 views of each of four meshes, over the whole sphere of directions: no inner pixel shows the
 * background, and no outer pixel is drawn. */
static void nothing_shows_through_what_is_closed(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    long within = 0, beside = 0, ties = 0;
    for (int view = 0; view < BODIES * VIEWS; view++) {
        const double z = 1 - (2 * (view % VIEWS) + 1.) / VIEWS, turn = 2.399963229728653 * view,
                     r = sqrt(1 - z * z);
        char text[4000];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [%g, "
                 "%g, %g], angle: 40 }\n" MATERIALS "objects:\n%s",
                 WIDTH, HEIGHT, 4 * r * cos(turn), 4 * r * sin(turn), 4 * z, methods[view % 2],
                 bodies[view / VIEWS]);
        Scene *scene = frame_scene(text, &options, &document);
        float *light =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
        Tracer tracer = reference_open(scene);
        for (int i = 0; i < PIXELS; i++) {
            const int is = covered(&tracer, i % WIDTH, i / WIDTH), shown = light[4 * i] > 0.1f;
            within += is == 1, beside += is == 0, ties += is < 0;
            if (is >= 0 && is != shown)
                fail_msg("view %d, pixel %d, %d: %s", view, i % WIDTH, i / WIDTH,
                         shown ? "drawn beside it" : "a hole");
        }
        reference_close(&tracer);
        free(light);
        frame_forget(scene, document);
    }
    gl_close(gl);
    print_message("%ld pixels within, %ld beside, %ld at outlines\n", within, beside, ties);
    assert_true(within > 60000 && beside > 200000);
}

/* True if adjacent pixels hit the same face at about the same distance. */
static bool is_plain(const Tracer *tracer, int x, int y, const Hit *hit)
{
    for (int i = 0; i < 4; i++) {
        const Ray ray =
            reference_ray(tracer->scene, x + .5 + (i & 1 ? .5 : -.5), y + .5 + (i & 2 ? .5 : -.5));
        const Hit other = reference_hit(tracer, &ray, 0);
        if (other.object != hit->object ||
            fabs(other.distance - hit->distance) > .01 * hit->distance)
            return false;
    }
    return true;
}

/* Light of a lamp without shadows: normal and position are those of the displaced surface. */
static void light_is_that_of_the_oracle(void **state)
{
    (void)state;
    static Spread spread;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    for (int body = 0; body < BODIES; body++) {
        char text[4000];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, "
                 "-3, 2], angle: 40 }\n" MATERIALS
                 "lights:\n- { light: Point, position: [2, -2, 3], intensity: 12 }\nobjects:\n%s",
                 WIDTH, HEIGHT, methods[body % 2], bodies[body]);
        Scene *scene = frame_scene(text, &options, &document);
        float *light = frame_floats(
            gl, scene,
            &(RendererOptions){.compile = &options, .view = "light", .no_shadows = true});
        Tracer tracer = reference_open(scene);
        spread.count = spread.lit = 0;
        for (int i = 0; i < PIXELS; i++) {
            const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            if (hit.object < 0 || !is_plain(&tracer, i % WIDTH, i / WIDTH, &hit))
                continue;
            Sample sample = reference_sample(&tracer, i % WIDTH, i / WIDTH, &options);
            sample.edge = false; /* of triangles */
            add_sample(&spread, &sample, light + 4 * i);
        }
        qsort(spread.differences, (size_t)spread.count, sizeof *spread.differences, ascending);
        const double middle = spread.differences[spread.count / 2],
                     most = spread.differences[(int)(spread.count * .99)];
        print_message("body %d: %d pixels, median %.2g, 99 %% within %.2g\n", body, spread.count,
                      middle, most);
        assert_true(spread.count > 700 && spread.lit > spread.count / 2);
        assert_true(middle < 5e-6 && most < 5e-5);
        reference_close(&tracer);
        free(light);
        frame_forget(scene, document);
    }
    matc_layout_free(layout);
    gl_close(gl);
}

#ifdef MATC_ASSIMP
/* The torus, in AROUND times TUBE parts. */
static void write_torus(const char *path)
{
    enum { AROUND = 96, TUBE = 64 };
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file,
            "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float "
            "y\nproperty float z\nproperty float nx\n"
            "property float ny\nproperty float nz\nproperty float s\nproperty float t\nelement "
            "face %d\n"
            "property list uchar int vertex_index\nend_header\n",
            (AROUND + 1) * (TUBE + 1), AROUND * TUBE);
    for (int i = 0; i < (AROUND + 1) * (TUBE + 1); i++) {
        Surface surface;
        const double u = i % (AROUND + 1) / (double)AROUND, v = i / (AROUND + 1) / (double)TUBE;
        curved_surface(CURVED_torus, u, v, &surface);
        const double *p = &surface.root[channel_id(GROUP_P, 0)],
                     *n = &surface.root[channel_id(GROUP_N, 0)];
        fprintf(file, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", p[0], p[1], p[2], n[0], n[1],
                n[2], u, v);
    }
    for (int i = 0; i < AROUND * TUBE; i++) {
        const int at = i / AROUND * (AROUND + 1) + i % AROUND;
        fprintf(file, "4 %d %d %d %d\n", at, at + 1, at + AROUND + 2, at + AROUND + 1);
    }
    assert_int_equal(fclose(file), 0);
}

/* Displacement of a mesh: along its normals, or by a vector. */
typedef struct {
    CurvedBody body;
    double scale;
    bool vector;
} Risen;

static void want_normal(const Risen *risen, const double place[3], bool stay, double want[3])
{
    if (risen->vector && !stay)
        curved_vector_normal(risen->body, risen->scale, place, want);
    else
        curved_normal(risen->body, risen->vector ? 0 : risen->scale, place, stay, want);
}

/* Root mean square angle, in degrees, between a picture's normals and the closed form: [0] as
 * drawn, [1] with constant base normals or, for vectors, those of the undisplaced mesh. Skips
 * pixels whose neighborhood shows another face. */
static int judge_slopes(const Scene *scene, const Risen *risen, const float *normals, double off[2])
{
    Tracer tracer = reference_open(scene);
    int count = 0;
    off[0] = off[1] = 0;
    for (int i = 0; i < PIXELS; i++) {
        const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
        const Hit hit = reference_hit(&tracer, &ray, 0);
        if (hit.object < 0 || !is_plain(&tracer, i % WIDTH, i / WIDTH, &hit))
            continue;
        double shown[3];
        for (int component = 0; component < 3; component++) /* from eye space */
            shown[component] = normals[4 * i] * scene->camera.right[component] +
                               normals[4 * i + 1] * scene->camera.up[component] +
                               normals[4 * i + 2] * scene->camera.back[component];
        for (int stay = 0; stay < 2; stay++) {
            double want[3];
            want_normal(risen, hit.local, stay, want);
            const double angle = curved_angle(shown, want);
            off[stay] += angle * angle;
        }
        count++;
    }
    reference_close(&tracer);
    for (int stay = 0; stay < 2; stay++)
        off[stay] = sqrt(off[stay] / count);
    return count;
}

/* A ball and a torus displaced by up to a fifth of their radii, subdivided by CPU and driver,
 * and ray-marched: the CPU's triangles give each pixel's point of the base. */
static void normals_are_those_of_curved_surfaces(void **state)
{
    (void)state;
    static const char *const ways[] = {"mesh", "mesh", "grid", "traced", "mesh", "grid", "traced"};
    char path[] = "/tmp/matc_torusXXXXXX.ply";
    const int file = mkstemps(path, 4);
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    assert_true(file >= 0 && !close(file));
    write_torus(path);
    for (int i = 0; i < 7; i++) {
        const Risen risen = {i ? CURVED_torus : CURVED_ball,
                             curved_radius[i ? CURVED_torus : CURVED_ball] / (i > 3 ? 8 : 5),
                             i > 3};
        Scene *scenes[2]; /* what is drawn; what says where */
        MatcDocument *documents[2];
        double off[2];
        for (int k = 0; k < 2; k++) {
            char text[1000];
            snprintf(text, sizeof text,
                     "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: "
                     "[1, -3, 2.5], angle: 40 }\n"
                     "materials: { risen: { material: Phong, displacementScale: %g, displacement%s "
                     "} }\ndisplacement: { method: %s, level: 2 }\nobjects: [{ object: %s%s, "
                     "material: risen }]\n",
                     WIDTH, HEIGHT, risen.scale,
                     risen.vector ? "Vector: " CURVED_VECTOR : ": " CURVED_HEIGHT,
                     k ? "mesh" : ways[i], i ? "Mesh, file: " : "Sphere, detail: 192",
                     i ? path : "");
            scenes[k] = frame_scene(text, &options, &documents[k]);
        }
        float *normals =
            frame_floats(gl, scenes[0], &(RendererOptions){.compile = &options, .view = "normal"});
        const int count = judge_slopes(scenes[1], &risen, normals, off);
        print_message(
            "%-6s %d pixels within %.3g degrees in the mean square; if normals stayed, %.3g\n",
            ways[i], count, off[0], off[1]);
        assert_true(count > 1500 && off[0] < (risen.vector ? 0.2 : 0.08) && off[1] > 8 * off[0]);
        free(normals);
        for (int k = 0; k < 2; k++)
            frame_forget(scenes[k], documents[k]);
    }
    matc_layout_free(layout);
    gl_close(gl);
    assert_int_equal(unlink(path), 0);
}
#endif

/* The floor under a displaced mesh is dark where rays to the light hit the mesh, by maps, by
 * silhouettes and exactly. */
static void shadows_are_those_of_the_displaced_shape(void **state)
{
    (void)state;
    static const char *const shadows[] = {"map", "silhouette", "exact", "hybrid"};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t m = 0; m < sizeof shadows / sizeof *shadows; m++) {
        char text[4000];
        MatcDocument *document;
        int wrong = 0, dark = 0, all = 0;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, "
                 "-5, 4], angle: 45 }\n" MATERIALS
                 "shadowMaps: { size: 2048, filter: 0 }\nlights:\n- { light: Directional, "
                 "direction: [1, -0.6, -1], shadows: %s }\n"
                 "objects:\n%s- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: "
                 "floor, transform: { translation: [-4, -4, -1] } }\n",
                 WIDTH, HEIGHT, methods[m % 2], shadows[m], bodies[0]);
        Scene *scene = frame_scene(text, &options, &document);
        float *with =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
        float *without = frame_floats(
            gl, scene,
            &(RendererOptions){.compile = &options, .view = "light", .no_shadows = true});
        Tracer tracer = reference_open(scene);
        for (int i = 0; i < PIXELS; i++) {
            const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            if (hit.object != 1) /* the floor */
                continue;
            const bool lit = shadow_is_lit(&tracer, &scene->lights[0], hit.world, hit.microfacet);
            bool agree = true;
            for (int k = 0; agree && k < 8; k++) { /* an end of a shadow is a hundredth away */
                double moved[3] = {hit.world[0] + .01 * cos(.8 * k),
                                   hit.world[1] + .01 * sin(.8 * k), hit.world[2]};
                agree = shadow_is_lit(&tracer, &scene->lights[0], moved, hit.microfacet) == lit;
            }
            if (!agree)
                continue;
            all++;
            dark += !lit;
            wrong += lit != (with[4 * i] > .9f * without[4 * i]);
        }
        print_message("%-10s %d pixels of the floor, %d dark, %d wrong\n", shadows[m], all, dark,
                      wrong);
        assert_true(all > 3000 && dark > 150);
        assert_int_equal(wrong, 0);
        reference_close(&tracer);
        free(with);
        free(without);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_shows_through_what_is_closed),
        cmocka_unit_test(light_is_that_of_the_oracle),
#ifdef MATC_ASSIMP
        cmocka_unit_test(normals_are_those_of_curved_surfaces),
#endif
        cmocka_unit_test(shadows_are_those_of_the_displaced_shape),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
