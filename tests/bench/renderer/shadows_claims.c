/* The thesis' claims of quality, in numbers: the error of a small map's shadow volume next to
 * large maps, the share of quads whose diagonal is right by chance, and how early a blurred
 * volume begins. */
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include "shadows.h"
#include "shadows_error.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- ends of shadows on a plane, by methods and sizes of maps */

typedef struct {
    ShadowsMethod method;
    int size;
} End;
#define HYBRID(name, volume)                                                                       \
    {                                                                                              \
        {{"hybrid", name}, KEYWORD_Shadows_hybrid, 1, KEYWORD_Volume_##volume, false,              \
         KEYWORD_Path_auto},                                                                       \
            256                                                                                    \
    }
#define MAPS(name, filter, size)                                                                   \
    {                                                                                              \
        {{name, "map"}, KEYWORD_Shadows_map, filter, KEYWORD_Volume_perfect,                       \
         false,         KEYWORD_Path_auto},                                                        \
            size                                                                                   \
    }
static const End ends[] = {HYBRID("plain", plain),     HYBRID("blurred", blurred),
                           HYBRID("perfect", perfect), MAPS("hard", 0, 256),
                           MAPS("filtered", 2, 256),   MAPS("hard", 0, 512),
                           MAPS("hard", 0, 1024),      MAPS("hard", 0, 2048)};
enum { ENDS = sizeof ends / sizeof *ends };

static bool measure_ends(const Shadows *s)
{
    const ShadowsTarget target = {s->gl, &s->compile, 1024, 256};
    ShadowsPlace place;
    ShadowsPicture picture = {0};
    bool fine = shadows_open(SHADOWS_plane, &s->mesh, &s->compile, &place) &&
                shadows_picture_open(&target, &place, &picture);
    printf("\nends: on a plane, in texels of a map of 256 x 256; steps: how much longer an end is "
           "than the true one\n"
           "%-19s %11s %11s %11s\n",
           "shadows", "map", "distance", "length");
    for (int i = 0; fine && i < ENDS; i++) {
        ShadowsError error;
        fine = shadows_picture_error(&picture, &ends[i].method, ends[i].size, &error);
        if (fine)
            printf("%-9s %-9s %11d %11.3f %11.3f\n", ends[i].method.name[0], ends[i].method.name[1],
                   ends[i].size, error.distance, error.length);
    }
    shadows_picture_close(&picture);
    shadows_close(&place);
    return fine;
}

/* -- maps */

/* A shadow map of a scene, row 0 at the bottom, from malloc; NULL after a message. */
static float *read_map(const Shadows *s, Scene *scene, const ShadowsMethod *method, int size)
{
    const RendererOptions options = {
        .compile = &s->compile, .view = "shadow", .width = 16, .height = 16};
    float *depths = malloc((size_t)size * (size_t)size * sizeof *depths);
    shadows_use(scene, method, size);
    Renderer *render = renderer_open(s->gl, &options);
    const bool done = depths && render && renderer_set_scene(render, scene) &&
                      renderer_frame(render) && renderer_read_map(render, 0, depths);
    renderer_close(render);
    if (done)
        return depths;
    free(depths);
    return fprintf(stderr, "matbench: %s\n", s->gl->error), NULL;
}

/* Quads with one corner that is not covered by casters: half of a quad is kept if the diagonal
 * does not touch that corner, else nothing. */
typedef struct {
    int ends, single, fixed,
        /* with corners of both kinds; with one uncovered; right by the fixed diagonal, by the
         * flipped one */
        turned;
} Quads;

static double square(double x) { return x * x; }

/* Corners a, b, c, d counterclockwise from the lower left; the fixed diagonal is a-c, the
 * flipped one follows volumeTurned() of shadow_volume.glsl. */
static void count_quad(const double z[4], Quads *count)
{
    int beyond = 0, which = 0;
    for (int i = 0; i < 4; i++) {
        beyond += z[i] <= 0;
        which = z[i] <= 0 ? i : which;
    }
    const double left = square(z[0] - z[3]), right = square(z[1] - z[2]),
                 lower = square(z[0] - z[1]), upper = square(z[3] - z[2]);
    const bool along_ac = (left < right && upper < lower) || (right < left && lower < upper);
    count->ends += beyond > 0 && beyond < 4;
    if (beyond != 1)
        return;
    count->single++;
    count->fixed += which % 2 == 1;
    count->turned += along_ac == (which % 2 == 1);
}

static bool measure_quads(const Shadows *s)
{
    enum { SIZE = 256 };
    ShadowsPlace place;
    Quads count = {0};
    float *map = shadows_open(SHADOWS_plane, &s->mesh, &s->compile, &place)
                     ? read_map(s, place.scene, &ends[2].method, SIZE)
                     : NULL;
    for (int y = 0; map && y + 1 < SIZE; y++)
        for (int x = 0; x + 1 < SIZE; x++) {
            const float *at = map + y * SIZE + x;
            count_quad(
                (double[]){(double)at[0], (double)at[1], (double)at[SIZE + 1], (double)at[SIZE]},
                &count);
        }
    if (map)
        printf("\nquads along ends %d, one corner beyond %d: right by a fixed diagonal %.1f %%, "
               "turned %.1f %%\n",
               count.ends, count.single, 100.0 * count.fixed / count.single,
               100.0 * count.turned / count.single);
    free(map);
    shadows_close(&place);
    return map != NULL;
}

/* -- early starts */

/* A box over a larger one, lit from above: next to the upper box, mean depths lie between both. */
static const char boxes[] =
    "image: { width: 16, height: 16 }\nmaterials: { m: { material: Phong, diffuse: .8 } }\n"
    "lights: [{ light: Directional }]\nobjects:\n"
    "- { object: Box, size: [4, 4, 1], material: m }\n"
    "- { object: Box, material: m, transform: { translation: [0, 0, 5] } }\n";

static bool measure_early(const Shadows *s)
{
    enum { SIZE = 256 };
    double ground = 1, caster = 0, edge = 0, corner = 0;
    Scene *scene;
    MatcDocument *document = scene_read("boxes.yaml", boxes, strlen(boxes), &s->compile, &scene);
    float *map = scene ? read_map(s, scene, &ends[1].method, SIZE) : NULL;
    /* the middle row crosses both; the caster's depth is in the middle */
    for (int i = 0; map && i < SIZE; i++) {
        ground = (double)map[SIZE / 2 * SIZE + 8];
        caster = (double)map[SIZE / 2 * SIZE + SIZE / 2];
    }
    /* the caster has half of the light, or more, over its own texels; beside an edge shares are
     * equal along it, beside a corner they are not */
    for (int i = SIZE + 1; map && i < SIZE * SIZE - SIZE - 1; i++) {
        const double share = ((double)map[i] - ground) / (caster - ground);
        const bool along = map[i] == map[i + 1] || map[i] == map[i - 1] ||
                           map[i] == map[i + SIZE] || map[i] == map[i - SIZE];
        if (share < .5 && share > 0)
            *(along ? &edge : &corner) = fmax(along ? edge : corner, share);
    }
    if (map)
        printf("\nblurred volumes start early by so much of the way to the caster: %.3f beside an "
               "edge, %.3f at a "
               "corner\n",
               edge, corner);
    free(map);
    scene_free(scene);
    matc_document_free(document);
    return map != NULL;
}

bool shadows_claims(const Shadows *s)
{
    return measure_ends(s) && measure_quads(s) && measure_early(s);
}
