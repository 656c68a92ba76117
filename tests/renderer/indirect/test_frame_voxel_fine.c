/* Voxelization of small triangles without the rasterizer: they fill the same voxels as the
 * rasterizer, except on their edges; a shell whose corners and edges lie on sample lines is
 * watertight to a flood fill, at any rotation; large triangles, and alpha-tested ones, use the
 * rasterizer. */
/* ctest: seconds=21 */
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_voxels.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT = 2048, SIZE = 64, AROUND = 2 /* empty layers */ };

/* -- a shell: six sheets of squares, two triangles each, without corners in common */

typedef struct {
    char folder[32], path[64];
} ShellFile;

/* Writes a shell with half an edge `half`, in `squares` along an edge. */
static ShellFile write_shell(double half, int squares)
{
    ShellFile made = {.folder = "/tmp/matc_shell_XXXXXX"};
    assert_non_null(mkdtemp(made.folder));
    snprintf(made.path, sizeof made.path, "%s/shell.obj", made.folder);
    FILE *file = fopen(made.path, "w");
    const int corners = squares + 1;
    assert_non_null(file);
    for (int side = 0; side < 6; side++)
        for (int i = 0; i < corners * corners; i++) {
            double at[3];
            at[side / 2] = side % 2 ? half : -half;
            at[(side / 2 + 1) % 3] = half * (2. * (i % corners) / squares - 1);
            at[(side / 2 + 2) % 3] = half * (2. * (i / corners) / squares - 1);
            fprintf(file, "v %.9g %.9g %.9g\n", at[0], at[1], at[2]);
        }
    for (int side = 0; side < 6; side++)
        for (int i = 0; i < squares * squares; i++) {
            const int first = 1 + side * corners * corners + i / squares * corners + i % squares;
            fprintf(file, "f %d %d %d\nf %d %d %d\n", first, first + 1, first + corners, first + 1,
                    first + corners + 1, first + corners);
        }
    assert_int_equal(fclose(file), 0);
    return made;
}

static void remove_shell(const ShellFile *shell)
{
    assert_true(!remove(shell->path) && !rmdir(shell->folder));
}

/* -- drawing */

/* Voxelizes all as surfaces, small triangles by compute, or all by the rasterizer. */
static uint32_t *draw_surfaces(FrameVoxelsDrawn *d, bool compute)
{
    FrameVoxels *voxels = d->renderer->voxels;
    for (int i = 0; i < d->renderer->gpu_scene.place_count; i++)
        voxels->waves[i] = compute ? voxel_bodies_surface(d->renderer, i) : 0;
    voxels->wave_count = 0;
    voxels->drawn = false;
    assert_true(renderer_frame(d->renderer));
    return frame_voxels_level(d, 0);
}

static int count_bits(const FrameVoxelsDrawn *d, const uint32_t *words, const uint32_t *without)
{
    int count = 0;
    for (int i = 0; i < d->size * d->size * d->size / 32; i++)
        for (uint32_t word = without ? words[i] & ~without[i] : words[i]; word; word &= word - 1)
            count++;
    return count;
}

/* -- tests */

/* Two of one mesh, one of them mirrored, stretched, and turned; an open shell. */
static void fine_surfaces_are_the_rasterisers(void **state)
{
    (void)state;
    static const struct {
        const char *objects;
        int most; /* voxels in which all are small */
    } scenes[] = {{"- { object: Sphere, detail: 200, material: m, transform: { translation: [0, 0, "
                   "1.013] } }\n"
                   "- { object: Sphere, detail: 200, material: m, transform: { translation: [1.7, "
                   ".3, .4], rotation: [.5, .3, "
                   ".4], scale: [-.6, .3, .5] } }\n",
                   512},
                  {"- { object: Mesh, file: " SOURCE_FOLDER
                   "/examples/scenes/shell.obj, material: m, transform: { rotation: [.3, "
                   ".2, .1] } }\n",
                   64}};
    static const int sizes[] = {32, 64, 256, 512};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes && sizes[k] <= scenes[i].most; k++) {
            FrameVoxelsDrawn d = frame_voxels_drawn(scenes[i].objects, sizes[k]);
            uint32_t *fine = draw_surfaces(&d, true);
            int taken = 0;
            for (int place = 0; place < d.renderer->gpu_scene.place_count; place++)
                taken += d.renderer->voxels->waves[place] == VOXELS_FINE;
            uint32_t *drawn = draw_surfaces(&d, false);
            const int all = count_bits(&d, drawn, NULL), more = count_bits(&d, fine, drawn),
                      less = count_bits(&d, drawn, fine);
            print_message("%d voxels, %d of %d places: %d full, %d more, %d less\n", sizes[k],
                          taken, d.renderer->gpu_scene.place_count, all, more, less);
            assert_true(taken == d.renderer->gpu_scene.place_count);
            assert_true(all > sizes[k] * sizes[k] / 4 && more < all / 100 && less < all / 100);
            free(fine);
            free(drawn);
            frame_voxels_forget(&d);
        }
}

/* A flood fill from a corner of the map, across faces of empty voxels, reaches everything except
 * the middle. */
static void flood(FrameVoxelsDrawn *d)
{
    const int n = d->size;
    unsigned char *met = calloc((size_t)n * (size_t)n, (size_t)n);
    int *way = malloc(sizeof *way * (size_t)n * (size_t)n * (size_t)n), count = 1;
    assert_true(met && way && !frame_voxels_bit(d, (int[]){0, 0, 0}));
    met[way[0] = 0] = 1;
    for (int next = 0; next < count; next++)
        for (int turn = 0; turn < 6; turn++) {
            int at[3] = {way[next] % n, way[next] / n % n, way[next] / n / n};
            at[turn / 2] += turn % 2 ? 1 : -1;
            const int to = (at[2] * n + at[1]) * n + at[0];
            if (at[turn / 2] < 0 || at[turn / 2] >= n || met[to] || frame_voxels_bit(d, at))
                continue;
            met[to] = 1;
            way[count++] = to;
        }
    assert_true(count > n * n);
    assert_false(met[(n / 2 * n + n / 2) * n + n / 2]);
    assert_false(frame_voxels_bit(d, (int[]){n / 2, n / 2, n / 2}));
    free(met);
    free(way);
}

/* Along the axes, with corners at each half of a voxel, all lines go through corners, and there are
 * just the voxels of the six sheets; and turned. */
static void nothing_gets_between_triangles(void **state)
{
    (void)state;
    static const char *const turns[] = {"", ", transform: { rotation: [.4, .7, .3] }",
                                        ", transform: { rotation: [0, 0, .78539816] }"};
    const double half = SIZE / 2. - 1;
    const ShellFile shell = write_shell(half, 4 * (int)half);
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        char text[TEXT];
        snprintf(text, sizeof text, "- { object: Mesh, file: %s, material: m%s }\n", shell.path,
                 turns[i]);
        FrameVoxelsDrawn d = frame_voxels_drawn(text, SIZE);
        free(d.words);
        d.words = draw_surfaces(&d, true);
        assert_int_equal(d.renderer->voxels->waves[0], VOXELS_FINE);
        flood(&d);
        const int full = count_bits(&d, d.words, NULL), edge = SIZE - AROUND;
        print_message("turn %d: %d full\n", (int)i, full);
        assert_true(i > 0 ||
                    (full >= 6 * edge * edge - 24 * edge && full <= 6 * (edge + 2) * (edge + 2)));
        frame_voxels_forget(&d);
    }
    remove_shell(&shell);
}

/* Triangles longer than eight voxels, and alpha-tested ones, are not voxelized by compute. */
static void what_is_large_is_drawn(void **state)
{
    (void)state;
    static const struct {
        const char *object;
        bool fine;
    } cases[] = {
        {"- { object: Sphere, detail: 64, material: m }\n", true},
        {"- { object: Sphere, detail: 16, material: m }\n", false},
        {"- { object: Sphere, detail: 64, material: m, transform: { scale: [1, 1, .01] } }\n",
         true},
        {"- { object: Box, material: m }\n", false},
        {"- { object: Sphere, detail: 64, material: { material: Phong, transparency: { map: "
         "Checker } } }\n",
         false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        FrameVoxelsDrawn d = frame_voxels_drawn(cases[i].object, SIZE);
        assert_int_equal(voxel_bodies_surface(d.renderer, 0), cases[i].fine ? VOXELS_FINE : 0);
        frame_voxels_forget(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fine_surfaces_are_the_rasterisers),
        cmocka_unit_test(nothing_gets_between_triangles),
        cmocka_unit_test(what_is_large_is_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
