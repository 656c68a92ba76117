/* Alpha-tested surfaces in voxels: which voxels are full, against the alpha test in double;
 * ambient occlusion and light beneath them against rays in double; a closed mesh with holes does
 * not count as watertight; the cut-outs may change. */
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_voxels.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE, SIZE = 128, ACROSS = 32, SHEETS = 2 };
#define RADIUS 1.2

/* A fence of squares, of which every other one is cut away, and one across the axes, whose holes
 * are as large as voxels; a ball with holes; plain glass; a ground. The middle of the ground lies
 * at z = 0. */
static const char scene_text[] =
    "image: { width: 64, height: 64 }\n"
    "camera: { camera: Orthographic, position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], size: "
    "2.2 }\n"
    "voxels: { size: 128 }\nindirect: { method: voxels, rays: 64, radius: 1.2, filter: none }\n"
    "lights: [{ light: Point, position: [.1, .05, .5], intensity: 1, shadows: none }]\nmaterials:\n"
    "  ground: { material: Phong, diffuse: .5, specular: 0 }\n"
    "  glass: { material: Phong, diffuse: .5, specular: 0, transparency: .6 }\n"
    "  fence: { material: Phong, diffuse: [.8, .4, .2], specular: 0, transparency: { map: Checker, "
    "color1: { param: "
    "hole, default: [1, 1, 1] }, "
    "color2: 0, input: { map: UVTransform, scaleU: 2, scaleV: 3 } } }\n"
    "  lattice: { material: Phong, diffuse: [.2, .4, .8], specular: 0, transparency: { map: "
    "Checker, color1: 0, "
    "color2: 1, input: { map: "
    "UVTransform, scaleU: 6, scaleV: 4 } } }\n"
    "objects:\n"
    "- { object: Box, material: ground, size: [3, 3, .4], transform: { translation: [0, 0, -.2] } "
    "}\n"
    "- { object: Parallelogram, material: fence, u: [1.6, .1, 0], v: [-.1, 1.5, 0], transform: { "
    "translation: [-.8, "
    "-.75, .813] } }\n"
    "- { object: Parallelogram, material: lattice, u: [.9, .1, .5], v: [-.2, .6, .4], transform: { "
    "translation: [.3, "
    ".1, .113] } }\n"
    "- { object: Parallelogram, material: glass, u: [1, 0, 0], v: [0, 1, 0], transform: { "
    "translation: [-.5, -.5, "
    ".613] } }\n"
    "- { object: Sphere, detail: 24, radius: .2, material: fence, transform: { translation: [-1.3, "
    "1.3, 1.3] } }\n";

typedef struct {
    double at[3], u[3], v[3], cells[2], diffuse[3];
    int odd; /* parity of the cells' sum where the checker is full */
} ContactSheet;
static const ContactSheet sheets[SHEETS] = {
    {{-.8, -.75, .813}, {1.6, .1, 0}, {-.1, 1.5, 0}, {4, 6}, {.8, .4, .2}, 0},
    {{.3, .1, .113}, {.9, .1, .5}, {-.2, .6, .4}, {12, 8}, {.2, .4, .8}, 1},
};

/* Intersection of a line with the sheet's plane, in multiples of its direction; `uv` of the
 * point. */
static double meet(const ContactSheet *sheet, const double from[3], const double way[3],
                   double uv[2])
{
    double normal[3], to[3], place[3], side[3];
    cross(sheet->u, sheet->v, normal);
    for (int i = 0; i < 3; i++)
        to[i] = sheet->at[i] - from[i];
    const double t = dot(to, normal) / dot(way, normal);
    for (int i = 0; i < 3; i++)
        place[i] = from[i] + t * way[i] - sheet->at[i];
    cross(place, sheet->v, side);
    uv[0] = dot(side, normal) / dot(normal, normal);
    cross(sheet->u, place, side);
    uv[1] = dot(side, normal) / dot(normal, normal);
    return t;
}

/* 1: opaque; 0: cut away, or outside of the sheet; -1: so near a cell's border that either is
 * right. */
static int is_left(const ContactSheet *sheet, const double uv[2], double near)
{
    int sum = 0;
    for (int k = 0; k < 2; k++) {
        const double cell = uv[k] * sheet->cells[k], over = sheet->cells[k];
        if (uv[k] < -near || uv[k] > 1 + near)
            return 0;
        if (fabs(cell - floor(cell + .5)) < near * over)
            return -1;
        sum += (int)floor(cell);
    }
    return (sum & 1) == sheet->odd;
}

/* -- the scene, drawn once */

typedef struct {
    MatcLayout *layout;
    MatcOptions options;
    FrameVoxelsDrawn voxels;
    float *found; /* rgb: indirect light; a: ambient occlusion */
} Drawn;

static void read_found(Drawn *d)
{
    assert_true(renderer_frame(d->voxels.renderer));
    assert_true(framebuffer_read(d->voxels.gl, &d->voxels.renderer->targets.draws[FRAME_DRAW_ao], 0,
                                 d->found));
}

static int set_up(void **state)
{
    static Drawn d;
    d.options = frame_float_options(&d.layout);
    d.voxels = (FrameVoxelsDrawn){.size = SIZE, .gl = frame_context()};
    d.voxels.scene = frame_scene(scene_text, &d.options, &d.voxels.document);
    d.voxels.renderer = renderer_open(
        d.voxels.gl, &(RendererOptions){.compile = &d.options, .view = "indirect", .deep = true});
    d.found = calloc(PIXELS, 4 * sizeof *d.found);
    if (!d.voxels.renderer || !d.found || !renderer_set_scene(d.voxels.renderer, d.voxels.scene))
        return print_message("%s\n", d.voxels.gl->error), -1;
    read_found(&d);
    d.voxels.words = frame_voxels_level(&d.voxels, 0);
    *state = &d;
    return 0;
}

static int tear_down(void **state)
{
    Drawn *d = *state;
    free(d->found);
    frame_voxels_forget(&d->voxels);
    matc_layout_free(d->layout);
    return 0;
}

/* -- voxels */

/* 1 full, 0 empty, -1 either: by lines through the voxel's center along three axes. */
static int expected(const VoxelGrid *grid, const int at[3])
{
    int all = 0;
    for (int i = 0; i < SHEETS * 3; i++) {
        const ContactSheet *sheet = &sheets[i / 3];
        const int axis = i % 3;
        double from[3], way[3] = {0}, uv[2];
        for (int k = 0; k < 3; k++)
            from[k] = grid->low[k] + (at[k] + (k == axis ? 0 : .5)) * grid->edge;
        way[axis] = grid->edge;
        const double t = meet(sheet, from, way, uv), near = .02 * grid->edge;
        if (!(t > -.02 && t < 1.02))
            continue;
        const int left = is_left(sheet, uv, near / .5);
        if (left == 1 && t > .02 && t < .98)
            return 1;
        all = left ? -1 : all;
    }
    return all;
}

static void voxels_are_empty_where_it_is_cut_away(void **state)
{
    const Drawn *d = *state;
    const VoxelGrid *grid = &d->voxels.renderer->voxels->grid;
    int full = 0, empty = 0, either = 0, wrong = 0;
    for (int i = 0; i < SIZE * SIZE * SIZE; i++) {
        const int at[3] = {i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE};
        const double z = grid->low[2] + (at[2] + .5) * grid->edge,
                     x = grid->low[0] + at[0] * grid->edge;
        if (z < .05 || x < -1.05) /* the ground, the ball */
            continue;
        const int is = expected(grid, at);
        full += is == 1;
        empty += is == 0;
        either += is < 0;
        wrong += is >= 0 && frame_voxels_bit(&d->voxels, at) != is;
    }
    print_message("%d full, %d empty, %d either, %d wrong\n", full, empty, either, wrong);
    assert_int_equal(wrong, 0);
    assert_true(full > 2000 && either < full / 4);
}

static void programs_are_those_of_cut_outs(void **state)
{
    const Renderer *renderer = ((const Drawn *)*state)->voxels.renderer;
    int cut = 0;
    for (int i = 0; i < renderer->set.count; i++) {
        const PassProgram *program = &renderer->set.programs[i];
        const char *name =
            matc_material_name(renderer->scene->materials[program->material].document,
                               renderer->scene->materials[program->material].index);
        const bool has = !strcmp(name, "fence") || !strcmp(name, "lattice");
        assert_true(program->cut < 0 || has);
        cut += program->cut >= 0;
    }
    assert_int_equal(cut, 2);
    for (int i = 0; i < renderer->gpu_scene.place_count; i++)
        assert_true(renderer->gpu_scene.places[i].cut < 0 || !renderer->voxels->waves[i]);
}

/* The ball's surface is partly voxelized, and its inside is empty. */
static void balls_with_holes_are_hollow(void **state)
{
    const Drawn *d = *state;
    const VoxelGrid *grid = &d->voxels.renderer->voxels->grid;
    static const double middle[3] = {-1.3, 1.3, 1.3};
    int skin = 0, bare = 0;
    for (int i = 0; i < SIZE * SIZE * SIZE; i++) {
        const int at[3] = {i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE};
        double off = 0;
        for (int k = 0; k < 3; k++)
            off += pow(grid->low[k] + (at[k] + .5) * grid->edge - middle[k], 2);
        off = sqrt(off);
        const bool is = frame_voxels_bit(&d->voxels, at);
        if (off < .2 - 2 * grid->edge)
            assert_false(is);
        skin += fabs(off - .19) < .4 * grid->edge && is;
        bare += fabs(off - .19) < .4 * grid->edge && !is;
    }
    assert_true(skin > 40 && bare > 40);
}

/* -- rays */

typedef struct {
    double open, light[3];
} Sum;

/* Adds the light of the nearer plane that a ray hits; false if it misses both. */
static bool follow(const double from[3], const double way[3], Sum *sum)
{
    static const double lamp[3] = {.1, .05, .5};
    double nearest = RADIUS;
    const ContactSheet *met = NULL;
    for (int i = 0; i < SHEETS; i++) {
        double uv[2];
        const double t = meet(&sheets[i], from, way, uv);
        if (t > 0 && t < nearest && is_left(&sheets[i], uv, 0) == 1)
            nearest = t, met = &sheets[i];
    }
    if (!met)
        return false;
    double to[3], normal[3];
    cross(met->u, met->v, normal);
    for (int k = 0; k < 3; k++)
        to[k] = lamp[k] - from[k] - nearest * way[k];
    const double square = dot(to, to),
                 towards = dot(normal, to) / sqrt(dot(normal, normal) * square);
    if ((towards > 0) == (dot(normal, way) < 0)) /* its side that is seen is lit */
        for (int k = 0; k < 3; k++)
            sum->light[k] += met->diffuse[k] * fabs(towards) / square;
    return true;
}

static Sum around(const double from[3])
{
    Sum sum = {0};
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        const double s = (i % ACROSS + .5) / ACROSS, turn = 2 * PI * (i / ACROSS + .5) / ACROSS;
        const double way[3] = {sqrt(s) * cos(turn), sqrt(s) * sin(turn), sqrt(1 - s)};
        sum.open += !follow(from, way, &sum);
    }
    sum.open /= ACROSS * ACROSS;
    for (int k = 0; k < 3; k++)
        sum.light[k] /= ACROSS * ACROSS;
    return sum;
}

/* The picture shows the ground through all that is transparent. What is left of a sheet is as thick
 * as a voxel, so that it keeps off more: by a seventh here, a fourth with 64 voxels, a twelfth with
 * 256. Taken whole, it would be twice as much; taken as not there, none of it. */
static void light_comes_through_holes(void **state)
{
    const Drawn *d = *state;
    double off = 0, open = 0, light[3] = {0}, wanted[3] = {0}, spread = 0;
    int count = 0;
    for (int i = 0; i < PIXELS; i += 3, count++) {
        const double from[3] = {2.2 * ((i % EDGE + .5) / EDGE - .5),
                                2.2 * ((i / EDGE + .5) / EDGE - .5), 1e-6};
        const Sum sum = around(from);
        const double error = (double)d->found[4 * i + 3] - sum.open;
        off += error * error;
        open += error;
        spread += 1 - sum.open;
        for (int k = 0; k < 3; k++) {
            light[k] += (double)d->found[4 * i + k];
            wanted[k] += sum.light[k];
        }
    }
    print_message("openness off by %.4f, mean %+.4f of %.4f kept off; light %.3f %.3f %.3f of what "
                  "rays say\n",
                  sqrt(off / count), open / count, spread / count, light[0] / wanted[0],
                  light[1] / wanted[1], light[2] / wanted[2]);
    assert_true(sqrt(off / count) < .045 && spread / count > .1 &&
                fabs(open / count) < .2 * spread / count);
    for (int k = 0; k < 3; k++)
        assert_true(light[k] / wanted[k] > .97 && light[k] / wanted[k] < 1.2);
}

/* -- changes */

static int count_bits(const FrameVoxelsDrawn *d)
{
    uint32_t *words = frame_voxels_level(d, 0);
    int count = 0;
    for (int i = 0; i < SIZE * SIZE * SIZE / 32; i++)
        count += __builtin_popcount(words[i]);
    free(words);
    return count;
}

static void holes_are_closed_and_opened(void **state)
{
    static const float closed[3] = {.4f, .4f, .4f}, open[3] = {1, 1, 1};
    Drawn *d = *state;
    int material = 0;
    while (strcmp(matc_material_name(d->voxels.scene->materials[material].document,
                                     d->voxels.scene->materials[material].index),
                  "fence") != 0)
        material++;
    const int before = count_bits(&d->voxels);
    const double middle = d->found[4 * (EDGE / 2 * EDGE + EDGE / 2) + 3];
    assert_true(renderer_param(d->voxels.renderer, material, "hole", closed, 3));
    read_found(d);
    const int full = count_bits(&d->voxels);
    assert_true(d->found[4 * (EDGE / 2 * EDGE + EDGE / 2) + 3] < middle - .1);
    assert_true(renderer_param(d->voxels.renderer, material, "hole", open, 3));
    read_found(d);
    print_message("%d voxels, %d when holes are closed\n", before, full);
    assert_true(full > before + 300);
    assert_int_equal(count_bits(&d->voxels), before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(voxels_are_empty_where_it_is_cut_away),
        cmocka_unit_test(programs_are_those_of_cut_outs),
        cmocka_unit_test(balls_with_holes_are_hollow),
        cmocka_unit_test(light_comes_through_holes),
        cmocka_unit_test(holes_are_closed_and_opened),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
