/* Planes, skies and surfaces, drawn with matc's own vertex program as an engine would, and read
 * back from a G-buffer. The expected values are computed here from the camera, and by the C
 * reference. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include "tests/value/apart.h"
#include "tests/value/half.h"
#include "tests/draw/vertices.h"
#include <string.h>

static void unpack(Rig *rig, const Scene *scene, const Framebuffer *source)
{
    if (!rig_unpack(rig, scene, source))
        fail_msg("%s", rig->gl->error);
}

/* A plane, as one without end or as a mesh of which u and v are from 0 to 1. */
typedef struct {
    Rig *rig;
    Scene *scene;
    Space space;
    bool mesh;
} View;

typedef struct {
    double slots, normal, depth; /* the greatest */
    int shown, hidden;           /* pixels */
} Errors;

/* Code of the world's normal in a G-buffer. */
static void stored_normal(const Scene *scene, const Space *space, const double world[3],
                          double stored[4])
{
    const char *normals = scene->options.normals;
    if (normals && !strcmp(normals, "world"))
        memcpy(stored, world, 3 * sizeof *world);
    else
        space_transform(&space->eye_from_world, world, 0, stored);
}

/* The thesis' spheremap has its rim at -z: beside it a step of the code turns the normal by so many
 * times as much. */
static double least_code(const double normal[3])
{
    return normal[2] < 0 ? fmin(hypot(normal[0], normal[1]), 1) : 1;
}

/* Errors of the ray grow with the distance and as the plane is seen from aside. */
static void compare_hit(const View *view, int i, const Hit *hit, Errors *errors)
{
    const Rig *s = view->rig;
    Surface surface = space_surface(&view->space, hit, view->mesh);
    SlotValues want = values_at(view->scene, &surface);
    double normal[4], size = fmax(1, fmax(fabs(hit->u), fabs(hit->v))) / fabs(hit->slope);
    stored_normal(view->scene, &view->space, want.component[SLOT_normal], normal);
    bool border = at_border(hit->u, 1e-6 * size) || at_border(hit->v, 1e-6 * size);
    bool fine = note(apart(s->slot[SLOT_specular][i], want.component[SLOT_specular]) / size,
                     &errors->slots) < 1e-6;
    fine &= note(apart(s->slot[SLOT_transparency][i], want.component[SLOT_transparency]) / size,
                 &errors->slots) < 1e-6;
    fine &=
        note(apart(s->slot[SLOT_normal][i], normal) * least_code(normal), &errors->normal) < 2e-6;
    fine &= note(fabs(s->z[i] - space_depth(&view->space, hit->position)), &errors->depth) < 1e-5;
    fine &= border || apart(s->slot[SLOT_diffuse][i], want.component[SLOT_diffuse]) == 0;
    if (!fine)
        fail_msg("pixel %d, %d, u %.7g, v %.7g, slope %.3g: specular %.9g, not %.9g; diffuse %g, "
                 "not %g; depth %.9g; "
                 "worst errors so far: slots %.2g, normal %.2g, depth %.2g",
                 i % SIDE, i / SIDE, hit->u, hit->v, hit->slope, s->slot[SLOT_specular][i][0],
                 want.component[SLOT_specular][0], s->slot[SLOT_diffuse][i][0],
                 want.component[SLOT_diffuse][0], s->z[i], errors->slots, errors->normal,
                 errors->depth);
}

static double beyond(const Hit *hit) { return fmax(fabs(hit->u - 0.5), fabs(hit->v - 0.5)) - 0.5; }

/* Draws the G-buffer in floats and looks at every pixel that does not lie on the horizon or the
 * rim. */
static void compare_plane(const View *view)
{
    Errors errors = {0};
    Rig *s = view->rig;
    draw_scene(s, view->scene, &view->space, view->mesh ? &s->plane : NULL, &s->full);
    unpack(s, view->scene, &s->full);
    for (int i = 0; i < PIXELS; i++) {
        Hit hit = space_meet(&view->space, middle(i % SIDE), middle(i / SIDE));
        bool shown = hit.before && (!view->mesh || beyond(&hit) < 0);
        if (fabs(hit.slope) < 1e-4 || (view->mesh && fabs(beyond(&hit)) < 1e-3))
            continue;
        if (shown != (s->color[1][i][0] != rig_cleared) || shown != (s->z[i] != rig_cleared_depth))
            fail_msg("pixel %d, %d: shown %d, but %g, %g", i % SIDE, i / SIDE, shown,
                     s->color[1][i][0], s->z[i]);
        errors.shown += shown;
        errors.hidden += !shown;
        if (shown && fabs(hit.slope) > 0.02)
            compare_hit(view, i, &hit, &errors);
    }
    print_message("%d pixels of it, %d of nothing: slots within %.1e, normal %.1e, depth %.1e\n",
                  errors.shown, errors.hidden, errors.slots, errors.normal, errors.depth);
    assert_true(errors.shown > PIXELS / 4 && errors.hidden > PIXELS / 20);
}

/* Texture coordinate, local position, world position and side show. */
static const char sides_text[] =
    "material: SideSwitch\n"
    "backShader: &back\n"
    "  material: Phong\n"
    "  diffuse: { map: Checker, color1: [0.25, 0.5, 0.75], color2: [1, 0.125, 0] }\n"
    "  specular: { map: Gradient, direction: [0.11, -0.07, 0.05] }\n"
    "  transparency: { map: Gradient, direction: [0.06, 0.09, -0.1], input: { map: XYZTransform, "
    "useGlobal: true } }\n"
    "frontShader: { <<: *back, diffuse: { map: Checker, color1: [0, 2, 4], color2: 0.5 } }\n";

static void meet_plane(Rig *rig, const char *normals)
{
    static const float eyes[][3] = {{3, -4, 1.6f}, {-2, 3, 3}, {1, 5, -2}};
    static const float plane[][3] = {{0.3f, -0.2f, -0.5f}, {1.1f, 0.4f, 0.1f}, {-0.28f, 0.77f, 0}};
    Scene scene = open_scene(rig, sides_text, &(SceneOptions){.pass = "plane", .normals = normals});
    for (int i = 0; i < 6; i++) {
        const float *eye = eyes[i / 2], target[3] = {0, 0.1f, 0.6f * eye[2]};
        View view = {rig, &scene, space_camera(eye, target, 0.6f), false};
        space_change_depth(&view.space, (SpaceDepth)(i % 3));
        for (int k = 0; k < 3; k++) /* from both sides */
            memcpy(view.space.plane[k], plane[i % 2 ? (3 - k) % 3 : k], sizeof plane[k]);
        compare_plane(&view);
    }
    scene_close(&scene);
}

static void a_plane_is_met(void **state)
{
    meet_plane(RIG, NULL);
    meet_plane(RIG, "world");
}

/* A mesh stands where the same plane would be met: turned, scaled by three numbers, moved; from
 * both sides. */
static void stand_in_world(Rig *rig, const char *normals)
{
    static const float eyes[][3] = {{2.5f, -2, 2}, {-2, 1.5f, -2.5f}};
    Scene scene = open_scene(rig, sides_text, &(SceneOptions){.normals = normals});
    for (int i = 0; i < 2; i++) {
        View view = {rig, &scene, space_camera(eyes[i], (float[3]){0.3f, 0.1f, 0}, 0.35f), true};
        space_place(&view.space);
        compare_plane(&view);
    }
    scene_close(&scene);
}

static void a_surface_stands_in_the_world(void **state)
{
    stand_in_world(RIG, "eye");
    stand_in_world(RIG, "world");
}

/* Vertices where they stand. */
typedef struct {
    Rig *rig;
    const Space *space;
    const Vertices *vertices;
} PlacedVertices;

/* One slot of all vertices; without a slot in the options the normal, as it is read back of a
 * G-buffer. */
static void compare_vertices(const PlacedVertices *placed, const char *text,
                             const SceneOptions *options, Slot slot)
{
    Rig *rig = placed->rig;
    const Space *space = placed->space;
    const Vertices *vertices = placed->vertices;
    Scene scene = open_scene(rig, text, options);
    double worst = 0;
    const bool stored = !options->slot;
    assert_true(rig_begin(rig, &rig->full));
    scene_use(&scene, space);
    vertices_draw(vertices, rig->gl);
    assert_true(rig_finish(rig, &rig->full));
    if (stored)
        unpack(rig, &scene, &rig->full);
    for (int i = 0; i < VERTICES; i++) {
        SlotValues values = values_at(&scene, &vertices->surface[i]);
        double normal[4], *want = stored ? normal : values.component[slot];
        stored_normal(&scene, space, values.component[slot], normal);
        const float *drawn = (stored ? rig->slot[SLOT_normal] : rig->color[0])[vertices->pixel[i]];
        if (!(note(apart(drawn, want), &worst) < 2e-6))
            fail_msg("%s: %s: %.9g, not %.9g", options->target, slot_table[slot].name, drawn[0],
                     want[0]);
    }
    print_message("%s, %s: within %.1e\n", options->target,
                  stored ? "normal of the G-buffer" : slot_table[slot].name, worst);
    scene_close(&scene);
}

/* The waves' normal is made of normal, tangents and texture coordinate. */
static const char frame_text[] =
    "material: Phong\n"
    "diffuse: { map: Gradient, direction: [0.5, -0.3, 0.7] }\n"
    "specular: { map: Gradient, direction: [0.3, 0.7, -0.4], input: { map: XYZTransform, "
    "useGlobal: true } }\n"
    "input: { map: WaveMap, amplitude: 0.1, uCount: 0.5, vCount: 0.3 }\n";

static void compare_attributes(Rig *rig, const Space *space, Vertices *vertices, const char *target)
{
    static const Slot slots[] = {SLOT_diffuse, SLOT_specular, SLOT_normal};
    SceneOptions options = {.pass = "value", .target = target};
    const PlacedVertices placed = {rig, space, vertices};
    assert_true(gl_use(rig->gl));
    vertices_upload(vertices, rig->gl);
    for (int k = 0; k < 3; k++) {
        options.slot = slot_table[slots[k]].name;
        compare_vertices(&placed, frame_text, &options, slots[k]);
    }
    compare_vertices(&placed, "material: Phong", &options, SLOT_normal);
    if (!strcmp(target, "glsl330"))
        for (int i = 0; i < 4; i++) /* as it is interpolated, and as a map bends it */
            compare_vertices(&placed, i % 2 ? frame_text : "material: Phong",
                             &(SceneOptions){.target = target, .normals = i / 2 ? "world" : "eye"},
                             SLOT_normal);
    vertices_delete(vertices, rig->gl);
}

static void every_attribute_arrives(void **state)
{
    static Vertices vertices;
    Rig *old = rig_new(false);
    assert_string_equal(old->error, "");
    Space space = space_camera((float[3]){2.5f, -2, 2}, (float[3]){0.1f, 0, 0}, 0.5f);
    space_place(&space);
    vertices_make(&vertices, &space, SIDE);
    compare_attributes(*state, &space, &vertices, "glsl330");
    compare_attributes(*state, &space, &vertices, "essl300");
    compare_attributes(old, &space, &vertices, "glsl110");
    rig_free(old);
    assert_true(gl_use(RIG->gl));
}

/* Greatest error of a sky in one direction, where a Checker of 6 u and 5 v is not near a border. */
static void compare_sky(Rig *rig, Scene *scene, const Space *space, double bound, double *worst)
{
    draw_scene(rig, scene, space, NULL, &rig->full);
    for (int i = 0; i < PIXELS; i += 5) {
        Hit hit = space_meet(space, middle(i % SIDE), middle(i / SIDE));
        const double *ray = hit.ray, u = atan2(ray[1], -ray[0]) / (2 * M_PI) + 0.5,
                     v = acos(-ray[2]) / M_PI;
        Surface s = {.front = true};
        surface_set3(&s, GROUP_P, ray);
        surface_set3(&s, GROUP_X, ray);
        surface_set3(&s, GROUP_U, (double[3]){u, v, 0});
        if (at_border(6 * u, 6e-5) || at_border(5 * v, 5 * 4e-4) || fabs(ray[2]) < 1e-5)
            continue;
        SlotValues values = values_at(scene, &s);
        double *want = values.component[SLOT_diffuse];
        for (int component = 0; component < 3; component++)
            want[component] += values.component[SLOT_emissive][component];
        const float *drawn = rig->color[0][i];
        if (!(note(apart(drawn, want) / fmax(1, want[1]), worst) < bound) || drawn[3] != 1)
            fail_msg("ray (%.7g, %.7g, %.7g): red %.7g, alpha %.7g, not %.7g, 1", ray[0], ray[1],
                     ray[2], drawn[0], drawn[3], want[0]);
    }
}

static void a_sky_is_all_around(void **state)
{
    static const char checker[] = "material: Phong\n"
                                  "diffuse: { map: Checker, color1: { map: Gradient, direction: "
                                  "[0.5, 0.3, -0.4] }, color2: [3, 2, 1],\n"
                                  "           input: { map: UVTransform, scaleU: 6, scaleV: 5 } }\n"
                                  "emissive: { map: Gradient, direction: [0.2, 0.4, 1], input: { "
                                  "map: XYZTransform, useGlobal: true } }\n";
    static const char *const texts[] = {checker, SOURCE_FOLDER "/examples/materials/sunSky.yaml"};
    static const float ways[][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const float eye[3] = {3, -2, 1};
    for (int k = 0; k < 2; k++) {
        double worst = 0;
        Scene scene = open_scene(*state, texts[k], &(SceneOptions){.pass = "sky"});
        for (int i = 0; i < 6; i++) {
            const float target[3] = {eye[0] + ways[i][0], eye[1] + ways[i][1], eye[2] + ways[i][2]};
            Space space = space_camera(eye, target, 1);
            space_change_depth(&space, (SpaceDepth)(i % 3));
            compare_sky(*state, &scene, &space, k ? 2e-5 : 2e-6, &worst);
        }
        print_message("%s: within %.1e\n", k ? "SunSkyLight" : "Checker", worst);
        scene_close(&scene);
    }
}

/* how a slot is kept: to a half float, to seven bits; a pixel */
enum { HALF, PAIR, MIDDLE = (SIDE + 1) * SIDE / 2 };

static void compare_slot(const Rig *s, const SlotValues *values, Slot slot, int component, int how)
{
    double value = values->component[slot][component], greatest = how == PAIR ? 1 : 65504,
           least = how == PAIR ? 0 : -greatest;
    double want = fmin(fmax(value, least), greatest), got = s->slot[slot][MIDDLE][component];
    double bound = how == PAIR ? 1 / 127.5 + 1e-6 : half_step(want) + 3e-6 * fabs(want);
    if (!(fabs(got - want) <= bound))
        fail_msg("%s: %.9g comes back as %.9g", slot_table[slot].name, value, got);
}

static void compare_round_trip(Rig *rig, Scene *scene, const float direction[3], double *worst)
{
    Space space = space_flat();
    space.world_from_local =
        mat4_look_at((float[3]){0, 0, 0}, direction, (float[3]){0.3f, 1, 0.2f});
    draw_scene(rig, scene, &space, &rig->plane, &rig->half);
    unpack(rig, scene, &rig->half);
    Surface s;
    oracle_surface_default(&s);
    const float *normal = &space.world_from_local.m[8];
    surface_set3(&s, GROUP_N, (double[3]){normal[0], normal[1], normal[2]});
    s.front = normal[2] > 0;
    SlotValues values = values_at(scene, &s);
    assert_true(note(angle(rig->slot[SLOT_normal][MIDDLE], values.component[SLOT_normal]), worst) <
                0.22);
    compare_slot(rig, &values, SLOT_shininess, 0, HALF);
    compare_slot(rig, &values, SLOT_transparencyShininess, 0, HALF);
    for (int component = 0; component < 3; component++) {
        compare_slot(rig, &values, SLOT_diffuse, component, HALF);
        compare_slot(rig, &values, SLOT_specular, component, HALF);
        compare_slot(rig, &values, SLOT_transparency, component, HALF);
        compare_slot(rig, &values, SLOT_emissive, component, PAIR);
        compare_slot(rig, &values, SLOT_diffuseTransparency, component, PAIR);
    }
}

static void a_surface_comes_back(void **state)
{
    static const char *const texts[] = {
        "{ material: Phong, diffuse: [0.1, 0.7, 0.33], specular: [0.9, 0.21, 0.05], transparency: "
        "[0.3, 0.6, 0.01],\n"
        "  emissive: [0.2, 0.77, 0.999], diffuseTransparency: [0.45, 0.123, 0.6], shininess: "
        "0.83,\n"
        "  transparencyShininess: 0.4 }",
        "{ material: Phong, diffuse: [-3.3, 1.0e+6, 1.0e-5], specular: [7.77, -1.0e+9, 0], "
        "transparency: [2, -1, 1],\n"
        "  emissive: [5, -1, 1], diffuseTransparency: [0, 1, 1.5], shininess: 1, "
        "transparencyShininess: 0 }",
    };
    for (int k = 0; k < 2; k++) {
        double worst = 0;
        Scene scene = open_scene(*state, texts[k], &(SceneOptions){0});
        for (int i = 0; i < 40; i++) {
            float direction[3] = {spread(3 * i), spread(3 * i + 1), spread(3 * i + 2)};
            if (fabsf(direction[2]) > 0.4f)
                compare_round_trip(*state, &scene, direction, &worst);
        }
        print_message("normals come back within %.3f degrees\n", worst);
        scene_close(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_is_met),          cmocka_unit_test(a_surface_stands_in_the_world),
        cmocka_unit_test(every_attribute_arrives), cmocka_unit_test(a_sky_is_all_around),
        cmocka_unit_test(a_surface_comes_back),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
