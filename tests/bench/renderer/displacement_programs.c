/* matbench displacement, table of programs: frame time when the driver displaces triangles at
 * draw time, next to triangles that are stored displaced in a buffer. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/gpu_material/spaces.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/tessellate/scene_divide.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 512, FRAMES = 5 };

static const char text[] =
    "material: Phong\ndisplacementScale: 0.2\n"
    "displacement: { map: VolumeTurbulence, size: 3, octaves: 4, noiseRatio: 0.45 }\n";
static const char flat[] = "material: Phong\n";
static const char white[] = "#version 450 core\nlayout(location = 0) out vec4 fragment0;\nvoid "
                            "main() {\n    fragment0 = vec4(1.0);\n}\n";

typedef enum { BY_BUFFER, BY_VERTEX, BY_TESSELLATION } By;
static const struct {
    const char *name;
    By by;
    int level; /* segments per edge of a patch */
} rows[] = {{"in a buffer", BY_BUFFER, 1},
            {"vertex program", BY_VERTEX, 1},
            {"tessellation, 16", BY_TESSELLATION, 16},
            {"tessellation, 64", BY_TESSELLATION, 64}};
enum { ROWS = sizeof rows / sizeof *rows };

typedef struct {
    GlContext *gl;
    Store *store;
    MatcDocument *document;
    MatcProgram *program;
    Material material;
    Mesh mesh;
    By by;
    int level, patches; /* segments along an edge of the square */
} Drawn;

static bool make_material(Drawn *d)
{
    const char *from = d->by == BY_BUFFER ? flat : text;
    MatcOptions options;
    matc_options_init(&options);
    options.target = "glsl450";
    options.pass = "depth";
    d->document = matc_read("square.yaml", from, strlen(from), &options);
    const unsigned stages =
        d->by == BY_TESSELLATION ? MATC_TESSVERTEX | MATC_TESSCONTROL | MATC_TESSEVAL : MATC_VERTEX;
    d->program = matc_compile(d->document, 0, MATC_FRAGMENT | stages, &options);
    const ProgramText stage = {
        .vertex = {matc_output(d->program, d->by == BY_TESSELLATION ? MATC_TESSVERTEX : MATC_VERTEX,
                               NULL)},
        .control = {matc_output(d->program, MATC_TESSCONTROL, NULL)},
        .evaluation = {matc_output(d->program, MATC_TESSEVAL, NULL)},
        .fragment = {white}};
    return matc_ok(d->program) && material_make(d->store, d->program, &stage, &d->material);
}

/* A square of edge 2; in the buffer its height is a wave, whose cost is typical. */
static bool make_mesh(Drawn *d, int triangles)
{
    Shape square, divided;
    const int parts = (int)lrint(sqrt(triangles / 2.));
    d->patches = d->by == BY_TESSELLATION ? (parts + d->level - 1) / d->level : 1;
    if (!shape_make_detailed(SHAPE_plane, (int[]){d->patches, d->patches}, &square))
        return false;
    bool fine = scene_divide(&square, d->by == BY_TESSELLATION ? 1 : parts, &divided);
    for (int i = 0; fine && d->by == BY_BUFFER && i < divided.vertex_count; i++) {
        float *p = divided.vertices[i].position;
        p[2] = .1f * sinf(9 * p[0]) * cosf(7 * p[1]);
    }
    fine = fine && mesh_make_of(d->gl, &divided, &d->mesh);
    if (fine)
        shape_free(&divided);
    shape_free(&square);
    return fine;
}

/* Sets matc_levels so that edges in the middle have `level` segments. */
static void set_spaces(Drawn *d)
{
    static const float eye[3] = {0, -2.6f, 2}, target[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const Mat4 local = mat4_identity();
    const float far = 3.28f, level = (float)d->level * far * (float)d->patches / 2;
    Spaces spaces = {.world_from_local = local,
                     .eye_from_world = mat4_look_at(eye, target, up),
                     .clip_from_eye = mat4_perspective(.6f, 1, .5f, 40)};
    memcpy(spaces.eye, eye, sizeof eye);
    spaces_set(&spaces, &d->material);
    material_set(&d->material, &(MaterialValue){"matc_levelFromLocal", 16, local.m});
    material_set(&d->material, &(MaterialValue){"matc_levelEye", 3, eye});
    material_set(&d->material, &(MaterialValue){"matc_levels", 1, &level});
}

static void draw(const Drawn *d)
{
    d->gl->BindVertexArray(d->mesh.array);
    d->gl->DrawElements(d->by == BY_TESSELLATION ? GL_PATCHES : GL_TRIANGLES, d->mesh.index_count,
                        GL_UNSIGNED_INT, NULL);
    d->gl->BindVertexArray(0);
}

/* Counts triangles, and returns the minimum of seconds. */
static double measure(Drawn *d, const Framebuffer *target, double *count)
{
    const float clear[4] = {0};
    const GlContext *gl = d->gl;
    double least = INFINITY;
    GLuint query, counted = 0;
    gl->GenQueries(1, &query);
    material_use(&d->material);
    gl->Enable(GL_DEPTH_TEST);
    for (int i = 0; i < FRAMES; i++) {
        framebuffer_clear(gl, target, clear);
        gl->Finish();
        const double begin = bench_now();
        if (!i)
            gl->BeginQuery(GL_PRIMITIVES_GENERATED, query);
        draw(d);
        if (!i)
            gl->EndQuery(GL_PRIMITIVES_GENERATED);
        gl->Finish();
        least = i ? fmin(least, bench_now() - begin) : least;
    }
    gl->GetQueryObjectuiv(query, GL_QUERY_RESULT, &counted);
    gl->DeleteQueries(1, &query);
    gl->Disable(GL_DEPTH_TEST);
    *count = counted;
    return least;
}

bool displacement_programs(GlContext *gl, bool timed, int triangles)
{
    Framebuffer target;
    bool fine = framebuffer_make(gl, &(FramebufferSpec){EDGE, EDGE, 1, GL_RGBA8, true}, &target);
    printf("\ndepth of four octaves of noise on a square, %d x %d pixels: displaced as they are "
           "drawn, millions of "
           "triangles a second\n%-16s %10s %12s\n",
           EDGE, EDGE, "by", "triangles", "drawn");
    for (int i = 0; fine && i < ROWS; i++) {
        Drawn d = {.gl = gl, .store = store_new(gl), .by = rows[i].by, .level = rows[i].level};
        double count = 0, seconds = 0;
        fine = d.store && make_material(&d) && make_mesh(&d, triangles);
        if (fine) {
            set_spaces(&d);
            framebuffer_use(gl, &target);
            seconds = measure(&d, &target, &count);
            fine = gl_check(gl, "drawing displaced triangles");
        }
        if (fine)
            printf("%-16s %10.0f %12s\n", rows[i].name, count,
                   NUMBER(2, timed ? count / seconds / 1e6 : NAN));
        mesh_delete(gl, &d.mesh);
        material_delete(&d.material);
        matc_program_free(d.program);
        matc_document_free(d.document);
        store_free(d.store);
    }
    framebuffer_delete(gl, &target);
    return fine || (fprintf(stderr, "matbench: %s\n", gl->error), false);
}
