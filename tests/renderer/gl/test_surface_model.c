/* Surface models that the renderer does not know: Lambert's, which is Phong without its lobe,
 * and a flat one, whose picture is its slot. No other pass changes for them. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIT                                                                                        \
    "struct Lit { vec3 normal, color; };\n"                                                        \
    "Lit surfaceLit(Surface s, vec3 toEye) { return Lit(s.normal, s.diffuse); }\n"                 \
    "vec3 surfaceThrough(Surface s, vec3 toEye) { return s.transparency; }\n"

static const SurfaceModel lambert = {
    "Lambert",
    LIT "vec3 surfaceOwn(Lit m) { return vec3(0.0); }\n"
        "vec3 surfaceAmbient(Lit m, vec3 ambient) { return vec3(0.0); }\n"
        "vec3 surfaceLobe(Lit m, vec3 l) { return m.color * max(dot(m.normal, l), 0.0); }\n"
        "#ifdef LIGHT_HAS_AREAS\n"
        "vec3 surfaceArea(Lit m, Area a) { return m.color * areaCosine(a, m.normal, AREA_ALL); }\n"
        "#endif\n",
    false,
    {NULL}};
static const SurfaceModel flat = {"Flat",
                                  LIT
                                  "vec3 surfaceOwn(Lit m) { return m.color; }\n"
                                  "vec3 surfaceAmbient(Lit m, vec3 ambient) { return vec3(0.0); }\n"
                                  "vec3 surfaceLobe(Lit m, vec3 l) { return vec3(0.0); }\n"
                                  "#ifdef LIGHT_HAS_AREAS\n"
                                  "vec3 surfaceArea(Lit m, Area a) { return vec3(0.0); }\n"
                                  "#endif\n",
                                  false,
                                  {NULL}};
static const SurfaceModel broken = {"Broken", "struct Lit { vec3 normal; };\n", false, {NULL}};

#define SOLIDS                                                                                     \
    "image: { width: 96, height: 64 }\ncamera: { camera: Perspective, position: [0, -6, 4], "      \
    "target: [0, 0, .5] }\n"                                                                       \
    "objects:\n- { object: Plane, material: { material: Phong, diffuse: [.5, .2, .1] } }\n"        \
    "- { object: Box, material: { material: Phong, diffuse: .6 }, transform: { translation: "      \
    "[-.8, 0, .5] } }\n"
#define LAMP "{ light: Point, position: [3, -2, 4], intensity: 12 }"

static const char lamps[] = SOLIDS "lights: [" LAMP ", { light: Area, position: [-2, -2, 3] }]\n";
static const char glass[] = SOLIDS
    "- { object: Sphere, radius: .5, material: { material: Phong, diffuse: [.1, .3, .1], "
    "transparency: .5, "
    "interpolatedTransparency: false }, transform: { translation: [.6, .4, 1] } }\nlights: [" LAMP
    "]\n";

typedef struct {
    MatcLayout *layout;
    MatcOptions options;
    GlContext *gl;
} Rig;

static float *draw(const Rig *rig, const char *text, const SurfaceModel *surface, const char *view)
{
    MatcDocument *document;
    Scene *scene = frame_scene(text, &rig->options, &document);
    float *rgba = frame_floats(
        rig->gl, scene,
        &(RendererOptions){.compile = &rig->options, .view = view, .surface = surface});
    frame_forget(scene, document);
    return rgba;
}

/* The largest difference of two pictures; both go. The first is not black. */
static double difference(float *a, float *b)
{
    enum { COUNT = 96 * 64 };
    double most = 0, sum = 0;
    for (int i = 0; i < 4 * COUNT; i++) {
        sum += i % 4 < 3 ? (double)a[i] : 0;
        most = i % 4 < 3 ? fmax(most, fabs((double)a[i] - (double)b[i])) : most;
    }
    free(a);
    free(b);
    assert_true(sum > .05 * COUNT);
    return most;
}

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

/* With lamps, areas, shadows and a plane. */
static void lambert_is_phong_without_a_lobe(void **state)
{
    (void)state;
    Rig rig = open_rig();
    assert_true(
        difference(draw(&rig, lamps, NULL, "light"), draw(&rig, lamps, &lambert, "light")) <= 1e-6);
    close_rig(&rig);
}

/* A pixel is the diffuse slot of its surface; a quarter transmittance, where both sides of the
 * sphere cover it: .1 + .1 / 2. */
static void flat_is_a_slot(void **state)
{
    (void)state;
    Rig rig = open_rig();
    float *light = draw(&rig, glass, &flat, "light"), *slot = draw(&rig, glass, &flat, "diffuse");
    int same = 0, over = 0;
    for (int i = 0; i < 96 * 64; i++) {
        const float *a = light + 4 * i, *b = slot + 4 * i;
        same += fabsf(a[0] - b[0]) < 1e-6f;
        over += fabsf(a[0] - (.15f + .25f * b[0])) < 1e-6f &&
                fabsf(a[1] - (.45f + .25f * b[1])) < 1e-6f;
    }
    free(light);
    free(slot);
    assert_true(same > 3000 && over > 100 && same + over >= 96 * 64);
    close_rig(&rig);
}

static void faults_name_the_model(void **state)
{
    (void)state;
    Rig rig = open_rig();
    MatcDocument *document;
    Scene *scene =
        frame_scene("lights: []\nobjects: [{ object: Box, material: { material: Phong } }]\n",
                    &rig.options, &document);
    Renderer *renderer =
        renderer_open(rig.gl, &(RendererOptions){.compile = &rig.options, .surface = &broken});
    assert_non_null(renderer);
    assert_false(renderer_set_scene(renderer, scene));
    assert_non_null(strstr(rig.gl->error, "lighting surfaces by the model Broken: "));
    renderer_close(renderer);
    frame_forget(scene, document);
    close_rig(&rig);
}

/* Each row of LOBE: a lobe that no text asks for would be drawn by nobody, or stay in programs that
 * lack it. */
static void lobes_are_asked_for(void **state)
{
    (void)state;
    for (int lobe = 0; lobe < LOBE_COUNT; lobe++) {
        const char *name = lobe_table[lobe].name;
        char line[128];
        int found = 0;
        snprintf(line, sizeof line, "#if defined(SURFACE_HAS_%s) && !defined(SURFACE_MISSING_%s)\n",
                 name, name);
        found += strstr(surface_model_principled.text, line) != NULL;
        for (int i = 0; i < SURFACE_MODEL_MORE && surface_model_principled.more[i]; i++)
            found += strstr(surface_model_principled.more[i], line) != NULL;
        if (found != 1)
            fail_msg("%s: asked for in %d texts", name, found);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lobes_are_asked_for), cmocka_unit_test(lambert_is_phong_without_a_lobe),
        cmocka_unit_test(flat_is_a_slot), cmocka_unit_test(faults_name_the_model)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
