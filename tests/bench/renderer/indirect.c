/* matbench indirect: cost of voxels: slice maps and their levels, by number of triangles; rays
 * through the levels, voxel by voxel, and by the thesis' march. Further tables: flicker along a
 * camera path (indirect_path.c), cost of passes (indirect_passes.c), time and error of qualities
 * (indirect_quality.c), tables of the thesis (indirect_table.c). */
#include "gen/render_text.h"
#include "runtime/indirect/voxels/voxels.h"
#include "indirect_passes.h"
#include "indirect_path.h"
#include "indirect_quality.h"
#include "indirect_table.h"
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include "runtime/tessellate/scene_solid.h"
#include "tests/frame/voxel_points.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 2048, FRAMES = 9, WIDE = 256, HIGH = 128, ACROSS = 4 };

typedef struct {
    GlContext *gl;
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
} Place;

/* -- a ball or a mesh on a slab, drawn once as voxels */

static void put_scene(const BenchOptions *a, int detail, char text[TEXT])
{
    char body[TEXT / 4];
    if (a->mesh)
        snprintf(body, sizeof body,
                 "{ object: Mesh, file: %s, material: m, transform: { rotation: [1.5707963, 0, 0], "
                 "translation: [0, 0, "
                 "%s] } }",
                 a->mesh, a->lift);
    else
        snprintf(body, sizeof body,
                 "{ object: Sphere, radius: 1, detail: %d, material: m, transform: { translation: "
                 "[0, 0, 1.01] } }",
                 detail);
    snprintf(text, TEXT,
             "image: { width: 16, height: 16 }\nvoxels: { size: %d }\nmaterials: { m: { material: "
             "Phong, diffuse: .6 } }\n"
             "objects:\n- { object: Box, material: m, size: [3, 3, .2], transform: { translation: "
             "[0, 0, -.1] } }\n- %s\n",
             a->voxels, body);
}

static bool open_place(GlContext *gl, const BenchOptions *a, int detail, Place *p)
{
    char text[TEXT];
    MatcOptions compile;
    matc_options_init(&compile);
    compile.pixels = true;
    put_scene(a, detail, text);
    *p = (Place){.gl = gl};
    p->document = scene_read("scene.yaml", text, strlen(text), &compile, &p->scene);
    if (!p->scene) {
        fputs(matc_diagnostics(p->document, MATC_TEXT), stderr);
        return false;
    }
    p->render = renderer_open(gl, &(RendererOptions){.compile = &compile, .view = "voxels"});
    const bool fine =
        p->render && renderer_set_scene(p->render, p->scene) && renderer_frame(p->render);
    if (!fine)
        fprintf(stderr, "matbench: %s\n", gl->error);
    return fine;
}

static void close_place(Place *p)
{
    renderer_close(p->render);
    scene_free(p->scene);
    matc_document_free(p->document);
}

static int triangles_of(const Place *p)
{
    int count = 0;
    for (int i = 0; i < p->scene->object_count; i++) {
        Shape shape = {0};
        const SceneObject *object = &p->scene->objects[i];
        if (object->kind == SCENE_Mesh)
            count += p->scene->meshes[object->mesh].shape.index_count / 3;
        else if (scene_solid(object, &shape))
            count += shape.index_count / 3;
        if (object->kind != SCENE_Mesh)
            shape_free(&shape);
    }
    return count;
}

/* -- slice maps */

static double map_time(const Place *p, int levels, int frames)
{
    FrameVoxels *voxels = p->render->voxels;
    const int kept = voxels->levels;
    double least = INFINITY;
    voxels->levels = levels;
    for (int i = 0; i < frames; i++) {
        p->gl->Finish();
        const double begin = bench_now();
        voxels->drawn = false;
        pass_voxels.draw(p->render);
        p->gl->Finish();
        least = fmin(least, bench_now() - begin);
    }
    voxels->levels = kept;
    return least;
}

/* Time of making the map's bricks for rays, relative to that of the map. */
static double bricks_time(const Place *p)
{
    double least = INFINITY;
    for (int i = 0; i < FRAMES; i++) {
        p->gl->Finish();
        const double begin = bench_now();
        voxel_bricks_draw(p->render);
        p->gl->Finish();
        least = fmin(least, bench_now() - begin);
    }
    return least;
}

/* Switches to surface voxelization: all triangles by the rasterizer, or small ones individually. */
static void make_surfaces(const Place *p, bool drawn)
{
    for (int i = 0; i < p->render->gpu_scene.place_count; i++)
        p->render->voxels->waves[i] = drawn ? 0 : voxel_bodies_surface(p->render, i);
    p->render->voxels->wave_count = 0;
}

/* The finest level of bricks, `words` words, from malloc; NULL: memory ran out. */
static uint32_t *read_bricks(const Place *p, int words)
{
    const int edge = p->render->voxels->grid.size / 4, above = (edge * edge * edge - 1) / 7;
    uint32_t *made = malloc(sizeof *made * (size_t)words);
    p->gl->BindBuffer(GL_TEXTURE_BUFFER, p->render->voxels->buffer);
    if (made)
        p->gl->GetBufferSubData(GL_TEXTURE_BUFFER, (GLintptr)sizeof *made * 2 * above,
                                (GLsizeiptr)sizeof *made * words, made);
    p->gl->BindBuffer(GL_TEXTURE_BUFFER, 0);
    return made;
}

/* Number of voxels that are full in only one of two maps; -1 if a map is missing. */
static int count_others(const uint32_t *a, const uint32_t *b, int words)
{
    int count = a && b ? 0 : -1;
    for (int i = 0; count >= 0 && i < words; i++)
        for (uint32_t word = a[i] ^ b[i]; word; word &= word - 1)
            count++;
    return count;
}

static bool measure_maps(GlContext *gl, const BenchOptions *a)
{
    static const int details[] = {264, 933};
    printf("\nslice maps of %d voxels along an edge, with bricks: least milliseconds; what the "
           "levels above take more, "
           "which "
           "views show; surfaces by the rasteriser, and voxels that are others by it; bricks "
           "alone\n%-10s %10s %10s "
           "%8s %10s %10s %8s "
           "%10s\n",
           a->voxels, "triangles", "bodies", "levels", "share", "surfaces", "drawn", "others",
           "bricks");
    for (int i = 0; i < (a->mesh ? 1 : 2); i++) {
        Place p;
        double times[4];
        uint32_t *maps[2] = {NULL, NULL};
        if (!open_place(gl, a, details[i], &p))
            return false;
        const int words = p.render->voxels->grid.size * p.render->voxels->grid.size *
                          (p.render->voxels->grid.size / 32);
        for (int k = 0; k < 4; k++) {
            if (k > 1)
                make_surfaces(&p, k > 2);
            times[k] =
                1e3 * map_time(&p, k == 1 ? p.render->voxels->levels : 1, a->timed ? FRAMES : 1);
            if (k > 1)
                maps[k - 2] = read_bricks(&p, words);
            times[k] = a->timed ? times[k] : NAN;
        }
        printf("%-10d %10s %10s %7s%% %10s %10s %8d %10s\n", triangles_of(&p), NUMBER(2, times[0]),
               NUMBER(2, times[1] - times[0]), NUMBER(1, 100 * (times[1] / times[0] - 1)),
               NUMBER(2, times[2]), NUMBER(2, times[3]), count_others(maps[0], maps[1], words),
               NUMBER(2, a->timed ? 1e3 * bricks_time(&p) : NAN));
        free(maps[0]);
        free(maps[1]);
        close_place(&p);
    }
    return true;
}

/* -- rays */

/* Points spread over triangles by number, not area, so most are on round parts. */
static bool make_points(const Place *p, VoxelPoints *points)
{
    uint32_t state = 3;
    Shape shapes[2] = {{0}};
    bool fine = voxel_points_make(WIDE, HIGH, ACROSS, points);
    for (int i = 0; fine && i < 2; i++) {
        const SceneObject *object = &p->scene->objects[i];
        if (object->kind == SCENE_Mesh)
            shapes[i] = p->scene->meshes[object->mesh].shape;
        else
            fine = scene_solid(object, &shapes[i]);
    }
    for (int i = 0; fine && i < WIDE * HIGH; i++) {
        const SceneObject *object = &p->scene->objects[i % 2];
        const Shape *shape = &shapes[i % 2];
        const double *m = object->world_from_local.m;
        double corners[3][3], world[3], normal[3], s[2];
        for (int k = 0; k < 2; k++) {
            state = state * 1664525u + 1013904223u;
            s[k] = (state >> 8) / 16777216.;
        }
        const int triangle = (int)(s[0] * (shape->index_count / 3));
        const double u = s[0] * (shape->index_count / 3) - triangle, v = (1 - u) * s[1];
        for (int k = 0; k < 9; k++) {
            const float *at = shape->vertices[shape->indices[3 * triangle + k / 3]].position;
            corners[k / 3][k % 3] =
                m[k % 3] * at[0] + m[4 + k % 3] * at[1] + m[8 + k % 3] * at[2] + m[12 + k % 3];
        }
        double edges[2][3];
        for (int k = 0; k < 3; k++) {
            edges[0][k] = corners[1][k] - corners[0][k];
            edges[1][k] = corners[2][k] - corners[0][k];
            world[k] = corners[0][k] + u * edges[0][k] + v * edges[1][k];
        }
        double length = 0;
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            normal[k] = edges[0][a] * edges[1][b] - edges[0][b] * edges[1][a];
            length += normal[k] * normal[k];
        }
        for (int k = 0; k < 3; k++)
            normal[k] /= sqrt(length);
        if (length > 0)
            voxel_points_set(points, i, &p->render->voxels->grid, world, normal);
    }
    for (int i = 0; i < 2; i++)
        if (p->scene->objects[i].kind != SCENE_Mesh)
            shape_free(&shapes[i]);
    return fine;
}

static const char by_walk[] = "bool pointRay(vec3 from, vec3 way, float far, out float count)\n{\n"
                              "    VoxelHit hit = voxelWalk(from, way, far, 0, true);\n"
                              "    count = float(hit.steps);\n    return hit.way >= 0.0;\n}\n";
static const char by_march[] =
    "bool pointRay(vec3 from, vec3 way, float far, out float count)\n{\n"
    "    float t;\n    bool met = voxelMarch(from, far * way, 32, 0.5, t);\n"
    "    count = met ? t * 32.0 - 0.5 : 32.0;\n    return met;\n}\n";

static bool measure_rays(GlContext *gl, const BenchOptions *a)
{
    static const struct {
        const char *name, *glsl[2];
    } ways[] = {{"bricks", {voxel_points_ray, NULL}},
                {"single voxels", {render_text_voxel_walk, by_walk}},
                {"march, 32 steps", {render_text_voxel_march, by_march}}};
    const double rays = (double)WIDE * HIGH * ACROSS * ACROSS;
    Place p;
    VoxelPoints points = {.wide = 0};
    static float reported[WIDE * HIGH][4];
    bool fine = open_place(gl, a, 264, &p) && make_points(&p, &points);
    printf("\nrays of a quarter of the scene, %d voxels along an edge: bricks or voxels that one "
           "reads, share that "
           "meets nothing, nanoseconds\n"
           "%-16s %8s %8s %8s\n",
           a->voxels, "by", "reads", "open", "ns");
    for (size_t i = 0; fine && i < sizeof ways / sizeof *ways; i++) {
        VoxelPointsPass pass;
        double reads = 0, open = 0, least = INFINITY;
        fine = voxel_points_open(p.render, &points, ways[i].glsl, &pass);
        for (int k = 0; fine && k < (a->timed ? 4 : 1); k++) {
            gl->Finish();
            const double begin = bench_now();
            voxel_points_run(p.render, &pass, .25f * (float)a->voxels, 0);
            gl->Finish();
            least = fmin(least, bench_now() - begin);
        }
        fine = fine && framebuffer_read(gl, &pass.target, 0, reported[0]);
        for (int k = 0; fine && k < WIDE * HIGH; k++) {
            reads += reported[k][1] / (WIDE * HIGH);
            open += reported[k][0] / (WIDE * HIGH);
        }
        if (fine)
            printf("%-16s %8.2f %8.4f %8s\n", ways[i].name, reads, open,
                   NUMBER(1, a->timed ? 1e9 * least / rays : NAN));
        voxel_points_close(p.render, &pass);
    }
    if (!fine)
        fprintf(stderr, "matbench: %s\n", gl->error);
    voxel_points_free(&points);
    close_place(&p);
    return fine;
}

static bool measure_path(GlContext *gl, const BenchOptions *a)
{
    (void)a;
    return bench_indirect_path(gl);
}

static bool measure_passes(GlContext *gl, const BenchOptions *a)
{
    return bench_indirect_passes(gl, &(IndirectPasses){a->mesh, a->lift, a->pixels, a->timed});
}

static bool measure_quality(GlContext *gl, const BenchOptions *a)
{
    return bench_indirect_quality(gl, &(IndirectQuality){a->pixels, a->timed});
}

static bool autotune_table(GlContext *gl, const BenchOptions *a)
{
    return bench_indirect_table(gl, &(IndirectTable){a->meshes, a->pixels, a->timed});
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(GlContext *, const BenchOptions *);
} tables[] = {{"maps", measure_maps},     {"rays", measure_rays},       {"path", measure_path},
              {"passes", measure_passes}, {"quality", measure_quality}, {"table", autotune_table}};
/* tables that take minutes run only if named */
enum { TABLES = sizeof tables / sizeof *tables, LONG = 3 };

const char *bench_indirect_table_name(const void *user, int i)
{
    (void)user;
    return i < TABLES ? tables[i].name : NULL;
}

const Option bench_indirect_options[] = {
    BENCH_UNTIMED,
    BENCH_GL,
    BENCH_TEXT("--mesh", mesh, "=FILE", "a mesh instead of balls; y is up"),
    BENCH_TEXT("--lift", lift, "=HEIGHT", "how far the mesh is above the ground: 0"),
    BENCH_INT("--voxels", voxels, "=N", 32, 512, "a number from 32 to 512",
              "along an edge of the grid: 128"),
    BENCH_TEXT("--meshes", meshes, "=FOLDER", "where the meshes of the thesis are"),
    BENCH_INT("--size", pixels, "=PIXELS", 16, 4096, "a number from 16 to 4096",
              "of an edge of the pictures: 512"),
    BENCH_HELP,
};

int bench_indirect(const BenchOptions *options)
{
    char error[4096];
    BenchOptions a = *options;
    a.voxels = a.voxels ? a.voxels : 128;
    a.pixels = a.pixels ? a.pixels : 512;
    a.lift = a.lift ? a.lift : "0";
    GlContext *gl = gl_open(a.gl, true, error, sizeof error);
    bool fine = gl || fprintf(stderr, "matbench: %s\n", error) < 0;
    if (fine && a.timed)
        printf("%s\n", gl->renderer);
    for (int i = 0; fine && i < TABLES; i++)
        fine = !((a.tables ? a.tables : (1u << LONG) - 1) >> i & 1) || tables[i].measure(gl, &a);
    gl_close(gl);
    return !fine;
}
