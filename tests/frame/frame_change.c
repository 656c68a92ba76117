#include "tests/frame/frame_change.h"
#include "tests/frame/frame_calls.h"
#include "tests/test.h"
#include <stdlib.h>

static size_t floats_of(const Renderer *renderer)
{
    return 4 * (size_t)renderer_tile_width(renderer) * (size_t)renderer_tile_height(renderer);
}

float *frame_change_next(Renderer *renderer)
{
    float *rgba = calloc(floats_of(renderer), sizeof *rgba);
    assert_true(rgba && renderer_frame(renderer) && renderer_read(renderer, rgba));
    return rgba;
}

void frame_change_assert(GlContext *gl, const RendererOptions *how, Renderer *changed,
                         const Scene *scene)
{
    Renderer *fresh = renderer_open(gl, how);
    assert_true(fresh && renderer_set_scene(fresh, scene));
    float *a = frame_change_next(changed), *b = frame_change_next(fresh);
    assert_int_equal(floats_of(changed), floats_of(fresh));
    assert_memory_equal(a, b, floats_of(fresh) * sizeof *a);
    renderer_close(fresh);
    free(a);
    free(b);
}

void frame_change_moves(GlContext *gl, const RendererOptions *how, Scene *scene,
                        const FrameMoves *moves)
{
    Renderer *renderer = renderer_open(gl, how);
    frame_count_calls(gl);
    assert_true(renderer && renderer_set_scene(renderer, scene));
    free(frame_change_next(renderer));
    frame_calls = (FrameCalls){0};
    free(frame_change_next(renderer));
    assert_true(frame_calls.made == 0 && frame_calls.written == 0);
    scene->objects[1].world_from_local.m[12] += moves->object;
    assert_true(renderer_changed_objects(renderer, 1, 1));
    frame_change_assert(gl, how, renderer, scene);
    scene->lights[moves->light].position[moves->axis] += moves->by;
    assert_true(renderer_changed(renderer, RENDERER_LIGHTS));
    frame_change_assert(gl, how, renderer, scene);
    scene->camera.position[2] += .25;
    assert_true(renderer_changed(renderer, RENDERER_CAMERA));
    frame_change_assert(gl, how, renderer, scene);
    renderer_close(renderer);
}
