/* --aa in the passes plane and sky, where footprints come from the view ray: drawn by matc's own
 * vertex programs from cameras, against means of the map over each pixel's rays. */
/* ctest: quick */
#include "tests/test.h"
#include "tests/draw/scene.h"
#include "tests/draw/rig.h"
#include <stdio.h>
#include <string.h>

enum { SIDE = RIG_SIDE, PIXELS = RIG_PIXELS, RAYS = 6 /* of a pixel, each way */ };

static Rig *rig;

static int set_up(void **state)
{
    (void)state;
    rig = rig_new(true);
    if (*rig->error)
        print_error("%s\n", rig->error);
    return *rig->error != 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(rig);
    return 0;
}

/* Texture coordinates that a ray of the picture meets; false: none, or none to be compared. */
typedef bool Meet(const Space *space, double x, double y, double uv[2]);

static bool meet_plane(const Space *space, double x, double y, double uv[2])
{
    Hit hit = space_meet(space, x, y);
    uv[0] = hit.u;
    uv[1] = hit.v;
    return hit.before && fabs(hit.slope) > .15;
}

/* Longitude and latitude; not where the longitudes meet. */
static bool meet_sky(const Space *space, double x, double y, double uv[2])
{
    Hit hit = space_meet(space, x, y);
    const double *ray = hit.ray;
    uv[0] = atan2(ray[1], -ray[0]) / (2 * M_PI) + .5;
    uv[1] = acos(-ray[2]) / M_PI;
    return fabs(ray[2]) < .9 && fabs(uv[0] - .5) < .45;
}

/* A place in a pixel, in clip space, a part of the pixel away from its center. */
static double place(int index, double part) { return 2 * (index + .5 + part) / SIDE - 1; }

/* The share of 1 in a Checker whose cells are 1 / (2 scale) wide. */
static bool mean_of_rays(const Space *space, Meet *meet, double scale, int pixel, double *mean)
{
    *mean = 0;
    for (int i = 0; i < RAYS * RAYS; i++) {
        double uv[2], x = (i % RAYS + .5) / RAYS - .5, y = (i / RAYS + .5) / RAYS - .5;
        if (!meet(space, place(pixel % SIDE, x), place(pixel / SIDE, y), uv))
            return false;
        double cells = floor(2 * scale * uv[0]) + floor(2 * scale * uv[1]);
        *mean += (cells - 2 * floor(cells / 2)) / (RAYS * RAYS);
    }
    return true;
}

/* The root mean square error of what was drawn. */
static double error_of(const Space *space, Meet *meet, double scale, const float (*drawn)[4],
                       int *count)
{
    double sum = 0, mean;
    *count = 0;
    for (int pixel = 0; pixel < PIXELS; pixel++)
        if (mean_of_rays(space, meet, scale, pixel, &mean)) {
            sum += (drawn[pixel][0] - mean) * (drawn[pixel][0] - mean);
            ++*count;
        }
    return sqrt(sum / *count);
}

typedef struct {
    const char *pass;
    Meet *meet;
    double scale;
    float eye[3], target[3];
    double none, box, aniso; /* errors: without --aa at least, with it at most */
} Case;

static const Case cases[] = {
    {"plane", meet_plane, 5, {.3f, -2, 1.1f}, {.2f, .4f, -.1f}, .36, .0800, .0480},
    {"plane", meet_plane, 8, {-1.5f, -1.7f, 1.4f}, {.1f, .2f, 0}, .43, .0707, .0655},
    {"sky", meet_sky, 30, {0, 0, 0}, {-1, .2f, .1f}, .205, .0181, .0186},
    {"sky", meet_sky, 24, {1, 2, 3}, {.2f, 1.3f, 3.4f}, .19, .0197, .0182},
};

static Space space_of(const Case *c)
{
    static const float plane[3][3] = {{.1f, -.2f, -.3f}, {.9f, .1f, 0}, {-.1f, .9f, 0}};
    Space space = space_camera(c->eye, c->target, .8f);
    memcpy(space.plane, plane, sizeof plane);
    return space;
}

static double draw(const Case *c, const char *aa, int *count)
{
    Scene scene;
    char text[256];
    bool sky = c->meet == meet_sky;
    Space space = space_of(c);
    snprintf(text, sizeof text,
             "{ material: Phong, diffuse: { map: Checker, input: { map: UVTransform, scaleU: %g, "
             "scaleV: %g } } }",
             c->scale, c->scale);
    if (!scene_open(&scene, rig->store, text, &(SceneOptions){.pass = c->pass, .aa = aa}))
        fail_msg("%s", scene.error);
    if (!rig_draw(rig, &scene, &space, NULL, &rig->full) ||
        (!sky && !rig_unpack(rig, &scene, &rig->full)))
        fail_msg("%s", rig->gl->error);
    scene_close(&scene);
    const float(*drawn)[4] = (const float(*)[4])(sky ? rig->color[0] : rig->slot[SLOT_diffuse]);
    return error_of(&space, c->meet, c->scale, drawn, count);
}

static void rays_make_footprints(void **state)
{
    (void)state;
    int failures = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Case *c = &cases[i];
        int count;
        double none = draw(c, "none", &count), box = draw(c, "box", &count),
               aniso = draw(c, "aniso", &count);
        print_message("%-5s %d pixels: none %.4f (at least %.3f), box %.4f (at most %.4f), aniso "
                      "%.4f (%.4f)\n",
                      c->pass, count, none, c->none, box, c->box, aniso, c->aniso);
        failures += !(none >= c->none && box <= c->box && aniso <= c->aniso && count > PIXELS / 4);
    }
    assert_int_equal(failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_make_footprints),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
