/* matbench indirect table: both tables of Thiedemann 2009, 6.2, with its parameter values, next
 * to our defaults at the same views. The reference of the column "off" is this renderer's own
 * hybrid method with 512 rays per pixel in 256 voxels along an edge, which tests compare with
 * Embree's rays. */
#include "indirect_table.h"
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include "shadows_scene.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/mesh_import/model.h"
#include "tests/meshes/meshes.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { TEXT = 8192, KEYS = 512, FRAMES = 2, FRAMES_MAX = 64, BODIES = 6, MESHES = 3 };

/* -- scenes */

typedef enum { MESH_none, MESH_bunny, MESH_dragon } BodyMesh;

/* A mesh of height `high` on the floor. A mesh without a file is replaced by a bumpy ball of
 * equally many triangles. */
typedef struct {
    BodyMesh mesh;
    int triangles;
    double x, y, high, turn;
} Body;

typedef struct {
    const char *name, *preset;
    double radius;
    int blur; /* radius of the blur in pixels, at half the width */
    Body bodies[BODIES];
    int count;
    /* the thesis' frames per second; for table 1 by points and rays in screen space and in
     * voxels */
    double direct[2], rows[6][2];
} Place;

static const Place places[] = {
    {"bunny",
     NULL,
     1.5,
     0,
     {{MESH_bunny, 69666, 0, 0, 2.6, .3}},
     1,
     {0},
     {{24.2, 79.9}, {9.6, 35.7}, {26.5, 82.2}, {13.8, 46}}},
    {"Buddha",
     "thesisBuddha",
     4,
     6,
     {{MESH_none, 200000, 0, 0, 3.4, 0}},
     1,
     {55.3, 146},
     {{1.9, 7.9}, {1.5, 6.3}, {1.8, 7.4}, {1.1, 5.9}, {5.3, 18.7}, {3.5, 16.2}}},
    {"sheep and bunny",
     "thesisSheep",
     3.5,
     5,
     {{MESH_none, 130000, -.9, .4, 2, 0}, {MESH_bunny, 69666, 1.2, -.6, 1.6, -.4}},
     2,
     {77.6, 209.9},
     {{3.9, 16.4}, {3.1, 12.9}, {3.6, 15.4}, {2.2, 12.3}, {9.3, 33}, {6.5, 29.2}}},
    {"dragons",
     "thesisDragons",
     3.5,
     6,
     {{MESH_dragon, 47794, -1.4, .9, 1.2, .5},
      {MESH_dragon, 47794, 0, 1.3, 1.2, -.2},
      {MESH_dragon, 47794, 1.4, .9, 1.2, -.9},
      {MESH_dragon, 47794, -1.3, -1, 1, .9},
      {MESH_dragon, 47794, .1, -.6, 1.1, .2},
      {MESH_dragon, 47794, 1.4, -1.1, 1, 2.6}},
     6,
     {43, 106.8},
     {{3, 11.8}, {2.4, 10}, {2.7, 11}, {1.7, 9.4}, {6.9, 23.7}, {5.1, 22}}}};
enum { PLACES = sizeof places / sizeof *places };

/* The Cornell box, 5 wide like the thesis', seen from its open side; walls are two voxels of 128
 * thick. */
static const char room[] =
    "camera: { camera: Perspective, position: [0, -9.6, 2.5], target: [0, 0, 2.5], angle: 41 "
    "}\nmaterials:\n"
    "  white: { material: Phong, diffuse: .75, specular: 0, ambient: .75 }\n"
    "  red: { material: Phong, diffuse: [.7, .1, .1], specular: 0, ambient: [.7, .1, .1] }\n"
    "  green: { material: Phong, diffuse: [.15, .5, .1], specular: 0, ambient: [.15, .5, .1] }\n"
    "lights:\n- { light: Point, position: [.4, -1, 4.4], intensity: 5, shadows: map }\n"
    "- { light: Ambient, color: [.3, .3, .3] }\nobjects:\n"
    "- { object: Box, material: white, size: [5.2, 5.2, .1], transform: { translation: [0, 0, "
    "-.05] } }\n"
    "- { object: Box, material: white, size: [5.2, 5.2, .1], transform: { translation: [0, 0, "
    "5.05] } }\n"
    "- { object: Box, material: white, size: [5.2, .1, 5.2], transform: { translation: [0, 2.55, "
    "2.5] } }\n"
    "- { object: Box, material: red, size: [.1, 5.2, 5.2], transform: { translation: [-2.55, 0, "
    "2.5] } }\n"
    "- { object: Box, material: green, size: [.1, 5.2, 5.2], transform: { translation: [2.55, 0, "
    "2.5] } }\n";
enum { WALLS = 5 };

/* Scales to height 1 from z = 0 on, above the origin. */
static void stand(Shape *shape)
{
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < 3 * shape->vertex_count; i++) {
        const float at = shape->vertices[i / 3].position[i % 3];
        low[i % 3] = fminf(low[i % 3], at);
        high[i % 3] = fmaxf(high[i % 3], at);
    }
    const float scale = 1 / (high[2] - low[2]);
    for (int i = 0; i < 3 * shape->vertex_count; i++) {
        const float origin = i % 3 == 2 ? low[2] : .5f * (low[i % 3] + high[i % 3]);
        float *at = &shape->vertices[i / 3].position[i % 3];
        *at = (*at - origin) * scale;
    }
}

/* Converts y up to z up, for a file format without an up axis. */
static void raise_z(Shape *shape)
{
    for (int i = 0; i < 2 * shape->vertex_count; i++) {
        float *components = i % 2 ? shape->vertices[i / 2].normal : shape->vertices[i / 2].position;
        const float y = components[1];
        components[1] = -components[2];
        components[2] = y;
    }
}

/* NULL: not found. */
static char *find_mesh(const IndirectTable *t, BodyMesh mesh)
{
    static const char *const names[MESHES] = {"", "bunny", "dragon-small"}, *const files[MESHES] = {
                                                                                "", "bunny.obj",
                                                                                "dragon-small.ply"};
    if (mesh == MESH_none || !t->meshes)
        return mesh == MESH_none ? NULL : meshes_path(names[mesh]);
    const size_t size = strlen(t->meshes) + strlen(files[mesh]) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s/%s", t->meshes, files[mesh]);
    return path;
}

static bool open_mesh(const IndirectTable *t, const Body *body, Shape *made)
{
    char error[4096];
    char *path = find_mesh(t, body->mesh);
    const bool ball = !path;
    bool fine =
        ball ? shadows_ball(body->triangles, made) : model_read(path, made, error, sizeof error);
    if (!fine)
        fprintf(stderr, "matbench: %s\n", ball ? "out of memory" : error);
    if (fine && body->mesh == MESH_dragon && !ball)
        raise_z(made);
    if (fine)
        stand(made);
    free(path);
    return fine;
}

/* Objects with the same mesh share it, like objects of one file. */
static bool open_meshes(const IndirectTable *t, const Place *place, SceneMesh meshes[BODIES],
                        int *count)
{
    bool fine = true;
    for (*count = 0; fine && *count < place->count; ++*count)
        if (*count && place->bodies[*count].mesh == place->bodies[*count - 1].mesh)
            break;
        else {
            meshes[*count] = (SceneMesh){.part = -1};
            fine = open_mesh(t, &place->bodies[*count], &meshes[*count].shape);
        }
    return fine;
}

/* -- what is drawn */

typedef struct {
    GlContext *gl;
    const IndirectTable *table;
    const Place *place;
    SceneMesh *meshes;
    int mesh_count;
    MatcOptions compile;
} Bench;

typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
} Drawn;

static void close_drawn(Drawn *d)
{
    renderer_close(d->render);
    if (d->scene)
        d->scene->mesh_count = 0; /* the table owns the meshes */
    scene_free(d->scene);
    matc_document_free(d->document);
}

static bool open_drawn(const Bench *b, const char *keys, const char *view, Drawn *made)
{
    char text[TEXT];
    int size = snprintf(text, sizeof text, "image: { width: %d, height: %d }\n%s\n%s",
                        b->table->edge, b->table->edge, keys, room);
    for (int i = 0; i < b->place->count; i++) {
        const Body *body = &b->place->bodies[i];
        size += snprintf(text + size, sizeof text - (size_t)size,
                         "- { object: Sphere, material: white, transform: { translation: [%g, %g, "
                         "0], rotation: [0, 0, "
                         "%g], scale: %g } }\n",
                         body->x, body->y, body->turn, body->high);
    }
    *made = (Drawn){0};
    made->document = scene_read("table.yaml", text, strlen(text), &b->compile, &made->scene);
    if (!made->scene)
        return fprintf(stderr, "matbench: %s\n", matc_diagnostics(made->document, MATC_TEXT)) < 0;
    made->scene->meshes = b->meshes;
    made->scene->mesh_count = b->mesh_count;
    for (int i = 0; i < b->place->count; i++) {
        SceneObject *object = &made->scene->objects[WALLS + i];
        object->kind = SCENE_Mesh;
        object->mesh = i < b->mesh_count ? i : b->mesh_count - 1;
    }
    made->render = renderer_open(
        b->gl, &(RendererOptions){.compile = &b->compile, .view = view, .deep = view != NULL});
    const bool fine = made->render && renderer_set_scene(made->render, made->scene) &&
                      renderer_frame(made->render);
    return fine || fprintf(stderr, "matbench: %s\n", b->gl->error) < 0;
}

/* Minimum of a few frames, more if they are short, with the camera marked as changed, so that
 * only camera-independent data is reused. */
typedef struct {
    /* CPU time of all threads, the cost of a software driver independent of other load */
    double seconds, processor;
} FrameTime;

static bool time_frame(const Bench *b, const char *keys, FrameTime *time)
{
    Drawn drawn;
    bool fine = open_drawn(b, keys, NULL, &drawn);
    *time = (FrameTime){INFINITY, INFINITY};
    const double enough = .2, start = bench_now();
    for (int i = 0; fine && i < FRAMES_MAX && (i < FRAMES || bench_now() < start + enough); i++) {
        b->gl->Finish();
        const double begin = bench_now();
        const clock_t used = clock();
        fine = renderer_changed(drawn.render, RENDERER_CAMERA) && renderer_frame(drawn.render);
        b->gl->Finish();
        time->seconds = fmin(time->seconds, bench_now() - begin);
        time->processor = fmin(time->processor, (double)(clock() - used) / CLOCKS_PER_SEC);
    }
    close_drawn(&drawn);
    return fine;
}

/* Reads indirect light, with ambient occlusion after it. */
static bool find_values(const Bench *b, const char *keys, float *rgba)
{
    Drawn drawn;
    const bool fine = open_drawn(b, keys, "indirect", &drawn) &&
                      framebuffer_read(b->gl, &drawn.render->targets.draws[FRAME_DRAW_ao], 0, rgba);
    close_drawn(&drawn);
    return fine;
}

/* Root mean square error of ambient occlusion, or of light relative to its mean. */
static double off_by(const Bench *b, const float *is, const float *want, bool light)
{
    const int pixels = b->table->edge * b->table->edge;
    double sum = 0, mean = 0;
    for (int i = 0; i < 4 * pixels; i++)
        if ((i % 4 < 3) == light) {
            const double off = (double)is[i] - (double)want[i];
            sum += off * off;
            mean += (double)want[i];
        }
    return light ? sqrt(sum * 3 * pixels) / mean : sqrt(sum / pixels);
}

/* -- rows */

typedef struct {
    const char *name, *preset; /* NULL: the place's */
    const char *keys;          /* appended to it */
    /* in Place.rows; OURS, by defaults, or DIRECT, without `indirect:` */
    int of;
    bool light, half;
} Row;
enum { OURS = -1, DIRECT = -2 };

static const Row first[] = {{"points, picture", "thesisPoints", "", 0, false, false},
                            {"rays, picture", "thesisMarch", "", 1, false, false},
                            {"points, voxels", "thesisPoints", ", march: voxels", 2, false, false},
                            {"rays, voxels", "thesisMarch", ", march: voxels", 3, false, false},
                            {"by default", NULL, "", OURS, false, false}};
static const Row second[] = {{"direct", NULL, "", DIRECT, false, false},
                             {"AO, voxels", NULL, "", 0, false, false},
                             {"AO, picture", NULL, ", march: space", 1, false, false},
                             {"AO, by default", NULL, "", OURS, false, false},
                             {"GI, voxels", NULL, "", 2, true, false},
                             {"GI, picture", NULL, ", march: space", 3, true, false},
                             {"half, voxels", NULL, "", 4, true, true},
                             {"half, picture", NULL, ", march: space", 5, true, true},
                             {"GI, by default", NULL, "", OURS, true, false}};

static void put_keys(const Place *place, const Row *row, char keys[KEYS])
{
    char base[KEYS / 4], half[KEYS / 4] = "";
    const char *preset = row->preset ? row->preset : place->preset;
    snprintf(base, sizeof base, row->of == OURS ? "radius: %g" : "preset: ", place->radius);
    if (row->half)
        snprintf(half, sizeof half, ", resolution: half, filter: separable, filterSize: %d",
                 place->blur);
    snprintf(keys, KEYS, "indirect: { %s%s%s%s%s }", row->light ? "" : "bounces: 0, ", base,
             row->of == OURS ? "" : preset, row->keys, half);
    keys[0] = row->of == DIRECT ? 0 : keys[0];
}

static bool measure_row(const Bench *b, const Row *row, const float *want, float *is)
{
    char keys[KEYS];
    const Place *place = b->place;
    const double *thesis = row->of == DIRECT ? place->direct
                           : row->of == OURS ? NULL
                                             : place->rows[row->of];
    FrameTime time = {NAN, NAN};
    put_keys(place, row, keys);
    bench_show(row->name);
    const bool fine =
        (!b->table->timed || time_frame(b, keys, &time)) && (!*keys || find_values(b, keys, is));
    bench_show("");
    if (fine)
        printf("%-16s %8s %8s %8s %8s %8s %8s  %s\n", row->name, NUMBER(1, 1e3 * time.processor),
               NUMBER(1, 1e3 * time.seconds), NUMBER(2, 1 / time.seconds),
               NUMBER(1, thesis ? thesis[0] : NAN), NUMBER(1, thesis ? thesis[1] : NAN),
               NUMBER(4, *keys ? off_by(b, is, want, row->light) : NAN),
               *keys ? keys + strlen("indirect: ") : "");
    fflush(stdout);
    return fine;
}

static int triangles_of(const Bench *b)
{
    int count = 0;
    for (int i = 0; i < b->place->count; i++)
        count += b->meshes[i < b->mesh_count ? i : b->mesh_count - 1].shape.index_count / 3;
    return count;
}

static void put_head(const Bench *b)
{
    const Place *place = b->place;
    printf("\ntable %d, %s: %d triangles in", place->preset ? 2 : 1, place->name, triangles_of(b));
    for (int i = 0; i < b->mesh_count; i++) {
        char *path = find_mesh(b->table, place->bodies[i].mesh);
        printf("%s %s", i ? "," : "", path ? strrchr(path, '/') + 1 : "a ball with bumps");
        free(path);
    }
    printf("%s; radius %g\n%-16s %8s %8s %8s %8s %8s %8s  %s\n",
           place->count > b->mesh_count ? ", six times" : "", place->radius, "", "CPU ms", "ms",
           "fps", "8600 GTS", "GTX 260", "off", "keys");
}

static bool measure_place(const Bench *b)
{
    static const char truth[] =
        "voxels: { size: 256 }\nindirect: { rays: 16, samples: 32, filter: none, radius: %g }";
    const Row *rows = b->place->preset ? second : first;
    const int count =
        b->place->preset ? sizeof second / sizeof *second : sizeof first / sizeof *first;
    const size_t pixels = (size_t)b->table->edge * (size_t)b->table->edge;
    char keys[KEYS];
    float *values = malloc(8 * pixels * sizeof *values);
    put_head(b);
    bench_show("what the others are compared with");
    snprintf(keys, sizeof keys, truth, b->place->radius);
    bool fine = values && find_values(b, keys, values);
    for (int i = 0; fine && i < count; i++)
        fine = measure_row(b, &rows[i], values, values + 4 * pixels);
    free(values);
    return fine;
}

bool bench_indirect_table(GlContext *gl, const IndirectTable *table)
{
    bool fine = true;
    printf("\nThiedemann 2009, tables 1 and 2, %d x %d, 128 voxels along an edge: least of %d "
           "frames or more, beside frames a "
           "second of its two systems; off: openness, or light over its mean\n",
           table->edge, table->edge, FRAMES);
    for (int i = 0; fine && i < PLACES; i++) {
        SceneMesh meshes[BODIES] = {{0}};
        Bench b = {gl, table, &places[i], meshes, 0, {0}};
        matc_options_init(&b.compile);
        b.compile.pixels = true;
        fine = open_meshes(table, &places[i], meshes, &b.mesh_count) && measure_place(&b);
        for (int k = 0; k < BODIES; k++)
            shape_free(&meshes[k].shape);
    }
    return fine;
}
