/* Draws one frame after another; a failure ends the test. */
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

void frame_running_open(GlContext *gl, const char *text, const RendererOptions *options,
                        FrameRunning *made)
{
    RendererOptions all = *options;
    *made = (FrameRunning){.options = frame_exact_options()};
    all.compile = &made->options;
    made->scene = frame_scene(text, &made->options, &made->document);
    made->renderer = renderer_open(gl, &all);
    need(made->renderer && renderer_set_scene(made->renderer, made->scene), gl->error);
    made->rgba =
        calloc((size_t)renderer_width(made->renderer) * (size_t)renderer_height(made->renderer),
               4 * sizeof *made->rgba);
    need(made->rgba != NULL, "out of memory");
}

const float *frame_running_draw(FrameRunning *running)
{
    need(renderer_frame(running->renderer) && renderer_read(running->renderer, running->rgba),
         "a frame is not drawn");
    return running->rgba;
}

void frame_running_close(FrameRunning *running)
{
    renderer_close(running->renderer);
    frame_forget(running->scene, running->document);
    free(running->rgba);
}
