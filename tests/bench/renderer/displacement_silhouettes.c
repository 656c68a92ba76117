/* matbench displacement, table of silhouettes: distance of the triangles' outlines from those of
 * the surface. The surface is ray-marched through a grid so fine that its triangles are a
 * fraction of a pixel. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/renderer/renderer.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Views of the asteroid: outlines show other bumps from each side. */
static const double views[][3] = {{0, -3, .6}, {2.5, 1.7, .5}, {-2.6, 1.2, -1}, {.5, 1, 2.85}};
/* A pixel of the picture is SCALE by SCALE pixels here, so `pixels` of the methods is multiplied
 * accordingly. */
enum {
    SCALE = 4,
    EDGE = 160 * SCALE,
    PIXELS = EDGE * EDGE,
    SEARCH = 8 * SCALE,
    TEXT = 2048,
    VIEWS = sizeof views / sizeof *views
};

static const struct {
    const char *name, *how;
} rows[] = {{"grid, edges of 4", "method: grid, pixels: 16, triangles: 4000000"},
            {"grid, edges of 8", "method: grid, pixels: 32, triangles: 4000000"},
            {"tessellation, edges of 8", "method: tessellation, pixels: 32, triangles: 4000000"},
            {"bisection, 1/2 pixel", "method: bisection, pixels: 2, triangles: 1000000"},
            {"bisection, 1 pixel", "method: bisection, pixels: 4, triangles: 1000000"},
            {"bisection, 3/4, of 60000", "method: bisection, pixels: 3, triangles: 60000"},
            {"bisection, 3/8, of 60000", "method: bisection, pixels: 1.5, triangles: 60000"},
            {"traced, 1920 triangles", "method: traced, triangles: 1920"}};
enum { ROWS = sizeof rows / sizeof *rows };

typedef struct {
    bool *covered; /* for each pixel */
    long count;    /* number of covered pixels */
    int triangles; /* 0: not requested */
} Mask;

static bool fail(GlContext *gl, const Scene *scene, MatcDocument *document)
{
    fprintf(stderr, "matbench: %s\n", scene ? gl->error : matc_diagnostics(document, MATC_TEXT));
    return false;
}

static void read_mask(const float *light, Mask *mask)
{
    mask->count = 0;
    for (int i = 0; i < PIXELS; i++)
        mask->count += mask->covered[i] = light[4 * i] > .1f;
}

static bool draw_view(Renderer *render, Scene *scene, int view, float *light)
{
    memcpy(scene->camera.position, views[view], sizeof views[view]);
    return scene_camera_aim(&scene->camera) == SCENE_AIM_fine &&
           renderer_changed(render, RENDERER_CAMERA) && renderer_frame(render) &&
           renderer_read(render, light);
}

/* Draws a mask for each view. Edge blending captures the triangles. */
static bool draw(GlContext *gl, const char *how, bool counted, Mask *masks)
{
    char text[TEXT];
    MatcOptions compile;
    Scene *scene;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -3, "
             "0.6], target: [0, 0, "
             "0], angle: 34 }\n"
             "displacement: { %s }\nlights: []\n"
             "materials: { m: { material: Phong, emissive: 0.5, displacement: { map: "
             "VolumeTurbulence, size: 1.6, "
             "octaves: 5, "
             "noiseRatio: 0.45 }, displacementScale: 0.16 } }\n"
             "objects: [{ object: Sphere, radius: 0.62, detail: 12, material: m }]\n",
             EDGE, EDGE, how);
    matc_options_init(&compile);
    compile.pixels = true;
    MatcDocument *document = scene_read("scene.yaml", text, strlen(text), &compile, &scene);
    const RendererOptions options = {.compile = &compile,
                                     .view = "light",
                                     .edges =
                                         counted ? RENDERER_EDGES_coverage : RENDERER_EDGES_none};
    Renderer *render = scene ? renderer_open(gl, &options) : NULL;
    float *light = malloc(4 * (size_t)PIXELS * sizeof *light);
    bool fine = light && render && renderer_set_scene(render, scene);
    for (int view = 0; fine && view < VIEWS; view++) {
        fine = draw_view(render, scene, view, light);
        if (!fine)
            break;
        read_mask(light, &masks[view]);
        masks[view].triangles =
            counted ? scene->meshes[scene->objects[0].mesh].shape.index_count / 3 : 0;
    }
    fine = fine || fail(gl, scene, document);
    free(light);
    renderer_close(render);
    scene_free(scene);
    matc_document_free(document);
    return fine;
}

static bool is_outline(const bool *covered, int x, int y)
{
    const int at = y * EDGE + x;
    return covered[at] != covered[at + (x + 1 < EDGE)] ||
           covered[at] != covered[at + (y + 1 < EDGE ? EDGE : 0)];
}

/* Distance of a pixel from the nearest pixel of the outline, in pixels of the picture. */
static double distance_of(const bool *covered, int at)
{
    double least = SEARCH * SEARCH;
    for (int y = -SEARCH; y <= SEARCH; y++)
        for (int x = -SEARCH; x <= SEARCH; x++) {
            const int across = at % EDGE + x, up = at / EDGE + y;
            if (across >= 0 && up >= 0 && across < EDGE && up < EDGE && x * x + y * y < least &&
                is_outline(covered, across, up))
                least = x * x + y * y;
        }
    return sqrt(least) / SCALE;
}

/* Distance between two outlines: mean and maximum. */
typedef struct {
    double mean, most;
} Apart;

/* Pixels that only one mask covers lie between both outlines. */
static Apart compare(const Mask *truth, const Mask *mask)
{
    long outline = 0, between = 0;
    double most = 0;
    for (int i = 0; i < PIXELS; i++) {
        outline += is_outline(truth->covered, i % EDGE, i / EDGE);
        if (mask->covered[i] == truth->covered[i])
            continue;
        between++;
        most = fmax(most, distance_of(truth->covered, i));
    }
    return (Apart){(double)between / (double)outline / SCALE, most};
}

static void print_row(const char *name, const Mask *truth, const Mask *masks)
{
    Apart all = {0};
    double triangles = 0, pixels = 0;
    const Apart first = compare(&truth[0], &masks[0]);
    for (int view = 0; view < VIEWS; view++) {
        const Apart one = compare(&truth[view], &masks[view]);
        all.mean += one.mean / VIEWS;
        all.most = fmax(all.most, one.most);
        triangles += (double)masks[view].triangles / VIEWS;
        pixels += (double)truth[view].count / SCALE / SCALE / VIEWS;
    }
    printf("%-24s %9d %7.1f %7.3f %7.2f   %9.0f %7.1f %7.3f %7.2f\n", name, masks[0].triangles,
           (double)truth[0].count / SCALE / SCALE / (masks[0].triangles / 2.), first.mean,
           first.most, triangles, pixels / (triangles / 2), all.mean, all.most);
}

static bool make_masks(Mask masks[VIEWS])
{
    bool fine = true;
    for (int view = 0; view < VIEWS; view++) {
        masks[view].covered = malloc(PIXELS * sizeof(bool));
        fine &= masks[view].covered != NULL;
    }
    return fine;
}

bool displacement_silhouettes(GlContext *gl)
{
    Mask truth[VIEWS] = {{NULL, 0, 0}}, masks[VIEWS] = {{NULL, 0, 0}};
    const bool made[2] = {make_masks(truth), make_masks(masks)};
    bool fine = made[0] && made[1] && draw(gl, "method: traced, triangles: 250000", false, truth);
    if (fine)
        printf("\nsilhouettes of an asteroid in %d x %d pixels: triangles, pixels for each that is "
               "turned to the "
               "camera; how far its outline is from the surface's, in pixels: in the mean, at "
               "most; the same from %d "
               "sides\n"
               "%-24s %9s %7s %7s %7s   %9s %7s %7s %7s\n",
               EDGE / SCALE, EDGE / SCALE, VIEWS, "method", "triangles", "pixels", "mean", "most",
               "triangles", "pixels", "mean", "most");
    for (int i = 0; fine && i < ROWS; i++) {
        fine = draw(gl, rows[i].how, true, masks);
        if (fine)
            print_row(rows[i].name, truth, masks);
    }
    for (int view = 0; view < VIEWS; view++) {
        free(truth[view].covered);
        free(masks[view].covered);
    }
    return fine;
}
