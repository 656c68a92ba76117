/* matbench displacement, the table of silhouettes: how far outlines of triangles are from those of the surface, which is traced through a grid so fine that its triangles are a fraction of a pixel. */
#include "displacement.h"
#include "matbench.h"
#include "runtime/render/render.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A pixel of the picture is SCALE by SCALE here, and so `pixels` of the methods count that much more. */
enum { SCALE = 4, EDGE = 160 * SCALE, PIXELS = EDGE * EDGE, SEARCH = 8 * SCALE, TEXT = 2048 };

static const struct {
    const char *name, *how;
} rows[] = {{"grid, edges of 4", "method: grid, pixels: 16, triangles: 4000000"},
            {"grid, edges of 8", "method: grid, pixels: 32, triangles: 4000000"},
            {"tessellation, edges of 8", "method: tessellation, pixels: 32, triangles: 4000000"},
            {"bisection, 1/2 pixel", "method: bisection, pixels: 2, triangles: 1000000"},
            {"bisection, 1 pixel", "method: bisection, pixels: 4, triangles: 1000000"},
            {"bisection, 3/4, of 60000", "method: bisection, pixels: 3, triangles: 60000"},
            {"traced, 1920 triangles", "method: traced, triangles: 1920"}};
enum { ROWS = sizeof rows / sizeof *rows };

typedef struct {
    bool *covered; /* by pixel */
    long count;    /* of these */
    int triangles; /* 0: not asked for */
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

/* Triangles come back where edges are blended. */
static bool draw(GlContext *gl, const char *how, bool counted, Mask *mask)
{
    char text[TEXT];
    MatcOptions compile;
    Scene *scene;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -3, 0.6], target: [0, 0, "
             "0], angle: 34 }\n"
             "displacement: { %s }\nlights: []\n"
             "materials: { m: { material: Phong, emissive: 0.5, displacement: { map: VolumeTurbulence, size: 1.6, "
             "octaves: 5, "
             "noiseRatio: 0.45 }, displacementScale: 0.16 } }\n"
             "objects: [{ object: Sphere, radius: 0.62, detail: 12, material: m }]\n",
             EDGE, EDGE, how);
    matc_options_init(&compile);
    compile.pixels = true;
    MatcDocument *document = scene_read("scene.yaml", text, strlen(text), &compile, &scene);
    const RenderOptions options = {
        .compile = &compile, .view = "light", .edges = counted ? RENDER_EDGES_coverage : RENDER_EDGES_none};
    Render *render = scene ? render_open(gl, &options) : NULL;
    float *light = malloc(4 * (size_t)PIXELS * sizeof *light);
    const bool fine =
        (light && render && render_scene(render, scene) && render_frame(render) && render_read(render, light)) ||
        fail(gl, scene, document);
    if (fine) {
        read_mask(light, mask);
        mask->triangles = counted ? scene->meshes[scene->objects[0].mesh].shape.index_count / 3 : 0;
    }
    free(light);
    render_close(render);
    scene_free(scene);
    matc_document_free(document);
    return fine;
}

static bool is_outline(const bool *covered, int x, int y)
{
    const int at = y * EDGE + x;
    return covered[at] != covered[at + (x + 1 < EDGE)] || covered[at] != covered[at + (y + 1 < EDGE ? EDGE : 0)];
}

/* From a pixel to the nearest of the outline, in pixels of the picture. */
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

/* Every pixel that one has and the other has not is between both outlines. */
static void print_row(const char *name, const Mask *truth, const Mask *mask)
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
    printf("%-24s %10d %10.1f %10.3f %10.2f\n", name, mask->triangles,
           (double)truth->count / SCALE / SCALE / (mask->triangles / 2.), (double)between / (double)outline / SCALE,
           most);
}

bool displacement_silhouettes(GlContext *gl)
{
    Mask truth = {malloc(PIXELS * sizeof(bool)), 0, 0}, mask = {malloc(PIXELS * sizeof(bool)), 0, 0};
    bool fine = truth.covered && mask.covered && draw(gl, "method: traced, triangles: 250000", false, &truth);
    if (fine)
        printf("\nsilhouettes of an asteroid in %d x %d pixels: triangles, pixels for each that is turned to the "
               "camera; how far its "
               "outline is from the surface's, in pixels: in the mean, at most\n%-24s %10s %10s %10s %10s\n",
               EDGE / SCALE, EDGE / SCALE, "method", "triangles", "pixels", "mean", "most");
    for (int i = 0; fine && i < ROWS; i++) {
        fine = draw(gl, rows[i].how, true, &mask);
        if (fine)
            print_row(rows[i].name, &truth, &mask);
    }
    free(truth.covered);
    free(mask.covered);
    return fine;
}
