/* matbench displacement, table of bisection: time and memory of a view that starts from the
 * triangles of the previous view and updates only what changed. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/displace/bisection/displaced_bisection.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <string.h>

enum { EDGE = 1024, VIEWS = 24, TEXT = 2048 };

static const struct {
    const char *name;
    double step; /* camera travel between two views; the square's edge is 40 */
} rows[] = {{"by 0.002", .002}, {"by 0.02", .02}, {"by 0.2", .2}};
enum { ROWS = sizeof rows / sizeof *rows };

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    MatcDocument *document;
    Scene *scene;
    Store *store;
    Mesh mesh;
    Displaced displaced;
} Bisected;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool make(Bisected *b, int triangles)
{
    char text[TEXT];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -8, "
             "1.6], target: [0, 2, "
             "0.5], angle: 50 }\n"
             "displacement: { method: bisection, pixels: 4, triangles: %d }\nlights: []\n"
             "materials: { m: { material: Phong, displacement: { map: VolumeTurbulence, size: 0.5, "
             "octaves: 6, "
             "noiseRatio: 0.48 }, displacementScale: 0.8, displacementBound: 1 } }\n"
             "objects:\n- { object: Parallelogram, u: [40, 0, 0], v: [0, 40, 0], material: m, "
             "transform: { "
             "translation: [-20, -10, 0] } }\n",
             EDGE, EDGE, triangles);
    matc_options_init(&b->compile);
    b->compile.pixels = true;
    b->document = scene_read("scene.yaml", text, strlen(text), &b->compile, &b->scene);
    b->store = store_new(b->gl);
    return b->scene && b->store && displaced_supported(b->gl, KEYWORD_Displacing_bisection) &&
           mesh_make_captured(b->gl, &b->mesh) &&
           displaced_make(b->store, b->scene, &b->compile, b->scene->objects[0].mesh,
                          &b->displaced);
}

static void end(Bisected *b)
{
    displaced_delete(&b->displaced);
    mesh_delete(b->gl, &b->mesh);
    store_free(b->store);
    scene_free(b->scene);
    matc_document_free(b->document);
}

/* CPU seconds of this program on all cores. */
static double processor_now(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* Seconds; negative on failure. */
static double write(Bisected *b)
{
    const DisplacedView view = {b->scene, {EDGE, EDGE}, {0}, {0}, {0}};
    b->gl->Finish();
    const double begin = bench_now();
    if (!displaced_write(&b->displaced, &view, &b->mesh))
        return -1;
    b->gl->Finish();
    return bench_now() - begin;
}

/* Searches the error bound that gives about the max number of triangles. */
static double find_pixels(Bisected *b, int triangles)
{
    double took = write(b);
    while (took >= 0 && displaced_bisection_cost(&b->displaced).leaves < triangles * 7 / 10) {
        b->scene->meshes[b->scene->objects[0].mesh].patches->pixels *= .9;
        b->scene->camera.position[1] += 1e-6;
        took = write(b);
    }
    return took;
}

static bool measure_row(Bisected *b, int row, bool timed)
{
    double took[VIEWS], busy[VIEWS];
    long splits = 0, merges = 0, looked = 0;
    for (int i = 0; i < VIEWS; i++) {
        b->scene->camera.position[1] += rows[row].step;
        busy[i] = -processor_now();
        took[i] = write(b);
        busy[i] += processor_now();
        if (took[i] < 0)
            return false;
        splits += displaced_bisection_cost(&b->displaced).splits;
        merges += displaced_bisection_cost(&b->displaced).merges;
        looked += displaced_bisection_cost(&b->displaced).looked;
    }
    qsort(took, VIEWS, sizeof *took, by_value);
    qsort(busy, VIEWS, sizeof *busy, by_value);
    const DisplacedBisectionCost cost = displaced_bisection_cost(&b->displaced);
    printf("%-10s %10d %10ld %10ld %10ld %10.2f %10.2f %10s %10s\n", rows[row].name, cost.leaves,
           looked / VIEWS, splits / VIEWS, merges / VIEWS, (double)cost.kept / cost.leaves,
           (double)cost.scratch / cost.leaves, NUMBER(3, timed ? 1e3 * took[VIEWS / 2] : NAN),
           NUMBER(3, timed ? 1e3 * busy[VIEWS / 2] : NAN));
    return true;
}

bool displacement_bisection(GlContext *gl, bool timed, int triangles)
{
    Bisected b = {.gl = gl};
    const bool made = make(&b, triangles);
    const double fresh = made ? find_pixels(&b, triangles) : -1;
    bool fine = fresh >= 0;
    if (fine)
        printf("\nbisection in place, a terrain of six octaves in %d x %d pixels, %d views; "
               "triangles looked at, "
               "bisected and merged a view, bytes a triangle kept and of scratch\n"
               "%-10s %10s %10s %10s %10s %10s %10s %10s %10s\n",
               EDGE, EDGE, VIEWS, "camera", "triangles", "looked at", "bisected", "merged", "kept",
               "scratch", "ms", "CPU ms");
    for (int i = 0; fine && i < ROWS; i++)
        fine = measure_row(&b, i, timed);
    if (!fine)
        fprintf(stderr, "matbench: %s\n",
                b.scene ? gl->error[0] ? gl->error : "the driver cannot bisect"
                        : matc_diagnostics(b.document, MATC_TEXT));
    end(&b);
    return fine;
}
