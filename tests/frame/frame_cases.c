#include "tests/frame/frame_cases.h"
#include "tests/test.h"

void frame_cases(GlContext *gl, const ScreenPassText *text, const TextureSpec *cases,
                 const int size[2], float *rgba)
{
    Store *store = store_new(gl);
    Screen screen;
    ScreenPass pass;
    Framebuffer target;
    const FramebufferSpec spec = {
        .width = size[0], .height = size[1], .color_count = 1, .color_format = GL_RGBA32F};
    const GLuint name = texture_make(gl, cases);
    if (!store || !screen_make(gl, &screen) || !framebuffer_make(gl, &spec, &target) || !name ||
        !screen_pass_make(store, text, &pass))
        fail_msg("%s", gl->error);
    screen_pass_sampler(&pass, "cases", 0);
    texture_bind(gl, name, 0);
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    screen_pass_delete(&pass);
    framebuffer_delete(gl, &target);
    screen_delete(gl, &screen);
    gl->DeleteTextures(1, &name);
    store_free(store);
}
