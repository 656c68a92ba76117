/* Ray-marched displacement, drawn under OSMesa: a wave against its closed form, marched in
 * double; a ball and a box of rock against Embree's rays through meshes that the C reference
 * displaced finely; shadow maps; exact shadows, which use the grid instead. */
/* ctest: seconds=20 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_ray.h"
#include <stdio.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE };

#define WAVE "0.15"
static const char materials[] =
    "materials:\n"
    "  wave: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: " WAVE
    ", displacement: { map: Gradient, direction: [7, 3, 0], waveForm: Sin } }\n"
    "  rock: { material: Phong, diffuse: { map: Checker, input: { map: UVTransform, "
    "scaleU: 9, scaleV: 7 } }, emissive: 0.2, displacementScale: 0.2,\n"
    "    displacement: { map: VolumeTurbulence, size: 2, octaves: 2, noiseRatio: 0.5 } }\n"
    "  leaning: { material: Phong, diffuse: 0.6, displacementVector: "
    "'= [.15 * sin(5 * x), .15 * cos(4 * y), .12 * sin(3 * x + 4 * y)]' }\n"
    "  slab: { material: Phong, displacementVolume: '= [0, .4, 0, 0]' }\n"
    "  floor: { material: Phong, diffuse: 0.6, emissive: 0.2 }\n";
static const char square[] =
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: wave, transform: { "
    "translation: [-1, -1, 0] } }\n";
#define BALL "- { object: Sphere, radius: 0.9, material: rock, detail: 12"
static const char ball[] = BALL " }\n";
static const char box[] =
    "- { object: Box, size: [1.4, 1.4, 1.4], material: rock, transform: { rotation: [0.3, 0.5, "
    "0.1], scale: [1, 1, -1] } }\n";
static const char slab[] =
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: slab }\n";
static const char ground[] =
    "- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: floor, transform: { "
    "translation: [-4, -4, -1] } }\n";

typedef struct {
    const char *how, *camera, *lights, *objects, *more;
} SceneText;

static Scene *open_scene(const SceneText *of, const MatcOptions *options, MatcDocument **document)
{
    char text[4000];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { %s }\nshadowMaps: { size: 256 "
             "}\n%sdisplacement: { %s "
             "}\nlights: [%s]\nobjects:\n%s%s",
             EDGE, EDGE, of->camera, materials, of->how, of->lights, of->objects,
             of->more ? of->more : "");
    return frame_scene(text, options, document);
}

static Renderer *open_traced(GlContext *gl, const MatcOptions *options, const char *view)
{
    Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = options, .view = view});
    assert_non_null(renderer);
    return renderer;
}

/* Drawn by a renderer that has drawn others of that view, so that programs are reused. */
static float *picture(GlContext *gl, Renderer *renderer, const SceneText *of)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = open_scene(of, &options, &document);
    float *made = frame_floats_by(gl, renderer, scene);
    frame_forget(scene, document);
    return made;
}

/* Errors of a picture: distances where both hit the object; and the number of pixels that only
 * one hits. */
typedef struct {
    double off[PIXELS];
    int count, disagree;
} Judged;

static void judge(Judged *judged, double distance, double truth)
{
    if (isfinite(distance) != isfinite(truth))
        judged->disagree++;
    else if (isfinite(truth))
        judged->off[judged->count++] = fabs(distance - truth);
}

static double quantile(Judged *judged, double share)
{
    qsort(judged->off, (size_t)judged->count, sizeof *judged->off, ascending);
    return judged->off[(int)(share * (judged->count - 1))];
}

/* -- the closed form */

static double above(const Ray *ray, double t)
{
    const double x = ray->at[0] + t * ray->way[0] + 1, y = ray->at[1] + t * ray->way[1] + 1;
    return ray->at[2] + t * ray->way[2] - strtod(WAVE, NULL) * sin(7 * x + 3 * y);
}

/* Distance at which the ray first passes below the wave over the square; infinite: never. */
static double march(const Ray *ray)
{
    enum { STEPS = 400, HALVES = 50 };
    const double begin = (.16 - ray->at[2]) / ray->way[2], end = (-.16 - ray->at[2]) / ray->way[2];
    for (int i = 0; i < STEPS; i++) {
        double low = begin + (end - begin) * i / STEPS,
               high = begin + (end - begin) * (i + 1) / STEPS;
        if (above(ray, low) < 0 || above(ray, high) >= 0)
            continue;
        for (int k = 0; k < HALVES; k++)
            *(above(ray, (low + high) / 2) < 0 ? &high : &low) = (low + high) / 2;
        const double x = ray->at[0] + low * ray->way[0], y = ray->at[1] + low * ray->way[1];
        return fabs(x) < 1 && fabs(y) < 1 ? low : INFINITY;
    }
    return INFINITY;
}

/* True distance at a pixel. NAN near an outline, where rays a third of a pixel away hit another
 * place. */
static double find_truth(const Scene *scene, int k)
{
    const Ray middle = reference_ray(scene, k % EDGE + .5, k / EDGE + .5);
    const double truth = march(&middle);
    for (int i = 0; i < 4; i++) {
        const Ray ray = reference_ray(scene, k % EDGE + .5 + (i & 1 ? .3 : -.3),
                                      k / EDGE + .5 + (i & 2 ? .3 : -.3));
        const double other = march(&ray);
        if (isfinite(other) != isfinite(truth) || (isfinite(truth) && fabs(other - truth) > .1))
            return NAN;
    }
    return truth;
}

/* From the side, so that crests hide surfaces behind them. A grid of 32 segments has the error
 * of its triangles; ray marching only that of floats. */
static void a_wave_is_that_of_its_closed_form(void **state)
{
    (void)state;
    static const char *const how[] = {"method: traced, level: 32", "method: grid, level: 32",
                                      "method: parallax, level: 32"};
    static Judged judged[3];
    static double truths[PIXELS]; /* NAN: beside an outline */
    const char camera[] =
        "camera: Perspective, position: [0.4, -2.6, 0.8], target: [0, 0, 0], angle: 45";
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer = open_traced(gl, &options, "depth");
    for (int i = 0; i < 3; i++) {
        const SceneText text = {how[i], camera, "", square, NULL};
        MatcDocument *document;
        Scene *scene = open_scene(&text, &options, &document);
        float *depth = frame_floats_by(gl, renderer, scene);
        for (int k = 0; k < PIXELS; k++) {
            if (i == 0)
                truths[k] = find_truth(scene, k);
            if (!isnan(truths[k]))
                judge(&judged[i], scene->camera.near / (double)depth[4 * k], truths[k]);
        }
        free(depth);
        frame_forget(scene, document);
        print_message("%-26s %d pixels, half within %.2g, 99 %% within %.2g; %d at outlines\n",
                      how[i], judged[i].count, quantile(&judged[i], .5), quantile(&judged[i], .99),
                      judged[i].disagree);
    }
    renderer_close(renderer);
    gl_close(gl);
    assert_true(judged[0].count > PIXELS / 5);
    assert_true(quantile(&judged[0], .5) < 1e-6 && quantile(&judged[0], .99) < 1e-5 &&
                judged[0].disagree <= 2);
    assert_true(quantile(&judged[1], .5) > 1e-4);
    assert_true(quantile(&judged[2], .5) < 1e-5);
}

/* -- against meshes, finely divided */

/* An object, and the subdivisions of its reference and of the others. */
typedef struct {
    const char *body, *fine, *traced, *grid;
    int outlines; /* pixels that only one has, at most: what closes hard edges has many */
} Body;

static void judge_body(const Scene *scene, const Tracer *tracer, const float *depth, Judged *judged)
{
    for (int k = 0; k < PIXELS; k++) {
        const Ray ray = reference_ray(scene, k % EDGE + .5, k / EDGE + .5);
        const Hit hit = reference_hit(tracer, &ray, 0);
        judge(judged, scene->camera.near / (double)depth[4 * k],
              hit.object < 0 ? INFINITY : hit.distance);
    }
}

static void judge_normals(const float *normal, const float *wanted, Judged *judged)
{
    for (int k = 0; k < PIXELS; k++) {
        double off = 0;
        for (int component = 0; component < 3; component++)
            off = fmax(off,
                       fabs((double)normal[4 * k + component] - (double)wanted[4 * k + component]));
        if (normal[4 * k + 3] > 0 && wanted[4 * k + 3] > 0)
            judged->off[judged->count++] = off;
    }
}

/* Distances by Embree's rays, and normals, of an object with a curved base, and of a mirrored
 * one with hard edges: the error is that of the reference's own triangles. */
static void bodies_are_those_of_fine_meshes(void **state)
{
    (void)state;
    static const Body bodies[] = {
        {ball, "method: mesh, level: 16", "method: traced, level: 4", "method: grid, level: 4", 12},
        {box, "method: mesh, level: 64", "method: traced, level: 16", "method: grid, level: 16",
         40}};
    const char camera[] = "camera: Perspective, position: [1, -3, 2], angle: 40";
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *depth = open_traced(gl, &options, "depth"),
             *normals_of = open_traced(gl, &options, "normal");
    for (int i = 0; i < 2; i++) {
        static Judged traced, grid, normals;
        const SceneText fine = {bodies[i].fine, camera, "", bodies[i].body, NULL},
                        by_rays = {bodies[i].traced, camera, "", bodies[i].body, NULL},
                        by_grid = {bodies[i].grid, camera, "", bodies[i].body, NULL};
        MatcDocument *document;
        Scene *scene = open_scene(&fine, &options, &document);
        Tracer tracer = reference_open(scene);
        float *of_fine = picture(gl, normals_of, &fine),
              *normal = picture(gl, normals_of, &by_rays),
              *depths[2] = {picture(gl, depth, &by_rays), picture(gl, depth, &by_grid)};
        traced.count = grid.count = normals.count = traced.disagree = 0;
        judge_body(scene, &tracer, depths[0], &traced);
        judge_body(scene, &tracer, depths[1], &grid);
        judge_normals(normal, of_fine, &normals);
        print_message("%s: half within %.2g, 95 %% within %.2g; the grid %.2g, %.2g; normals %.2g, "
                      "%.2g; of %d pixels "
                      "%d at outlines\n",
                      bodies[i].traced, quantile(&traced, .5), quantile(&traced, .95),
                      quantile(&grid, .5), quantile(&grid, .95), quantile(&normals, .5),
                      quantile(&normals, .95), traced.count, traced.disagree);
        reference_close(&tracer);
        free(depths[0]);
        free(depths[1]);
        free(normal);
        free(of_fine);
        frame_forget(scene, document);
        assert_true(traced.count > 500 && traced.disagree <= bodies[i].outlines);
        assert_true(8 * quantile(&traced, .5) < quantile(&grid, .5));
        assert_true(quantile(&normals, .5) < 2e-3);
    }
    renderer_close(depth), renderer_close(normals_of), gl_close(gl);
}

/* Further options of scenes: vectors, corners that are pushed out, parallel rays, instances that
 * are smaller or mirrored. A grid as fine as its edges allow is the truth. */
static const struct {
    const char *name, *fine, *coarse, *camera, *objects;
} ways[] = {{"vectors", "level: 64", "level: 16",
             "camera: Perspective, position: [0.4, -2.6, 1.4], target: [0, 0, 0], angle: 45",
             "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: leaning, transform: "
             "{ translation: [-1, "
             "-1, 0] } }\n"},
            {"push", "level: 64, push: 0.4", "level: 16, push: 0.4",
             "camera: Perspective, position: [1, -3, 2], angle: 50", box},
            {"bulge", "level: 64, bulge: 0.75", "level: 16, bulge: 0.75",
             "camera: Perspective, position: [1, -3, 2], angle: 50", box},
            {"parallel rays", "level: 32", "level: 4",
             "camera: Orthographic, position: [1, -3, 2], size: 2.6", ball},
            {"instances", "level: 32", "level: 4",
             "camera: Perspective, position: [1, -3, 2], angle: 50",
             BALL ", transform: { scale: 0.6, translation: [-0.8, 0, 0] } }\n" BALL
                  ", transform: { scale: [0.5, -0.7, 0.6], translation: [0.7, 0, 0.2], rotation: "
                  "[0.4, 1, 2] } }\n"}};

/* Relative errors of distances; of parallel rays, of depths. */
static void judge_depths(const float *depth, const float *wanted, Judged *judged)
{
    judged->count = judged->disagree = 0;
    for (int k = 0; k < PIXELS; k++) {
        const double is = (double)depth[4 * k], was = (double)wanted[4 * k];
        judge(judged, is > 0 ? -log(is) : INFINITY, was > 0 ? -log(was) : INFINITY);
    }
}

static void all_ways_are_traced(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer = open_traced(gl, &options, "depth");
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        static const char *const methods[] = {"grid", "grid", "traced"};
        static Judged traced, grid;
        float *depths[3];
        for (int k = 0; k < 3; k++) {
            char how[100];
            snprintf(how, sizeof how, "method: %s, %s", methods[k],
                     k ? ways[i].coarse : ways[i].fine);
            depths[k] =
                picture(gl, renderer, &(SceneText){how, ways[i].camera, "", ways[i].objects, NULL});
        }
        judge_depths(depths[1], depths[0], &grid);
        judge_depths(depths[2], depths[0], &traced);
        print_message("%-14s half within %.2g, the grid %.2g; of %d pixels %d at outlines\n",
                      ways[i].name, quantile(&traced, .5), quantile(&grid, .5), traced.count,
                      traced.disagree);
        for (int k = 0; k < 3; k++)
            free(depths[k]);
        assert_true(traced.count > 400 && traced.disagree <= 20);
        assert_true(4 * quantile(&traced, .5) < quantile(&grid, .5));
    }
    renderer_close(renderer);
    gl_close(gl);
}

/* In tiles a picture is unchanged, except where a pixel's center is on an edge. */
static void tiles_are_traced(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const SceneText text = {"method: traced, level: 4",
                            "camera: Perspective, position: [1, -3, 2], angle: 45", "", ball, NULL};
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene = open_scene(&text, &options, &document);
    RendererOptions renderer = {.compile = &options, .view = "depth"};
    float *whole = frame_floats(gl, scene, &renderer);
    renderer.tile[0] = 34;
    renderer.tile[1] = 22;
    float *parts = frame_tiles(gl, scene, &renderer);
    static Judged judged;
    judge_depths(parts, whole, &judged);
    assert_true(judged.count > 500 && judged.disagree <= PIXELS / 400 &&
                quantile(&judged, .99) < 1e-5);
    free(whole);
    free(parts);
    frame_forget(scene, document);
    gl_close(gl);
}

/* -- other passes */

static int differing(const float *a, const float *b)
{
    int count = 0;
    for (int i = 0; i < PIXELS; i++)
        count += fabsf(a[4 * i] - b[4 * i]) > .02f;
    return count;
}

/* Sun, lamp and area light over an object and the ground: shadows equal those of a fine mesh,
 * and are nearer to them than a grid's. */
static void shadow_maps_see_what_is_traced(void **state)
{
    (void)state;
    static const char *const lights[] = {
        "{ light: Directional, direction: [1, 0.6, -1] }",
        "{ light: Point, position: [-1, -2, 3], intensity: 12, shadows: map }",
        "{ light: Area, position: [-1, -2, 3], u: [0, 0.6, 0], v: [0.6, 0, 0], intensity: 40 }"};
    const char camera[] = "camera: Perspective, position: [1, -3, 2], angle: 60";
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer = open_traced(gl, &options, "light");
    for (int i = 0; i < 3; i++) {
        static const char *const how[] = {"method: mesh, level: 16", "method: traced, level: 4",
                                          "method: grid, level: 4"};
        float *light[3];
        for (int k = 0; k < 3; k++)
            light[k] = picture(gl, renderer, &(SceneText){how[k], camera, lights[i], ball, ground});
        const int traced = differing(light[0], light[1]), grid = differing(light[0], light[2]);
        print_message("%s: %d of %d pixels differ; of a grid %d\n", lights[i], traced, PIXELS,
                      grid);
        assert_true(2 * traced < grid && traced < PIXELS / 50);
        for (int k = 0; k < 3; k++)
            free(light[k]);
    }
    renderer_close(renderer);
    gl_close(gl);
}

/* Checks whether --stats has the line. */
static void says(GlContext *gl, const SceneText *of, const char *line, bool wanted)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = open_scene(of, &options, &document);
    char *graph =
        frame_graph_or_fault(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    const char *at = strstr(graph, wanted ? line : "\ntraced the");
    if ((at != NULL) != wanted)
        fail_msg("'%s' in %s", line, graph);
    free(graph);
    frame_forget(scene, document);
}

/* Methods that need triangles use the grid: bit for bit. */
static void exact_shadows_have_the_grid(void **state)
{
    (void)state;
    static const char *const how[] = {"method: grid, level: 4", "method: traced, level: 4"};
    const char camera[] = "camera: Perspective, position: [1, -3, 2], angle: 60",
               exact[] = "{ light: Directional, direction: [1, 0.6, -1], shadows: exact }";
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer = open_traced(gl, &options, "light");
    float *light[2];
    for (int k = 0; k < 2; k++)
        light[k] = picture(gl, renderer, &(SceneText){how[k], camera, exact, ball, ground});
    assert_memory_equal(light[0], light[1], 4 * PIXELS * sizeof(float));
    says(gl, &(SceneText){how[0], camera, exact, ball, ground}, "", false);
    says(gl, &(SceneText){how[1], camera, exact, ball, ground},
         "traced none, triangles are drawn: a shadow technique reads triangle ids\n", true);
    says(gl, &(SceneText){how[1], camera, "{ light: Directional, shadows: hybrid }", ball, ground},
         "traced the surface of 1 mesh; not so, but its grid's triangles: hybrid shadows\n", true);
    says(gl, &(SceneText){"method: traced, level: 20", camera, "", slab, NULL},
         "volume slab: what is thinner than 0.11 across, or 0.1 along the normal, may be missed\n",
         true);
    free(light[0]);
    free(light[1]);
    renderer_close(renderer);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_is_that_of_its_closed_form),
        cmocka_unit_test(bodies_are_those_of_fine_meshes),
        cmocka_unit_test(all_ways_are_traced),
        cmocka_unit_test(tiles_are_traced),
        cmocka_unit_test(shadow_maps_see_what_is_traced),
        cmocka_unit_test(exact_shadows_have_the_grid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
