/* Closed meshes as voxels: intersecting, thin and hostile ones. No ray leaves a room whose walls
 * cross in its corners, with walls from half a voxel to two voxels thick; intersecting meshes
 * leave no gaps; hostile documents give voxels in bounded time and without a GL error. */
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_voxels.h"
#include "tests/frame/voxel_points.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 3072, WIDE = 64, HIGH = 32, ACROSS = 8, SIZE = 64 };

/* -- a room */

static void put_room(double wall, char text[TEXT])
{
    int length = snprintf(
        text, TEXT,
        "- object: Group\n  material: m\n  transform: { rotation: [.4, .7, .3] }\n  objects:\n");
    for (int i = 0; i < 6; i++) {
        double size[3], at[3] = {0};
        for (int k = 0; k < 3; k++)
            size[k] = k == i / 2 ? wall : 2 + 2 * wall;
        at[i / 2] = (i % 2 ? 1 : -1) * (1 + wall / 2);
        length += snprintf(text + length, (size_t)(TEXT - length),
                           "  - { object: Box, size: [%.9g, %.9g, %.9g], transform: { translation: "
                           "[%.9g, %.9g, %.9g] } }\n",
                           size[0], size[1], size[2], at[0], at[1], at[2]);
    }
}

static uint32_t random_state = 3;
static double random_unit(void)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.;
}

static double most_open(const FrameVoxelsDrawn *d)
{
    VoxelPoints points;
    VoxelPointsPass pass;
    static float reported[WIDE * HIGH][4];
    double most = 0;
    assert_true(voxel_points_make(WIDE, HIGH, ACROSS, &points));
    for (int i = 0; i < WIDE * HIGH; i++) {
        double at[3], normal[3], length = 0;
        for (int k = 0; k < 3; k++) {
            at[k] = 1.1 * random_unit() - .55;
            normal[k] = 2 * random_unit() - 1;
            length += normal[k] * normal[k];
        }
        for (int k = 0; k < 3; k++)
            normal[k] /= sqrt(length);
        voxel_points_set(&points, i, &d->renderer->voxels->grid, at, normal);
    }
    if (!voxel_points_open(d->renderer, &points, (const char *[2]){voxel_points_ray, NULL}, &pass))
        fail_msg("%s", d->gl->error);
    voxel_points_run(d->renderer, &pass, 4 * SIZE, 1e-3f);
    assert_true(framebuffer_read(d->gl, &pass.target, 0, reported[0]));
    for (int i = 0; i < WIDE * HIGH; i++)
        most = fmax(most, reported[i][0]);
    voxel_points_close(d->renderer, &pass);
    voxel_points_free(&points);
    return most;
}

static void nothing_gets_out_of_a_room_of_boxes(void **state)
{
    (void)state;
    static const double walls[] = {.1, .5, 1, 1.4, 2, 4}; /* in voxels, approximately */
    char room[TEXT];
    for (size_t i = 0; i < sizeof walls / sizeof *walls; i++) {
        put_room(walls[i] * 3.4 / SIZE, room);
        FrameVoxelsDrawn d = frame_voxels_drawn(room, SIZE);
        const double open = most_open(&d);
        print_message("walls of %.2f voxels, in %d waves: of a point's rays %g get out\n",
                      walls[i] * 3.4 / SIZE / d.renderer->voxels->grid.edge,
                      d.renderer->voxels->wave_count, open);
        assert_true(open == 0);
        frame_voxels_forget(&d);
    }
}

/* -- bodies that cross */

static bool is_within(const double at[3], const double middle[3], double half, double *near)
{
    double most = 0;
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(at[k] - middle[k]));
    *near = fmin(*near, fabs(most - half));
    return most < half;
}

/* Three overlapping boxes in a row, and two identical ones. */
static void what_crosses_is_full(void **state)
{
    (void)state;
    enum { BOXES = 4 };
    static const double middles[BOXES][3] = {
        {0, 0, 0}, {.53, .11, .07}, {1.01, .21, -.05}, {1.01, .21, -.05}};
    char text[TEXT];
    int length = 0, full = 0;
    for (int i = 0; i < BOXES; i++)
        length +=
            snprintf(text + length, (size_t)(TEXT - length),
                     "- { object: Box, material: m, transform: { translation: [%g, %g, %g] } }\n",
                     middles[i][0], middles[i][1], middles[i][2]);
    FrameVoxelsDrawn d = frame_voxels_drawn(text, SIZE);
    assert_int_equal(d.renderer->voxels->wave_count, 3);
    for (int i = 0; i < SIZE * SIZE * SIZE; i++) {
        const int at[3] = {i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE};
        double place[3], near = INFINITY;
        bool within = false;
        for (int k = 0; k < 3; k++)
            place[k] =
                d.renderer->voxels->grid.low[k] + (at[k] + .5) * d.renderer->voxels->grid.edge;
        for (int k = 0; k < BOXES; k++)
            within |= is_within(place, middles[k], .5, &near);
        full += within;
        assert_true(near < 1e-4 || frame_voxels_bit(&d, at) == within);
    }
    assert_true(full > SIZE * SIZE);
    frame_voxels_forget(&d);
}

/* -- what is hostile */

static int count_full(const FrameVoxelsDrawn *d)
{
    int count = 0;
    for (int i = 0; i < d->size * d->size * d->size / 32; i++)
        for (uint32_t word = d->words[i]; word; word &= word - 1)
            count++;
    return count;
}

/* An open shell; a ball that is flat; a tiny box alone; two million triangles smaller than a voxel;
 * bodies of which one is a voxel of the other, or all are less than one, as far away as that floats
 * tell no smaller ones apart: no line through middles need meet these; one without a depth. Twenty
 * bodies in one place: more than can be apart are surfaces. */
static void hostile_scenes_give_voxels(void **state)
{
    (void)state;
    enum { FAR = 4 };
    static const char *const scenes[] = {
        "- { object: Mesh, file: " SOURCE_FOLDER "/examples/scenes/shell.obj, material: m }\n",
        "- { object: Sphere, material: m, transform: { scale: [1, 1, 1e-9] } }\n",
        "- { object: Box, material: m, size: [1e-6, 1e-6, 1e-6] }\n",
        "- { object: Sphere, detail: 1024, material: m, transform: { scale: 1e-3 } }\n- { object: "
        "Box, material: m, "
        "transform: { translation: [2, 0, 0] } }\n",
        "- { object: Sphere, material: m, transform: { translation: [1e9, 1e9, -1e9] } }\n",
        "- { object: Sphere, material: m }\n- { object: Box, material: m, size: [1e9, 1e9, 1e9], "
        "transform: { "
        "translation: [2e9, 0, 0] } }\n",
        "- { object: Sphere, material: m, transform: { scale: [-1, 1, 1] } }\n- { object: Box, "
        "material: m, "
        "transform: { scale: [1e-5, 1, 1] } }\n",
    };
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        FrameVoxelsDrawn d = frame_voxels_drawn(scenes[i], SIZE);
        print_message("scene %d: %d voxels are full\n", (int)i, count_full(&d));
        assert_true(count_full(&d) > 0 || i == FAR);
        assert_int_equal(d.gl->GetError(), 0);
        frame_voxels_forget(&d);
    }
    char many[TEXT] = "";
    for (int i = 0; i < 20; i++)
        strcat(many, "- { object: Sphere, detail: 16, material: m }\n");
    FrameVoxelsDrawn d = frame_voxels_drawn(many, SIZE);
    int surfaces = 0;
    for (int i = 0; i < 20; i++)
        surfaces += !voxel_bodies_is_body(d.renderer->voxels, i);
    assert_int_equal(surfaces, 20 - VOXELS_WAVES_MAX);
    assert_true(frame_voxels_bit(&d, (int[]){SIZE / 2, SIZE / 2, SIZE / 2}));
    frame_voxels_forget(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_gets_out_of_a_room_of_boxes),
        cmocka_unit_test(what_crosses_is_full),
        cmocka_unit_test(hostile_scenes_give_voxels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
