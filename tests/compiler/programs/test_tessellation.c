/* Tessellation programs, drawn under OSMesa: edges whose levels differ from their neighbors'
 * leave no hole in a closed mesh, nor along the outline of patches culled by a bound; mesh
 * attributes are passed on; for targets without such programs an error is reported. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char text[] = "material: Phong\ndisplacement: { map: VolumeTurbulence, size: 1.5, "
                           "octaves: 2, noiseRatio: 0.3 }\n"
                           "displacementScale: 0.15\n";

/* An attribute of the mesh that equals the position at the vertices: their distance, and its value.
 * */
static const char with_attribute[] =
    "material: Phong\ndiffuse: \"= wet = attribute('wetness', float, 0); [abs(wet - x), wet, 1]\"\n"
    "displacement: { map: Gradient }\ndisplacementScale: 0.2\n";

static const char white[] = "#version 450 core\nlayout(location = 0) out vec4 fragment0;\nvoid "
                            "main() {\n    fragment0 = vec4(1.0);\n}\n";

typedef struct {
    MatcDocument *document;
    MatcProgram *program;
    Material material;
} Drawn;

/* `gap`: points of every other triangle stand a little aside, as they would if each triangle went
 * by itself. */
static Drawn open_drawn(Rig *rig, bool gap)
{
    static char evaluation[50000];
    MatcOptions options;
    Drawn d;
    matc_options_init(&options);
    options.target = "glsl450";
    options.pass = "depth";
    d.document = matc_read("rock.yaml", text, sizeof text - 1, &options);
    d.program =
        matc_compile(d.document, 0,
                     MATC_FRAGMENT | MATC_TESSVERTEX | MATC_TESSCONTROL | MATC_TESSEVAL, &options);
    if (!matc_ok(d.program))
        fail_msg("%s", matc_program_diagnostics(d.program, MATC_TEXT));
    const char *own = matc_output(d.program, MATC_TESSEVAL, NULL), *end = strrchr(own, '}');
    snprintf(evaluation, sizeof evaluation, "%.*s%s}\n", (int)(end - own), own,
             gap ? "    gl_Position.xy += float(gl_PrimitiveID % 2) * 0.02 * gl_Position.w;\n"
                 : "");
    const ProgramText stages = {.vertex = {matc_output(d.program, MATC_TESSVERTEX, NULL)},
                                .control = {matc_output(d.program, MATC_TESSCONTROL, NULL)},
                                .evaluation = {evaluation},
                                .fragment = {white}};
    if (!material_make(rig->store, d.program, &stages, &d.material))
        fail_msg("%s", rig->gl->error);
    return d;
}

static void close_drawn(Drawn *d)
{
    material_delete(&d->material);
    matc_program_free(d->program);
    matc_document_free(d->document);
}

static void set_uniform(Drawn *d, const char *name, int components, const float *values)
{
    if (!material_set(&d->material, &(MaterialValue){name, components, values}))
        fail_msg("no uniform is called %s", name);
}

static bool shown(const Rig *rig, int x, int y)
{
    return rig->color[0][y * SIDE + x][0] != rig_cleared;
}

/* Pixels of the background all of whose neighbors show the body. */
static int holes(const Rig *rig, int *within)
{
    int count = 0;
    for (int y = 1; y < SIDE - 1; y++)
        for (int x = 1; x < SIDE - 1; x++) {
            int around = 0;
            for (int i = 0; i < 9; i++)
                around += i != 4 && shown(rig, x + i % 3 - 1, y + i / 3 - 1);
            *within += shown(rig, x, y);
            count += around >= 7 && !shown(rig, x, y);
        }
    return count;
}

/* A ball of a few triangles, near enough that one edge has eight times the level of another. */
static int draw_views(Rig *rig, bool gap, int views, int *within)
{
    static const float levels[] = {2, 7, 19, 40};
    Shape shape;
    Mesh mesh;
    Drawn d = open_drawn(rig, gap);
    int count = 0;
    assert_true(gl_use(rig->gl) && shape_make_detailed(SHAPE_sphere, (int[]){8, 4}, &shape) &&
                mesh_make_of(rig->gl, &shape, &mesh));
    for (int view = 0; view < views; view++) {
        const double z = 1 - (2 * view + 1.) / views, turn = 2.399963229728653 * view,
                     r = sqrt(1 - z * z), far = view % 2 ? 1.9 : 4;
        const float eye[3] = {(float)(far * r * cos(turn)), (float)(far * r * sin(turn)),
                              (float)(far * z)};
        Space space = space_camera(eye, (float[3]){0, 0, 0}, 0.5f);
        space.world_from_local = mat4_identity();
        assert_true(rig_begin(rig, &rig->full));
        spaces_set(&space, &d.material);
        set_uniform(&d, "matc_levelFromLocal", 16, space.world_from_local.m);
        set_uniform(&d, "matc_levelEye", 3, eye);
        set_uniform(&d, "matc_levels", 1, &levels[view % 4]);
        material_use(&d.material);
        rig->gl->BindVertexArray(mesh.array);
        rig->gl->DrawElements(GL_PATCHES, mesh.index_count, GL_UNSIGNED_INT, NULL);
        rig->gl->BindVertexArray(0);
        assert_true(rig_finish(rig, &rig->full));
        count += holes(rig, within);
    }
    mesh_delete(rig->gl, &mesh);
    shape_free(&shape);
    close_drawn(&d);
    return count;
}

static void edges_of_other_levels_leave_no_hole(void **state)
{
    int within = 0, aside = 0;
    const int found = draw_views(RIG, false, 64, &within), torn = draw_views(RIG, true, 8, &aside);
    print_message("64 views: %d pixels within, %d holes; torn apart on purpose %d in 8\n", within,
                  found, torn);
    assert_int_equal(found, 0);
    assert_true(within > 64 * 400 && torn >= 10);
}

/* Between the corners of a patch they are mixed as the position is, before it is displaced. */
static void attributes_are_handed_on(void **state)
{
    Rig *rig = RIG;
    const float eye[3] = {0, -3, 1.5f}, levels = 5;
    Shape ball;
    Mesh mesh;
    MatcOptions options;
    Drawn d;
    double worst = 0, least = 1, most = -1;
    matc_options_init(&options);
    options.target = "glsl450";
    options.pass = "value";
    options.slot = "diffuse";
    d.document = matc_read("wet.yaml", with_attribute, sizeof with_attribute - 1, &options);
    d.program =
        matc_compile(d.document, 0,
                     MATC_FRAGMENT | MATC_TESSVERTEX | MATC_TESSCONTROL | MATC_TESSEVAL, &options);
    if (!matc_ok(d.program))
        fail_msg("%s", matc_program_diagnostics(d.program, MATC_TEXT));
    const ProgramText stages = {.vertex = {matc_output(d.program, MATC_TESSVERTEX, NULL)},
                                .control = {matc_output(d.program, MATC_TESSCONTROL, NULL)},
                                .evaluation = {matc_output(d.program, MATC_TESSEVAL, NULL)},
                                .fragment = {matc_output(d.program, MATC_FRAGMENT, NULL)}};
    if (!material_make(rig->store, d.program, &stages, &d.material))
        fail_msg("%s", rig->gl->error);
    assert_true(gl_use(rig->gl) && shape_make_detailed(SHAPE_sphere, (int[]){8, 4}, &ball) &&
                mesh_make_of(rig->gl, &ball, &mesh));
    Space space = space_camera(eye, (float[3]){0, 0, 0}, 0.5f);
    space.world_from_local = mat4_identity();
    assert_true(rig_begin(rig, &rig->full));
    spaces_set(&space, &d.material);
    set_uniform(&d, "matc_levelFromLocal", 16, space.world_from_local.m);
    set_uniform(&d, "matc_levelEye", 3, eye);
    set_uniform(&d, "matc_levels", 1, &levels);
    material_use(&d.material);
    feed_attribute(rig->gl, &mesh);
    rig->gl->DrawElements(GL_PATCHES, mesh.index_count, GL_UNSIGNED_INT, NULL);
    rig->gl->BindVertexArray(0);
    assert_true(rig_finish(rig, &rig->full));
    for (int i = 0; i < SIDE * SIDE; i++)
        if (rig->color[0][i][2] == 1) {
            worst = fmax(worst, rig->color[0][i][0]);
            least = fmin(least, rig->color[0][i][1]);
            most = fmax(most, rig->color[0][i][1]);
        }
    print_message("wetness from %.2f to %.2f, %.1e from the position at most\n", least, most,
                  worst);
    assert_true(worst < 1e-6 && least < -.5 && most > .5);
    mesh_delete(rig->gl, &mesh);
    shape_free(&ball);
    close_drawn(&d);
}

static void others_have_none(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"glsl330", "gbuffer"},
                                           {"essl300", "depth"},
                                           {"glsl110", "gbuffer"},
                                           {"glsl450", "plane"},
                                           {"glsl450", "sky"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = cases[i][0];
        options.pass = cases[i][1];
        MatcDocument *document = matc_read("rock.yaml", text, sizeof text - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_TESSEVAL, &options);
        assert_false(matc_ok(program));
        assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT),
                               "tessellation programs are not supported"));
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_of_other_levels_leave_no_hole),
        cmocka_unit_test(attributes_are_handed_on),
        cmocka_unit_test(others_have_none),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
