#include "tests/frame/pass_values.h"
#include "tests/test.h"

void pass_values(GlContext *gl, const ScreenPassText *text, int side, float (*values)[4])
{
    Store *store = store_new(gl);
    Screen screen;
    ScreenPass pass;
    Framebuffer target;
    const FramebufferSpec spec = {
        .width = side, .height = side, .color_count = 1, .color_format = GL_RGBA32F};
    if (!store || !screen_make(gl, &screen) || !framebuffer_make(gl, &spec, &target) ||
        !screen_pass_make(store, text, &pass))
        fail_msg("%s", gl->error);
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, values[0]));
    screen_pass_delete(&pass);
    framebuffer_delete(gl, &target);
    screen_delete(gl, &screen);
    store_free(store);
}
