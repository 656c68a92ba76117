#include "tests/frame/frame_change.h"
#include "tests/frame/frame_calls.h"
#include "tests/test.h"
#include <stdlib.h>

static size_t floats_of(const Render *render)
{
    return 4 * (size_t)render_tile_width(render) * (size_t)render_tile_height(render);
}

float *frame_change_next(Render *render)
{
    float *rgba = calloc(floats_of(render), sizeof *rgba);
    assert_true(rgba && render_frame(render) && render_read(render, rgba));
    return rgba;
}

void frame_change_assert(GlContext *gl, const RenderOptions *how, Render *changed,
                         const Scene *scene)
{
    Render *fresh = render_open(gl, how);
    assert_true(fresh && render_scene(fresh, scene));
    float *a = frame_change_next(changed), *b = frame_change_next(fresh);
    assert_int_equal(floats_of(changed), floats_of(fresh));
    assert_memory_equal(a, b, floats_of(fresh) * sizeof *a);
    render_close(fresh);
    free(a);
    free(b);
}

void frame_change_moves(GlContext *gl, const RenderOptions *how, Scene *scene,
                        const FrameMoves *moves)
{
    Render *render = render_open(gl, how);
    frame_count_calls(gl);
    assert_true(render && render_scene(render, scene));
    free(frame_change_next(render));
    frame_calls = (FrameCalls){0};
    free(frame_change_next(render));
    assert_true(frame_calls.made == 0 && frame_calls.written == 0);
    scene->objects[1].world_from_local.m[12] += moves->object;
    assert_true(render_changed_objects(render, 1, 1));
    frame_change_assert(gl, how, render, scene);
    scene->lights[moves->light].position[moves->axis] += moves->by;
    assert_true(render_changed(render, RENDER_LIGHTS));
    frame_change_assert(gl, how, render, scene);
    scene->camera.position[2] += .25;
    assert_true(render_changed(render, RENDER_CAMERA));
    frame_change_assert(gl, how, render, scene);
    render_close(render);
}
