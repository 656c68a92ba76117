/* The voxel view against small steps along each ray; refused settings. */
#include "tests/test.h"
#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_voxels.h"
#include <stdlib.h>

/* Marches along a pixel's ray in small steps: returns the face axis of the first full voxel, or
 * -1. */
static int component_seen(const FrameVoxelsDrawn *d, int pixel, int width, int height)
{
    const SceneCamera *camera = &d->scene->camera;
    const VoxelGrid *grid = &d->renderer->voxels->grid;
    const double half = camera->half, step = .02;
    const double x = (2 * (pixel % width) + 1 - width) * half / height,
                 y = (2 * (pixel / width) + 1 - height) * half / height;
    double at[3], way[3];
    for (int k = 0; k < 3; k++) {
        at[k] = (camera->position[k] - grid->low[k]) / grid->edge;
        way[k] = x * camera->right[k] + y * camera->up[k] - camera->back[k];
    }
    for (int i = 0; i < 400000; i++) {
        bool in = true;
        for (int k = 0; k < 3; k++) {
            at[k] += step * way[k];
            in &= at[k] >= 0 && at[k] < d->size;
        }
        if (in && frame_voxels_bit(d, (int[]){(int)at[0], (int)at[1], (int)at[2]}))
            return (int)at[2] / 32;
        if (at[2] < -d->size)
            break;
    }
    return -1;
}

static int component_shown(const float rgba[4])
{
    if (rgba[3] == 0)
        return -1;
    return rgba[0] > 2 * rgba[1]      ? 0
           : rgba[1] > 1.5f * rgba[2] ? 1
           : rgba[2] > 1.5f * rgba[0] ? 2
                                      : 3;
}

static void the_view_has_the_nearest_voxel(void **state)
{
    (void)state;
    enum { WIDTH = 96, HEIGHT = 72, PIXELS = WIDTH * HEIGHT };
    FrameVoxelsDrawn d = frame_voxels_drawn(FRAME_VOXELS_BODIES FRAME_VOXELS_SHEETS, 64);
    float *rgba = malloc(sizeof *rgba * 4 * PIXELS);
    int shown = 0, wrong = 0;
    assert_int_equal(renderer_components(d.renderer), 4);
    assert_true(renderer_frame(d.renderer) && renderer_read(d.renderer, rgba));
    for (int i = 0; i < PIXELS; i += 3) {
        const int component = component_seen(&d, i, WIDTH, HEIGHT);
        shown += component >= 0;
        wrong += component != component_shown(rgba + 4 * i);
    }
    print_message("%d pixels show voxels, %d others than small steps meet\n", shown, wrong);
    assert_true(shown > PIXELS / 12 && wrong <= 3);
    free(rgba);
    frame_voxels_forget(&d);
}

static void levels_there_are(void **state)
{
    (void)state;
    FrameVoxelsDrawn d = frame_voxels_drawn(FRAME_VOXELS_SHEETS, 32);
    const MatcOptions options = frame_exact_options();
    static const struct {
        const char *view, *reported;
    } cases[] = {
        {"voxels5", NULL},
        {"voxels6", "unknown view 'voxels6': the last of 32 voxels is voxels5"},
        {"voxels12", "unknown view 'voxels12'; expected final, wireframe, volume, light, depth, "
                     "shadow, positions, voxels, ao, indirect, bent, visibility, or a slot"},
        {"voxelsx", "unknown view 'voxelsx'; expected final, wireframe, volume, light, depth, "
                    "shadow, positions, voxels, ao, indirect, bent, visibility, or a slot"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Renderer *renderer =
            renderer_open(d.gl, &(RendererOptions){.compile = &options, .view = cases[i].view});
        const bool fine = renderer && renderer_set_scene(renderer, d.scene);
        assert_int_equal(fine, !cases[i].reported);
        if (!fine)
            assert_string_equal(d.gl->error, cases[i].reported);
        renderer_close(renderer);
    }
    frame_voxels_forget(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_view_has_the_nearest_voxel),
        cmocka_unit_test(levels_there_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
