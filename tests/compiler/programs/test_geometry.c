/* Geometry programs, drawn under OSMesa: for each target that supports them, the picture equals
 * that of the vertex program with a mesh that was subdivided before, below and above the output
 * limit of one invocation; a closed mesh has no hole; for other targets an error is reported. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include "runtime/tessellate/scene_divide.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char text[] = "material: Phong\ndisplacement: { map: VolumeTurbulence, size: 1.5, "
                           "octaves: 2, noiseRatio: 0.3 }\n"
                           "displacementScale: 0.15\n";
/* An attribute of the mesh that equals the position at the vertices: both are interpolated alike.
 * */
static const char with_attribute[] =
    "material: Phong\ndiffuse: \"= attribute('wetness', float, 0)\"\ndisplacement: { map: Gradient "
    "}\ndisplacementScale: 0.2\n";
static const char compares[] =
    "%sin vec3 localPosition;\nin float matc_attribute_wetness;\nout vec4 fragment0;\n"
    "void main() {\n    fragment0 = vec4(abs(matc_attribute_wetness - localPosition.x), "
    "matc_attribute_wetness, 0.0, 1.0);\n}\n";
static const char white[] =
    "%sout vec4 fragment0;\nvoid main() {\n    fragment0 = vec4(vec3(gl_FragCoord.z), 1.0);\n}\n";

typedef struct {
    const char *target, *version;
    bool geometry; /* or vertices of a mesh that is fine already */
    int parts, rows;
    /* `with_attribute` is drawn, of which `compares` shows how far it is from the position */
    bool attribute;
} Way;

typedef struct {
    MatcDocument *document;
    MatcProgram *program;
    Material material;
} Drawn;

static Drawn open_drawn(Rig *rig, const Way *way)
{
    char fragment[300];
    const char *document = way->attribute ? with_attribute : text;
    MatcOptions options;
    Drawn d;
    matc_options_init(&options);
    options.target = way->target;
    options.pass = way->attribute ? "gbuffer" : "depth";
    options.validate = true;
    d.document = matc_read("rock.yaml", document, strlen(document), &options);
    d.program = matc_compile(
        d.document, 0,
        MATC_FRAGMENT | (way->geometry ? MATC_GEOMETRYVERTEX | MATC_GEOMETRY : MATC_VERTEX),
        &options);
    if (!matc_ok(d.program))
        fail_msg("%s", matc_program_diagnostics(d.program, MATC_TEXT));
    snprintf(fragment, sizeof fragment, way->attribute ? compares : white, way->version);
    const ProgramText stages = {
        .vertex = {matc_output(d.program, way->geometry ? MATC_GEOMETRYVERTEX : MATC_VERTEX, NULL)},
        .geometry = {matc_output(d.program, MATC_GEOMETRY, NULL)},
        .fragment = {fragment}};
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

static void look_from(int view, int views, Drawn *d)
{
    const double z = 1 - (2 * view + 1.) / views, turn = 2.399963229728653 * view,
                 r = sqrt(1 - z * z), far = view % 2 ? 1.9 : 4;
    const float eye[3] = {(float)(far * r * cos(turn)), (float)(far * r * sin(turn)),
                          (float)(far * z)};
    Space space = space_camera(eye, (float[3]){0, 0, 0}, 0.5f);
    space.world_from_local = mat4_identity();
    spaces_set(&space, &d->material);
}

/* A ball of 40 triangles, its rows by the program or by the mesh, from each side; the pictures one
 * behind the other. */
static void draw_views(Rig *rig, const Way *way, int views, float *pictures)
{
    Shape ball, divided;
    Mesh mesh;
    Drawn d = open_drawn(rig, way);
    assert_true(gl_use(rig->gl) && shape_make_detailed(SHAPE_sphere, (int[]){8, 4}, &ball));
    assert_true(scene_divide(&ball, way->geometry ? 1 : way->parts * way->rows, &divided) &&
                mesh_make_of(rig->gl, &divided, &mesh));
    for (int view = 0; view < views; view++) {
        assert_true(rig_begin(rig, &rig->full));
        rig->gl->ClearDepth(1);
        rig->gl->Clear(GL_DEPTH_BUFFER_BIT);
        rig->gl->DepthFunc(GL_LESS);
        rig->gl->Enable(GL_CULL_FACE); /* so that rows turn as triangles do */
        look_from(view, views, &d);
        material_set_number(&d.material, "matc_rows", (float)way->rows);
        material_set_number(&d.material, "matc_parts", (float)way->parts);
        material_use(&d.material);
        rig->gl->BindVertexArray(mesh.array);
        rig->gl->DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT,
                                                   NULL,
                                                   way->geometry ? way->parts * way->parts : 1, 0);
        rig->gl->BindVertexArray(0);
        assert_true(rig_finish(rig, &rig->full));
        for (int i = 0; i < SIDE * SIDE; i++)
            pictures[(size_t)view * SIDE * SIDE + (size_t)i] = rig->color[0][i][0];
    }
    rig->gl->Disable(GL_CULL_FACE);
    mesh_delete(rig->gl, &mesh);
    shape_free(&divided);
    shape_free(&ball);
    close_drawn(&d);
}

/* Pixels of the background all of whose neighbors show the body. */
static int holes(const float *picture, int *within)
{
    int count = 0;
    for (int y = 1; y < SIDE - 1; y++)
        for (int x = 1; x < SIDE - 1; x++) {
            int around = 0;
            for (int i = 0; i < 9; i++)
                around += i != 4 && picture[(y + i / 3 - 1) * SIDE + x + i % 3 - 1] != rig_cleared;
            const bool shown = picture[y * SIDE + x] != rig_cleared;
            *within += shown;
            count += around >= 7 && !shown;
        }
    return count;
}

/* Unit normals that are mixed lose length between corners, which scene_divide gives back: it is the
 * direction that moves a point. */
static void pictures_are_those_of_divided_meshes(void **state)
{
    enum { VIEWS = 6 };
    static const struct {
        const char *target, *version;
    } targets[] = {{"glsl450", "#version 450 core\nlayout(location = 0) "},
                   {"glsl330", "#version 330 core\n"}};
    static const int divisions[][2] = {{1, 1}, {1, 2}, {1, 9}, {2, 1}, {3, 4}, {5, 3}};
    float *of[2] = {calloc(VIEWS * SIDE * SIDE, sizeof **of),
                    calloc(VIEWS * SIDE * SIDE, sizeof **of)};
    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < sizeof divisions / sizeof *divisions; k++) {
            int others = 0, within = 0, found = 0;
            Way way = {targets[i].target, targets[i].version, false,
                       divisions[k][0],   divisions[k][1],    false};
            draw_views(RIG, &way, VIEWS, of[0]);
            way.geometry = true;
            draw_views(RIG, &way, VIEWS, of[1]);
            for (int pixel = 0; pixel < VIEWS * SIDE * SIDE; pixel++)
                others += fabsf(of[0][pixel] - of[1][pixel]) > 1e-3f;
            for (int view = 0; view < VIEWS; view++)
                found += holes(&of[1][(size_t)view * SIDE * SIDE], &within);
            print_message("%s, %d parts of %d rows: %d of %d pixels differ, %d holes\n", way.target,
                          way.parts, way.rows, others, within, found);
            assert_true(within > VIEWS * 400 && found == 0 && others <= within / 500);
        }
    free(of[0]);
    free(of[1]);
}

static void attributes_are_handed_on(void **state)
{
    Rig *rig = RIG;
    const Way way = {"glsl330", "#version 330 core\n", true, 1, 4, true};
    Shape ball;
    Mesh mesh;
    Drawn d = open_drawn(rig, &way);
    double worst = 0, least = 1, most = -1;
    assert_true(gl_use(rig->gl) && shape_make_detailed(SHAPE_sphere, (int[]){8, 4}, &ball) &&
                mesh_make_of(rig->gl, &ball, &mesh));
    assert_true(rig_begin(rig, &rig->full));
    look_from(0, 2, &d);
    material_set_number(&d.material, "matc_rows", (float)way.rows);
    material_set_number(&d.material, "matc_parts", (float)way.parts);
    material_use(&d.material);
    feed_attribute(rig->gl, &mesh);
    rig->gl->DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT,
                                               NULL, 1, 0);
    rig->gl->BindVertexArray(0);
    assert_true(rig_finish(rig, &rig->full));
    for (int i = 0; i < SIDE * SIDE; i++)
        if (rig->color[0][i][3] == 1) {
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
    static const char *const cases[][2] = {
        {"essl300", "depth"}, {"glsl110", "gbuffer"}, {"glsl450", "plane"}, {"glsl330", "sky"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = cases[i][0];
        options.pass = cases[i][1];
        MatcDocument *document = matc_read("rock.yaml", text, sizeof text - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_GEOMETRY, &options);
        assert_false(matc_ok(program));
        assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT),
                               "geometry programs are not supported"));
        matc_program_free(program);
        matc_document_free(document);
    }
}

/* Vulkan's rules, and all passes. */
static void all_passes_are_valid(void **state)
{
    (void)state;
    static const char *const passes[] = {"gbuffer", "value", "depth", "displacement"};
    for (int i = 0; i < 4; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = "spirv";
        options.pass = passes[i];
        options.validate = true;
        MatcDocument *document = matc_read("rock.yaml", text, sizeof text - 1, &options);
        MatcProgram *program = matc_compile(
            document, 0, MATC_FRAGMENT | MATC_GEOMETRYVERTEX | MATC_GEOMETRY, &options);
        if (!matc_ok(program))
            fail_msg("%s: %s", passes[i], matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_those_of_divided_meshes),
        cmocka_unit_test(attributes_are_handed_on),
        cmocka_unit_test(others_have_none),
        cmocka_unit_test(all_passes_are_valid),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
