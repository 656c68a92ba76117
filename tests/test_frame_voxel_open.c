/* How open points are by rays through voxels, against the same rays by Embree: closed meshes as bodies and as surfaces, by where rays begin. Prints the
 * table of docs/indirect.md. `build/tests/test_frame_voxel_open FILE.obj LIFT`: of that mesh, y up, so far above the ground. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "runtime/render/frame.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/open_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const char render_text_voxel_map[], render_text_voxel_walk[], render_text_voxel_ray[];

enum { WIDE = 96, HIGH = 72, PIXELS = WIDE * HIGH, ACROSS = 16, RAYS = ACROSS * ACROSS, TEXELS = 4, TEXT = 2048 };

/* Directions around the normal, z, and the share of rays that meet nothing; words read for each. */
static const char body[] =
    "uniform sampler2D points, directions;\nuniform float radius, off;\n"
    "vec4 pointTexel(ivec2 pixel, int i) { return texelFetch(points, ivec2(4 * pixel.x + i, pixel.y), 0); }\n"
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 place = pointTexel(pixel, 0);\n    vec3 normal = pointTexel(pixel, 3).xyz;\n    float open = 0.0, steps "
    "= 0.0;\n"
    "    if (place.w == 0.0) return vec4(0.0);\n"
    "    for (int i = 0; i < textureSize(directions, 0).x; i++) {\n"
    "        vec3 d = texelFetch(directions, ivec2(i, 0), 0).xyz;\n"
    "        vec3 way = d.x * pointTexel(pixel, 1).xyz + d.y * pointTexel(pixel, 2).xyz + d.z * normal;\n"
    "        VoxelMeeting meeting;\n"
    "        open += voxelMeets(off > 0.0 ? place.xyz + off * normal : voxelStart(place.xyz, normal), way, radius, "
    "meeting) ? 0.0 : 1.0;\n"
    "        steps += float(meeting.steps);\n    }\n"
    "    return vec4(open, steps, 0.0, 0.0) / float(textureSize(directions, 0).x);\n}\n";

/* Closed, each a hair above the ground: where bodies cross, what both have is empty. */
#define BODIES                                                                                                         \
    "- { object: Sphere, radius: .5, detail: 96, material: m, transform: { translation: [-.5, .1, .501] } }\n"         \
    "- { object: Cylinder, detail: 48, radius: .3, material: m, transform: { translation: [.5, .5, .001] } }\n"        \
    "- { object: Box, material: m, size: [.5, .4, .7], transform: { translation: [.4, -.5, .36], rotation: [0, 0, "    \
    ".5] } }\n"                                                                                                        \
    "- { object: Cone, detail: 48, radius: .3, material: m, transform: { translation: [1.1, -.1, .001] } }\n"
static const char *mesh_file, *mesh_lift = "0";
static float points[PIXELS][TEXELS][4], directions[RAYS][4], said[PIXELS][4];
static double truth[PIXELS];

typedef struct {
    MatcOptions options;
    MatcDocument *document;
    Scene *scene;
    GlContext *gl;
    Render *render;
    double radius;
} Place;

static Place place_of(int size)
{
    Place p = {.options = frame_exact_options(), .gl = frame_context()};
    char text[TEXT], mesh[TEXT / 4] = BODIES;
    if (mesh_file)
        snprintf(mesh, sizeof mesh,
                 "- { object: Mesh, file: %s, material: m, transform: { rotation: [1.5707963, 0, 0], translation: [0, "
                 "0, %s] } }\n",
                 mesh_file, mesh_lift);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [.6, -4.6, 2.6], target: [0, "
             "0, .7], angle: 40 }\n"
             "voxels: { size: %d }\nmaterials: { m: { material: Phong, diffuse: .6 } }\nobjects:\n"
             "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n%s",
             WIDE, HIGH, size, mesh);
    p.scene = frame_scene(text, &p.options, &p.document);
    p.render = render_open(p.gl, &(RenderOptions){.compile = &p.options, .view = "voxels"});
    assert_true(p.render && render_scene(p.render, p.scene) && render_frame(p.render));
    const VoxelGrid *grid = &p.render->voxels.grid;
    p.radius = .25 * grid->edge * (grid->size - 2);
    return p;
}

static void forget(Place *p)
{
    render_close(p->render);
    frame_forget(p->scene, p->document);
    gl_close(p->gl);
}

/* -- points of the picture, and rays from them */

static void make_directions(void)
{
    uint32_t state = 5;
    for (int i = 0; i < RAYS; i++) {
        double place[2];
        for (int k = 0; k < 2; k++) {
            state = state * 1664525u + 1013904223u;
            place[k] = ((k ? i / ACROSS : i % ACROSS) + (state >> 8) / 16777216.) / ACROSS;
        }
        const double r = sqrt(place[0]), turn = 2 * 3.14159265358979323846 * place[1];
        directions[i][0] = (float)(r * cos(turn));
        directions[i][1] = (float)(r * sin(turn));
        directions[i][2] = (float)sqrt(1 - place[0]);
    }
}

static bool is_blocked(const Tracer *tracer, const double from[3], const double way[3], double far)
{
    struct RTCIntersectContext context;
    struct RTCRay ray = {.org_x = (float)from[0],
                         .org_y = (float)from[1],
                         .org_z = (float)from[2],
                         .dir_x = (float)way[0],
                         .dir_y = (float)way[1],
                         .dir_z = (float)way[2],
                         .tfar = (float)far,
                         .mask = ~0u};
    rtcInitIntersectContext(&context);
    rtcOccluded1(tracer->traced, &context, &ray);
    return ray.tfar < 0;
}

static double open_by_rays(const Place *p, const Tracer *tracer, const Hit *hit, const double axes[3][3])
{
    double from[3], open = 0;
    for (int i = 0; i < 3; i++)
        from[i] = hit->world[i] + 3e-5 * hit->facet[i];
    for (int k = 0; k < RAYS; k++) {
        double way[3];
        for (int i = 0; i < 3; i++)
            way[i] = directions[k][0] * axes[0][i] + directions[k][1] * axes[1][i] + directions[k][2] * axes[2][i];
        open += !is_blocked(tracer, from, way, p->radius);
    }
    return open / RAYS;
}

/* The facet's normal: rays below the surface would be another matter. */
static void make_points(const Place *p)
{
    const VoxelGrid *grid = &p->render->voxels.grid;
    Tracer tracer = reference_open(p->scene);
    memset(points, 0, sizeof points);
    for (int i = 0; i < PIXELS; i++) {
        const Ray ray = reference_ray(p->scene, i % WIDE + .5, i / WIDE + .5);
        Hit hit = reference_hit(&tracer, &ray, 0);
        double axes[3][3], aside[3] = {0};
        if (hit.object < 0)
            continue;
        const double side = reference_dot(hit.facet, ray.way) < 0 ? 1 : -1;
        for (int k = 0; k < 3; k++)
            axes[2][k] = hit.facet[k] *= side;
        aside[fabs(axes[2][0]) < .6 ? 0 : 1] = 1;
        reference_cross(axes[2], aside, axes[0]);
        reference_normalize(axes[0]);
        reference_cross(axes[2], axes[0], axes[1]);
        for (int k = 0; k < 3; k++) {
            points[i][0][k] = (float)((hit.world[k] - grid->low[k]) / grid->edge);
            for (int axis = 0; axis < 3; axis++)
                points[i][axis + 1][k] = (float)axes[axis][k];
        }
        points[i][0][3] = 1;
        truth[i] = open_by_rays(p, &tracer, &hit, (const double(*)[3])axes);
    }
    reference_close(&tracer);
}

/* -- the same through voxels */

static void by_voxels(const Place *p, double off)
{
    GlContext *gl = p->gl;
    const Render *render = p->render;
    Store *store = store_new(gl);
    Screen screen;
    ScreenPass pass;
    Framebuffer target;
    const FramebufferSpec spec = {.width = WIDE, .height = HIGH, .color_count = 1, .color_format = GL_RGBA32F};
    const TextureSpec specs[2] = {{.width = TEXELS * WIDE, .height = HIGH, .lanes = 4, .floats = points[0][0]},
                                  {.width = RAYS, .height = 1, .lanes = 4, .floats = directions[0]}};
    const ScreenPassText text = {
        .body = {render_text_voxel_map, render_text_voxel_ray, body}, .format = "RGBA32F", .compute = true};
    gl->ActiveTexture(GL_TEXTURE0);
    const GLuint textures[2] = {texture_make(gl, &specs[0]), texture_make(gl, &specs[1])};
    if (!store || !screen_make(gl, &screen) || !framebuffer_make(gl, &spec, &target) || !textures[0] || !textures[1] ||
        !screen_pass_make(store, &text, &pass))
        fail_msg("%s", gl->error);
    screen_pass_sampler(&pass, "points", 0);
    screen_pass_sampler(&pass, "directions", 1);
    pass_voxels_set(render, 2, &pass);
    material_set_number(&pass.material, "off", (float)off);
    material_set_number(&pass.material, "radius", (float)(p->radius / render->voxels.grid.edge));
    texture_bind(gl, textures[0], 0);
    texture_bind(gl, textures[1], 1);
    pass_voxels_bind(render, 2);
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, said[0]));
    screen_pass_delete(&pass);
    framebuffer_delete(gl, &target);
    screen_delete(gl, &screen);
    gl->DeleteTextures(2, textures);
    store_free(store);
}

typedef struct {
    double error, bias, steps; /* root of the mean square, mean; words that a ray reads */
} Result;

static Result compare(void)
{
    Result result = {0};
    int count = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (points[i][0][3] == 0)
            continue;
        const double off = said[i][0] - truth[i];
        result.error += off * off;
        result.bias += off;
        result.steps += said[i][1];
        count++;
    }
    assert_true(count > PIXELS / 3);
    return (Result){sqrt(result.error / count), result.bias / count, result.steps / count};
}

/* Bodies are surfaces from now on. */
static void make_surfaces(Place *p)
{
    FrameVoxels *voxels = &p->render->voxels;
    for (int i = 0; i < p->render->cache.mesh_count; i++) {
        assert_true(voxels->closed[i]);
        voxels->closed[i] = false;
        voxels->open[i] = true;
    }
    voxels->drawn = false;
    assert_true(render_frame(p->render));
}

/* Off the surface, in voxels; 0: as voxelStart has it. */
static const double offs[] = {0, .5, .75, 1, 1.8};
enum { OFFS = sizeof offs / sizeof *offs };

static void rays_are_as_open_as_exact_ones(void **state)
{
    (void)state;
    static const int sizes[] = {64, 128, 256};
    static const double bounds[][2] = {{.032, .048}, {.017, .029}, {.013, .018}}; /* of bodies, of surfaces */
    make_directions();
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
