/* matbench displacement, table of speed: triangles per second that each method displaces into a
 * mesh or buffer, and triangles per second that the first pass then draws. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/displace/displaced.h"
#include "runtime/renderer/renderer.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 512, FRAMES = 5, TEXT = 2048 };

static const struct {
    const char *name;
    Keyword driver; /* driver method, into a buffer; 0: on the CPU, into a mesh */
} methods[] = {{"mesh", 0},
               {"bisection", 0},
               {"grid", KEYWORD_Displacing_grid},
               {"tessellation", KEYWORD_Displacing_tessellation},
               {"geometry", KEYWORD_Displacing_geometry}};

/* Minimum seconds of the pass surface. */
static double least_frame(GlContext *gl, Renderer *render)
{
    RendererPassTime times[RENDERER_PASSES_MAX];
    double least = INFINITY;
    for (int i = 0; i < FRAMES; i++) {
        gl->Finish();
        const int count = renderer_time_passes(render, times);
        for (int k = 0; k < count; k++)
            if (!strcmp(times[k].name, "surface"))
                least = fmin(least, times[k].seconds);
    }
    return least;
}

/* Minimum seconds until the driver has written the buffer, and its number of triangles. Negative
 * on failure. */
static double least_write(GlContext *gl, const Scene *scene, const MatcOptions *compile,
                          double *triangles)
{
    double least = INFINITY;
    Store *store = store_new(gl);
    Displaced kept = {0}; /* its programs are reused */
    Mesh mesh;
    bool fine = store && mesh_make_captured(gl, &mesh);
    for (int i = 0; fine && i < FRAMES; i++) {
        Displaced d;
        const DisplacedView view = {scene, {EDGE, EDGE}, {0}, {0}, {0}};
        fine = displaced_make(store, scene, compile, scene->objects[0].mesh, &d);
        gl->Finish();
        const double begin = bench_now();
        fine = fine && displaced_write(&d, &view, &mesh);
        gl->Finish();
        least = i ? fmin(least, bench_now() - begin) : least; /* the first run compiles */
        *triangles = mesh.index_count / 3.;
        displaced_delete(&kept);
        kept = d;
    }
    displaced_delete(&kept);
    if (store)
        mesh_delete(gl, &mesh);
    store_free(store);
    return fine ? least : -1;
}

static bool measure_method(GlContext *gl, bool timed, int row, int triangles)
{
    char text[TEXT];
    MatcOptions compile;
    MatcDocument *document;
    Scene *scene;
    matc_options_init(&compile);
    compile.pixels = true;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -2.6, "
             "2], target: [0, "
             "0, 0] }\n"
             "displacement: { method: %s, triangles: %d }\nlights: [{ light: Ambient }]\n"
             "materials: { m: { material: Phong, displacement: { map: VolumeTurbulence, size: 3, "
             "octaves: 4, "
             "noiseRatio: 0.45 }, displacementScale: 0.2 } }\n"
             "objects:\n- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: m, "
             "transform: { translation: "
             "[-1, -1, 0] } }\n",
             EDGE, EDGE, methods[row].name, triangles);
    const double begin = bench_now();
    document = scene_read("scene.yaml", text, strlen(text), &compile, &scene);
    double displaced = bench_now() - begin,
           count = scene ? scene->meshes[scene->objects[0].mesh].shape.index_count / 3. : 0;
    if (scene && methods[row].driver)
        displaced = least_write(gl, scene, &compile, &count);
    Renderer *render = scene ? renderer_open(gl, &(RendererOptions){.compile = &compile}) : NULL;
    const bool fine =
        displaced >= 0 && render && renderer_set_scene(render, scene) && renderer_frame(render);
    if (fine) {
        const double drawn = least_frame(gl, render), millions = count / 1e6;
        printf("%-12s %10.0f %12s %12s %12s\n", methods[row].name, count,
               NUMBER(3, timed ? millions / displaced : NAN),
               NUMBER(1, timed ? millions / drawn : NAN),
               NUMBER(3, timed ? millions / (displaced + drawn) : NAN));
    } else {
        fprintf(stderr, "matbench: %s\n",
                scene ? gl->error : matc_diagnostics(document, MATC_TEXT));
    }
    renderer_close(render);
    scene_free(scene);
    matc_document_free(document);
    return fine;
}

bool displacement_speed(GlContext *gl, bool timed, int triangles)
{
    bool fine = true;
    printf("\nfour octaves of noise on a square, 512 x 512 pixels: millions of triangles a "
           "second\n%-12s %10s %12s "
           "%12s %12s\n",
           "method", "triangles", "displaced", "drawn", "both");
    for (size_t i = 0; fine && i < sizeof methods / sizeof *methods; i++)
        fine = (methods[i].driver && !displaced_supported(gl, methods[i].driver)) ||
               measure_method(gl, timed, (int)i, triangles);
    return fine;
}
