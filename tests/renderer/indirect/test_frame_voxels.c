/* Voxels of scenes, bit by bit, against triangles in double: voxel centers inside closed meshes
 * by counting the surfaces before them, surfaces by lines through centers; coarser levels by the
 * finer ones; a watertight room; moved objects. */
/* ctest: seconds=19 */
#include "runtime/tessellate/scene_solid.h"
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/renderer/renderer.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_voxels.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 2048 };

/* -- the same in double */

typedef struct {
    double (*corners)[3][3]; /* in voxels */
    int *owners;             /* objects */
    int count;
} Triangles;

/* Triangles of objects of one sort. */
static Triangles triangles_of(const FrameVoxelsDrawn *d, bool sheets)
{
    const VoxelGrid *grid = &d->renderer->voxels->grid;
    Triangles made = {.count = 0};
    made.corners = malloc(sizeof *made.corners * 8192);
    made.owners = malloc(sizeof *made.owners * 8192);
    for (int i = 0; i < d->scene->object_count; i++) {
        const SceneObject *object = &d->scene->objects[i];
        const double *m = object->world_from_local.m;
        Shape shape;
        if (voxel_bodies_is_body(d->renderer->voxels, d->renderer->gpu_scene.place_of[i]) == sheets)
            continue;
        assert_true(scene_solid(object, &shape));
        for (int k = 0; k < shape.index_count; k++) {
            made.owners[made.count + k / 3] = i;
            const float *p = shape.vertices[shape.indices[k]].position;
            for (int axis = 0; axis < 3; axis++)
                made.corners[made.count + k / 3][k % 3][axis] =
                    (m[axis] * p[0] + m[4 + axis] * p[1] + m[8 + axis] * p[2] + m[12 + axis] -
                     grid->low[axis]) /
                    grid->edge;
        }
        made.count += shape.index_count / 3;
        assert_true(made.count < 8000);
        shape_free(&shape);
    }
    return made;
}

/* Intersection of a triangle with a line along an axis, through (a, b) on the next two. */
static bool meets(const double corners[3][3], int axis, const double place[2], double *at)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    double areas[3], whole = 0;
    for (int i = 0; i < 3; i++) {
        const double *p = corners[(i + 1) % 3], *q = corners[(i + 2) % 3];
        areas[i] = (q[a] - p[a]) * (place[1] - p[b]) - (q[b] - p[b]) * (place[0] - p[a]);
        whole += areas[i];
    }
    const double sign = whole < 0 ? -1 : 1;
    *at =
        (areas[0] * corners[0][axis] + areas[1] * corners[1][axis] + areas[2] * corners[2][axis]) /
        whole;
    return sign * areas[0] > 0 && sign * areas[1] > 0 && sign * areas[2] > 0;
}

/* How often a voxel is full, of lines that pass its middle as closely as a rasterizer may put it
 * elsewhere: 1/256 of a pixel to each side, and a depth. */
enum { LINES = 5, DEPTHS = 2, TRIES = LINES * DEPTHS };
typedef struct {
    unsigned char *within, *surface;
    int size;
} Expected;

static size_t voxel_of(const Expected *e, const int at[3])
{
    return ((size_t)at[1] * (size_t)e->size + (size_t)at[0]) * (size_t)e->size + (size_t)at[2];
}

static void line_of(const Expected *e, int column, int line, double place[2])
{
    static const double beside[LINES][2] = {{0, 0}, {1, .3}, {-.3, 1}, {-1, -.3}, {.3, -1}};
    for (int k = 0; k < 2; k++)
        place[k] = (k ? column / e->size : column % e->size) + .5 + beside[line][k] / 200;
}

static double depth_of(double depth, int number) { return depth + (number ? 1e-3 : -1e-3); }

/* Finds voxels whose centers are inside a closed mesh, with an odd number of its surfaces below. */
static void expect_within(Expected *e, const Triangles *triangles)
{
    for (int try = 0; try < e->size * e->size * TRIES; try++) {
        const int column = try / TRIES;
        double place[2], heights[256];
        int owners[256], count = 0;
        line_of(e, column, try % LINES, place);
        for (int t = 0; t < triangles->count; t++) {
            owners[count] = triangles->owners[t];
            count += meets((const double(*)[3])triangles->corners[t], 2, place, &heights[count]);
        }
        for (int z = 0; z < e->size; z++) {
            unsigned odd = 0;
            for (int i = 0; i < count; i++)
                odd ^= (unsigned)(depth_of(heights[i], try / LINES % DEPTHS) < z + .5) << owners[i];
            e->within[voxel_of(e, (int[]){column % e->size, column / e->size, z})] += odd != 0;
        }
    }
}

/* Each try that meets it counts once; along all axes, so that it may be more often than TRIES. */
static void expect_surface(Expected *e, const Triangles *triangles)
{
    for (int axis = 0; axis < 3; axis++)
        for (int try = 0; try < e->size * e->size * TRIES; try++) {
            double place[2], depth;
            line_of(e, try / TRIES, try % LINES, place);
            for (int t = 0; t < triangles->count; t++) {
                if (!meets((const double(*)[3])triangles->corners[t], axis, place, &depth))
                    continue;
                int at[3];
                at[axis] = (int)depth_of(depth, try / LINES % DEPTHS);
                at[(axis + 1) % 3] = (int)place[0];
                at[(axis + 2) % 3] = (int)place[1];
                e->surface[3 * voxel_of(e, at) + (size_t)axis]++;
            }
        }
}

/* 0 empty, 1 full, 2 either. */
static int expected(const Expected *e, const int at[3])
{
    const size_t voxel = voxel_of(e, at);
    bool full = e->within[voxel] == TRIES, empty = e->within[voxel] == 0;
    for (int axis = 0; axis < 3; axis++) {
        full |= e->surface[3 * voxel + (size_t)axis] >= TRIES;
        empty &= e->surface[3 * voxel + (size_t)axis] == 0;
    }
    return full ? 1 : empty ? 0 : 2;
}

typedef struct {
    int full, empty, either, wrong;
} Count;

static Count compare(const FrameVoxelsDrawn *d, const Expected *e)
{
    Count count = {0};
    for (int i = 0; i < e->size * e->size * e->size; i++) {
        const int at[3] = {i % e->size, i / e->size % e->size, i / e->size / e->size},
                  is = expected(e, at);
        count.full += is == 1;
        count.empty += is == 0;
        count.either += is == 2;
        count.wrong += is != 2 && frame_voxels_bit(d, at) != (is == 1);
    }
    return count;
}

static void make_surfaces(FrameVoxelsDrawn *d)
{
    FrameVoxels *voxels = d->renderer->voxels;
    for (int i = 0; i < d->renderer->gpu_scene.place_count; i++)
        voxels->waves[i] = voxel_bodies_surface(d->renderer, i);
    voxels->wave_count = 0;
    voxels->drawn = false;
    assert_true(voxel_bodies_has(voxels, &d->renderer->gpu_scene, VOXELS_FINE) &&
                renderer_frame(d->renderer));
    free(d->words);
    d->words = frame_voxels_level(d, 0);
}

static void voxels_are_those_of_the_triangles(void **state)
{
    (void)state;
    static const struct {
        const char *objects;
        int size;
        bool surfaces; /* all are */
    } cases[] = {{FRAME_VOXELS_BODIES, 64, false},
                 {FRAME_VOXELS_SHEETS, 32, false},
                 {FRAME_VOXELS_BODIES FRAME_VOXELS_SHEETS, 64, false},
                 {FRAME_VOXELS_BODIES FRAME_VOXELS_FINE, 32, true},
                 {FRAME_VOXELS_FINE, 64, true}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        FrameVoxelsDrawn d = frame_voxels_drawn(cases[i].objects, cases[i].size);
        if (cases[i].surfaces)
            make_surfaces(&d);
        const size_t all = (size_t)d.size * (size_t)d.size * (size_t)d.size;
        Expected e = {calloc(all, 1), calloc(all, 3), d.size};
        Triangles bodies = triangles_of(&d, false), sheets = triangles_of(&d, true);
        expect_within(&e, &bodies);
        expect_surface(&e, &sheets);
        const Count count = compare(&d, &e);
        print_message("%d voxels: %d full, %d empty, %d either, %d wrong\n", d.size, count.full,
                      count.empty, count.either, count.wrong);
        assert_int_equal(count.wrong, 0);
        assert_true(count.full > d.size * d.size && count.either < (int)all / 200);
        free(e.within);
        free(e.surface);
        free(bodies.corners);
        free(bodies.owners);
        free(sheets.corners);
        free(sheets.owners);
        frame_voxels_forget(&d);
    }
}

/* A texel of a level is full if any of the four finer ones is; the last level is one column.
 * Also for sizes below one texel. */
static void levels_are_those_below(void **state)
{
    (void)state;
    static const int sizes[] = {32, 128, 256};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        FrameVoxelsDrawn d = frame_voxels_drawn(FRAME_VOXELS_BODIES FRAME_VOXELS_SHEETS, sizes[i]);
        const int words = d.size / 32;
        uint32_t *below = frame_voxels_level(&d, 0);
        assert_int_equal(d.size >> (d.renderer->voxels->levels - 1), 1);
        for (int level = 1; level < d.renderer->voxels->levels; level++) {
            uint32_t *above = frame_voxels_level(&d, level), any = 0;
            const int edge = d.size >> level;
            for (int at = 0; at < edge * edge * words; at++) {
                const int word = at % words, x = at / words % edge, y = at / words / edge;
                uint32_t wanted = 0;
                for (int k = 0; k < 4; k++)
                    wanted |= below[((2 * y + k / 2) * 2 * edge + 2 * x + k % 2) * words + word];
                assert_int_equal(above[at], wanted);
                any |= wanted;
            }
            assert_true(any);
            free(below);
            below = above;
        }
        free(below);
        frame_voxels_forget(&d);
    }
}

/* Six sheets, turned so that none lies along an axis: from a corner of the map, over the faces of
 * empty voxels, the middle is not reached. */
/* Bricks of all levels, as rays read them: a voxel of a level is full where any of the map's in it
 * is; none else. */
static void bricks_are_those_of_the_map(void **state)
{
    (void)state;
    static const int sizes[] = {32, 128, 256};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        FrameVoxelsDrawn d = frame_voxels_drawn(FRAME_VOXELS_BODIES FRAME_VOXELS_SHEETS, sizes[i]);
        const int size = d.size, count = (size * size * size / 8 - 1) / 7;
        uint32_t *wanted = calloc((size_t)count, 2 * sizeof *wanted),
                 *bricks = malloc((size_t)count * 2 * sizeof *bricks);
        assert_true(wanted && bricks);
        for (int k = 0; k < size * size * size; k++) {
            const int at[3] = {k % size, k / size % size, k / size / size};
            for (int level = 0, edge; frame_voxels_bit(&d, at) && (edge = size >> level >> 2) > 0;
                 level++) {
                const int x = at[0] >> level, y = at[1] >> level, z = at[2] >> level;
                const int brick =
                    (edge * edge * edge - 1) / 7 + (z / 4 * edge + y / 4) * edge + x / 4;
                wanted[2 * brick + z / 2 % 2] |= 1u << (x % 4 + 4 * (y % 4) + 16 * (z % 2));
            }
        }
        d.gl->BindBuffer(GL_TEXTURE_BUFFER, d.renderer->voxels->buffer);
        d.gl->GetBufferSubData(GL_TEXTURE_BUFFER, 0,
                               (GLsizeiptr)((size_t)count * 2 * sizeof *bricks), bricks);
        d.gl->BindBuffer(GL_TEXTURE_BUFFER, 0);
        assert_int_equal(d.gl->GetError(), 0);
        assert_memory_equal(bricks, wanted, (size_t)count * 2 * sizeof *bricks);
        free(wanted);
        free(bricks);
        frame_voxels_forget(&d);
    }
}

static void nothing_gets_out_of_a_room(void **state)
{
    (void)state;
    static const char *const walls[3] = {
        "u: [2, 0, 0], v: [0, 2, 0], transform: { translation: [-1, -1, %d] }",
        "u: [0, 2, 0], v: [0, 0, 2], transform: { translation: [%d, -1, -1] }",
        "u: [0, 0, 2], v: [2, 0, 0], transform: { translation: [-1, %d, -1] }"};
    char objects[TEXT] =
        "- object: Group\n  material: m\n  transform: { rotation: [.4, .7, .3] }\n  objects:\n",
         wall[TEXT / 8];
    for (int i = 0; i < 6; i++) {
        snprintf(wall, sizeof wall, walls[i / 2], i % 2 ? 1 : -1);
        snprintf(objects + strlen(objects), sizeof objects - strlen(objects),
                 "  - { object: Parallelogram, %s }\n", wall);
    }
    FrameVoxelsDrawn d = frame_voxels_drawn(objects, 64);
    const int n = d.size;
    unsigned char *met = calloc((size_t)n * (size_t)n, (size_t)n);
    int *way = malloc(sizeof *way * (size_t)n * (size_t)n * (size_t)n), count = 1;
    assert_false(frame_voxels_bit(&d, (int[]){0, 0, 0}));
    met[way[0] = 0] = 1;
    for (int next = 0; next < count; next++)
        for (int turn = 0; turn < 6; turn++) {
            int at[3] = {way[next] % n, way[next] / n % n, way[next] / n / n};
            at[turn / 2] += turn % 2 ? 1 : -1;
            const int to = (at[2] * n + at[1]) * n + at[0];
            if (at[turn / 2] < 0 || at[turn / 2] >= n || met[to] || frame_voxels_bit(&d, at))
                continue;
            met[to] = 1;
            way[count++] = to;
        }
    assert_true(count > n * n * n / 3);
    assert_false(met[(n / 2 * n + n / 2) * n + n / 2]);
    assert_false(frame_voxels_bit(&d, (int[]){n / 2, n / 2, n / 2}));
    free(met);
    free(way);
    frame_voxels_forget(&d);
}

/* A moved object equals one that was there from the start; without a move, a frame makes only
 * draw calls. */
static void what_moves_is_made_again(void **state)
{
    (void)state;
    FrameVoxelsDrawn d = frame_voxels_drawn(FRAME_VOXELS_BODIES FRAME_VOXELS_SHEETS, 64);
    const SceneMatrix kept = d.scene->objects[0].world_from_local;
    frame_count_calls(d.gl);
    assert_true(renderer_frame(d.renderer));
    assert_int_equal(frame_calls.made + frame_calls.written, 0);
    d.scene->objects[0].world_from_local.m[12] += 2;
    assert_true(renderer_changed_objects(d.renderer, 0, 1) && renderer_frame(d.renderer));
    uint32_t *moved = frame_voxels_level(&d, 0);
    assert_true(memcmp(moved, d.words, sizeof *moved * 64 * 64 * 2) != 0);
    assert_true(renderer_set_scene(d.renderer, d.scene) && renderer_frame(d.renderer));
    uint32_t *anew = frame_voxels_level(&d, 0);
    assert_memory_equal(moved, anew, sizeof *anew * 64 * 64 * 2);
    free(anew);
    d.scene->objects[0].world_from_local = kept;
    assert_true(renderer_changed_objects(d.renderer, 0, 1) && renderer_frame(d.renderer));
    uint32_t *back = frame_voxels_level(&d, 0);
    assert_memory_equal(back, d.words, sizeof *back * 64 * 64 * 2);
    free(back);
    free(moved);
    frame_voxels_forget(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(voxels_are_those_of_the_triangles),
        cmocka_unit_test(levels_are_those_below),
        cmocka_unit_test(bricks_are_those_of_the_map),
        cmocka_unit_test(nothing_gets_out_of_a_room),
        cmocka_unit_test(what_moves_is_made_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
