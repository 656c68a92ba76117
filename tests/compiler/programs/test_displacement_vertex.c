/* Positions of vertices displaced by matc's vertex programs, drawn under OSMesa, against the
 * oracle in double. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include "tests/value/move.h"
#include "tests/draw/vertices.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* of a position in the world about 2 in size: roundings of noise and of matrices */
static const double drawn_bound = 4e-6;

static double size_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* matc's vertex program, whose position is shown at a vertex's own pixel instead. */
static void wrap(const char *vertex, char *text, size_t capacity)
{
    const size_t line = strcspn(vertex, "\n") + 1;
    const int written =
        snprintf(text, capacity,
                 "%.*s#define main matc_main\n%s#undef main\nout vec3 test_position;\nvoid main() "
                 "{\n    matc_main();\n"
                 "    test_position = matc_worldPosition;\n    int i = gl_VertexID;\n"
                 "    vec2 pixel = vec2(float(i %% 8 * 8 + 5), float(i / 8 * 8 + 3)) + 0.5;\n"
                 "    gl_Position = vec4(2.0 * pixel / %d.0 - 1.0, 0.0, 1.0);\n}\n",
                 (int)line, vertex, vertex + line, SIDE);
    assert_true(written > 0 && (size_t)written < capacity);
}

/* A vertex program of our own around the function that `--emit=displace` writes. */
static void call(const char *displace, char *text, size_t capacity)
{
    const int written =
        snprintf(text, capacity,
                 "#version 330 core\nin vec3 position, displacementNormal, displacementTangentU, "
                 "displacementTangentV;\nin vec2 displacementTexcoord;\n"
                 "%s\nout vec3 test_position;\nvoid main() {\n"
                 "    test_position = matc_displaced(position, displacementNormal, "
                 "displacementTexcoord, displacementTangentU, displacementTangentV);\n"
                 "    int i = gl_VertexID;\n    vec2 pixel = vec2(float(i %% 8 * 8 + 5), float(i / "
                 "8 * 8 + 3)) + 0.5;\n"
                 "    gl_Position = vec4(2.0 * pixel / %d.0 - 1.0, 0.0, 1.0);\n}\n",
                 displace, SIDE);
    assert_true(written > 0 && (size_t)written < capacity);
}

/* A document, one of its materials, and by which of its texts points are displaced. */
typedef struct {
    MatcOutput by;
    const char *path;
    MatcDocument *document;
    MatcOptions options;
    int material;
} Case;

static void draw_vertices(Rig *rig, const Case *c, double *worst)
{
    static const char fragment[] =
        "#version 330 core\nin vec3 test_position;\nout vec4 color;\nvoid main() {\n    color = "
        "vec4(test_position, 1.0);\n}\n";
    static Vertices vertices;
    static char text[200000];
    Space space = space_camera((float[3]){2.5f, -2, 2}, (float[3]){0.1f, 0, 0}, 0.5f);
    Material drawn;
    double want[VERTICES][3];
    space_place(&space);
    vertices_make(&vertices, &space, SIDE);
    MatcProgram *program =
        matc_compile(c->document, c->material, MATC_FRAGMENT | (unsigned)c->by, &c->options);
    (c->by == MATC_DISPLACE ? call : wrap)(matc_output(program, c->by, NULL), text, sizeof text);
    assert_true(gl_use(rig->gl));
    if (!material_make(rig->store, program,
                       &(ProgramText){.vertex = {text}, .fragment = {fragment}}, &drawn))
        fail_msg("%s: %s", c->path, rig->gl->error);
    vertices_upload(&vertices, rig->gl);
    assert_true(rig_begin(rig, &rig->full));
    spaces_set(&space, &drawn);
    material_use(&drawn);
    vertices_draw(&vertices, rig->gl);
    assert_true(rig_finish(rig, &rig->full));
    assert_true(move_points(c->path, c->material, &(MovePoints){vertices.surface, VERTICES}, want));
    for (int i = 0; i < VERTICES; i++) {
        const float *is = rig->color[0][vertices.pixel[i]];
        const double miss =
            size_of((double[3]){is[0] - want[i][0], is[1] - want[i][1], is[2] - want[i][2]});
        *worst = fmax(*worst, miss);
        if (!(miss <= drawn_bound))
            fail_msg("%s, pass %s, vertex %d: %g %g %g, not %g %g %g", c->path, c->options.pass, i,
                     is[0], is[1], is[2], want[i][0], want[i][1], want[i][2]);
    }
    vertices_delete(&vertices, rig->gl);
    material_delete(&drawn);
    matc_program_free(program);
}

/* By every pass that draws a surface's triangles: shadows and depth are displaced too. And by the
 * function alone, in a stage that is written around it. */
static void vertices_stand_where_the_oracle_has_them(void **state)
{
    static const char *const documents[] = {"displacement.yaml",
                                            "channels/displacementVector.yaml",
                                            "channels/displacementPicture.yaml",
                                            "channels/displacementBound.yaml",
                                            "channels/displacementSwitch.yaml",
                                            "channels/displacementBumped.yaml",
                                            "channels/displacementVolume.yaml"};
    static const char *const passes[] = {"gbuffer", "value", "shadow", "depth"};
    double worst = 0;
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        char path[300];
        snprintf(path, sizeof path, "%s/examples/%s", SOURCE_FOLDER, documents[i]);
        static char text[10000];
        FILE *file = fopen(path, "r");
        assert_non_null(file);
        text[fread(text, 1, sizeof text - 1, file)] = 0;
        fclose(file);
        Case c = {.path = path};
        matc_options_init(&c.options);
        c.options.pixels = true;
        c.document = matc_read(path, text, strlen(text), &c.options);
        assert_true(matc_material_count(c.document) > 0);
        for (; c.material < matc_material_count(c.document); c.material++)
            for (int pass = 0; pass < 8; pass++) {
                c.options.pass = passes[pass % 4];
                c.by = pass < 4 ? MATC_VERTEX : MATC_DISPLACE;
                draw_vertices(RIG, &c, &worst);
            }
        matc_document_free(c.document);
    }
    print_message("vertices within %.1e\n", worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(vertices_stand_where_the_oracle_has_them)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
