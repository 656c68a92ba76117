/* A failure ends the test. */
#include "tests/frame/frame_running.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>

static void need(bool fine, const char *why)
{
    if (fine)
        return;
    fprintf(stderr, "%s\n", why);
    abort();
}

void frame_running_open(GlContext *gl, const char *text, const RenderOptions *options,
                        FrameRunning *made)
{
    RenderOptions all = *options;
    *made = (FrameRunning){.options = frame_exact_options()};
    all.compile = &made->options;
    made->scene = frame_scene(text, &made->options, &made->document);
    made->render = render_open(gl, &all);
    need(made->render && render_scene(made->render, made->scene), gl->error);
    made->rgba = calloc((size_t)render_width(made->render) * (size_t)render_height(made->render),
                        4 * sizeof *made->rgba);
    need(made->rgba != NULL, "out of memory");
}

const float *frame_running_draw(FrameRunning *running)
{
    need(render_frame(running->render) && render_read(running->render, running->rgba),
         "a frame is not drawn");
    return running->rgba;
}

void frame_running_close(FrameRunning *running)
{
    render_close(running->render);
    frame_forget(running->scene, running->document);
    free(running->rgba);
}
