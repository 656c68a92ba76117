/* Ambient occlusion of points by rays through voxels, against the same rays by Embree: closed
 * meshes voxelized as solids and as surfaces, by the rays' start offset. Prints the table of
 * docs/results/indirect.md. `build/tests/test_frame_voxel_open FILE.obj LIFT` uses that mesh, y
 * up, LIFT above the ground. */
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_ray.h"
#include "tests/frame/voxel_points.h"
#include <math.h>
#include <stdio.h>

enum { WIDE = 96, HIGH = 72, PIXELS = WIDE * HIGH, ACROSS = 16, TEXT = 2048 };

/* Closed meshes, each slightly above the ground: voxels in the overlap of two meshes would be
 * empty. */
#define BODIES                                                                                     \
    "- { object: Sphere, radius: .5, detail: 96, material: m, transform: { translation: [-.5, "    \
    ".1, .501] } }\n"                                                                              \
    "- { object: Cylinder, detail: 48, radius: .3, material: m, transform: { translation: [.5, "   \
    ".5, .001] } }\n"                                                                              \
    "- { object: Box, material: m, size: [.5, .4, .7], transform: { translation: [.4, -.5, .36], " \
    "rotation: [0, 0, "                                                                            \
    ".5] } }\n"                                                                                    \
    "- { object: Cone, detail: 48, radius: .3, material: m, transform: { translation: [1.1, -.1, " \
    ".001] } }\n"
static const char *mesh_file, *mesh_lift = "0";
static VoxelPoints points;
static float reported[PIXELS][4];
static double truth[PIXELS];

typedef struct {
    MatcOptions options;
    MatcDocument *document;
    Scene *scene;
    GlContext *gl;
    Renderer *renderer;
    double radius;
} Place;

static Place place_of(int size)
{
    Place p = {.options = frame_exact_options(), .gl = frame_context()};
    char text[TEXT], mesh[TEXT / 4] = BODIES;
    if (mesh_file)
        snprintf(mesh, sizeof mesh,
                 "- { object: Mesh, file: %s, material: m, transform: { rotation: [1.5707963, 0, "
                 "0], translation: [0, "
                 "0, %s] } }\n",
                 mesh_file, mesh_lift);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [.6, "
             "-4.6, 2.6], target: [0, "
             "0, .7], angle: 40 }\n"
             "voxels: { size: %d }\nmaterials: { m: { material: Phong, diffuse: .6 } }\nobjects:\n"
             "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, "
             "-.1] } }\n%s",
             WIDE, HIGH, size, mesh);
    p.scene = frame_scene(text, &p.options, &p.document);
    p.renderer = renderer_open(p.gl, &(RendererOptions){.compile = &p.options, .view = "voxels"});
    assert_true(p.renderer && renderer_set_scene(p.renderer, p.scene) &&
                renderer_frame(p.renderer));
    const VoxelGrid *grid = &p.renderer->voxels->grid;
    p.radius = .25 * grid->edge * (grid->size - 2);
    return p;
}

static void forget(Place *p)
{
    renderer_close(p->renderer);
    frame_forget(p->scene, p->document);
    gl_close(p->gl);
}

/* -- points of the picture, and rays from them */

static double open_by_rays(const Place *p, const Tracer *tracer, const Hit *hit, int number)
{
    float(*texels)[4] = points.texels[number];
    double from[3], open = 0;
    for (int i = 0; i < 3; i++)
        from[i] = hit->world[i] + 3e-5 * hit->microfacet[i];
    for (int k = 0; k < points.rays; k++) {
        const float *d = points.directions[k];
        double way[3];
        for (int i = 0; i < 3; i++)
            way[i] = d[0] * texels[1][i] + d[1] * texels[2][i] + d[2] * texels[3][i];
        open += !reference_is_blocked(tracer, from, way, p->radius);
    }
    return open / points.rays;
}

/* Uses the geometric normal, because rays below the surface would be a different case. */
static void make_points(const Place *p)
{
    Tracer tracer = reference_open(p->scene);
    assert_true(voxel_points_make(WIDE, HIGH, ACROSS, &points));
    for (int i = 0; i < PIXELS; i++) {
        const Ray ray = reference_ray(p->scene, i % WIDE + .5, i / WIDE + .5);
        Hit hit = reference_hit(&tracer, &ray, 0);
        if (hit.object < 0)
            continue;
        for (int k = 0, away = reference_dot(hit.microfacet, ray.way) > 0; k < 3; k++)
            hit.microfacet[k] *= away ? -1 : 1;
        voxel_points_set(&points, i, &p->renderer->voxels->grid, hit.world, hit.microfacet);
        truth[i] = open_by_rays(p, &tracer, &hit, i);
    }
    reference_close(&tracer);
}

static void by_voxels(const Place *p, double off)
{
    VoxelPointsPass pass;
    if (!voxel_points_open(p->renderer, &points, (const char *[2]){voxel_points_ray, NULL}, &pass))
        fail_msg("%s", p->gl->error);
    voxel_points_run(p->renderer, &pass, (float)(p->radius / p->renderer->voxels->grid.edge),
                     (float)off);
    assert_true(framebuffer_read(p->gl, &pass.target, 0, reported[0]));
    voxel_points_close(p->renderer, &pass);
}

typedef struct {
    double error, bias, steps; /* root of the mean square, mean; words that a ray reads */
} Result;

static Result compare(void)
{
    Result result = {0};
    int count = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (points.texels[i][0][3] == 0)
            continue;
        const double off = reported[i][0] - truth[i];
        result.error += off * off;
        result.bias += off;
        result.steps += reported[i][1];
        count++;
    }
    assert_true(count > PIXELS / 3);
    return (Result){sqrt(result.error / count), result.bias / count, result.steps / count};
}

/* Switches to surface voxelization. */
static void make_surfaces(Place *p)
{
    FrameVoxels *voxels = p->renderer->voxels;
    for (int i = 0; i < p->renderer->gpu_scene.place_count; i++) {
        assert_true(voxel_bodies_is_body(voxels, i));
        voxels->waves[i] = voxel_bodies_surface(p->renderer, i);
    }
    voxels->wave_count = 0;
    voxels->drawn = false;
    assert_true(renderer_frame(p->renderer));
}

/* Offsets from the surface, in voxels; 0: that of voxelStart. */
static const double offs[] = {0, .5, .75, 1, 1.8};
enum { OFFS = sizeof offs / sizeof *offs };

static void rays_are_as_open_as_exact_ones(void **state)
{
    (void)state;
    static const int sizes[] = {64, 128, 256};
    /* of bodies, of surfaces */
    static const double bounds[][2] = {{.032, .048}, {.017, .029}, {.013, .018}};
    print_message("%-10s", "voxels");
    for (int k = 0; k < 2 * OFFS; k++)
        print_message(" %7s %4.2g", k < OFFS ? "body" : "surface", offs[k % OFFS]);
    print_message("  words a ray\n");
    for (int i = 0; i < 3; i++) {
        Place p = place_of(sizes[i]);
        Result results[2 * OFFS];
        make_points(&p);
        for (int k = 0; k < 2 * OFFS; k++) {
            if (k == OFFS)
                make_surfaces(&p);
            by_voxels(&p, offs[k % OFFS]);
            results[k] = compare();
        }
        print_message("%-10d", sizes[i]);
        for (int k = 0; k < 2 * OFFS; k++)
            print_message("  %5.3f %+5.3f", results[k].error, results[k].bias);
        print_message("  %.1f\n", results[0].steps);
        for (int k = 1; k < OFFS; k++) /* no other is as good, but by chance */
            assert_true(results[0].error <= 1.05 * results[k].error &&
                        results[OFFS].error <= 1.1 * results[OFFS + k].error);
        if (!mesh_file)
            assert_true(results[0].error <= bounds[i][0] && results[OFFS].error <= bounds[i][1]);
        voxel_points_free(&points);
        forget(&p);
    }
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_are_as_open_as_exact_ones),
    };
    if (count > 1)
        mesh_file = arguments[1];
    if (count > 2)
        mesh_lift = arguments[2];
    return cmocka_run_group_tests(tests, NULL, NULL);
}
