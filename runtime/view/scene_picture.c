/* Opens a renderer for one picture. */
#include "runtime/view/scene_picture.h"
#include <math.h>
#include <stdlib.h>

/* NaN is 0. */
static uint8_t byte_of(float lane) { return lane > 0 ? (uint8_t)lrintf(255 * fminf(lane, 1)) : 0; }

static bool read_bytes(Render *render, PngPicture *picture)
{
    const size_t pixels = (size_t)render_width(render) * (size_t)render_height(render);
    float *rgba = malloc(pixels * 4 * sizeof *rgba);
    *picture = (PngPicture){render_width(render), render_height(render), 3, malloc(pixels * 3)};
    bool done = rgba && picture->bytes && render_read(render, rgba);
    for (size_t i = 0; done && i < 3 * pixels; i++)
        picture->bytes[i] = byte_of(rgba[i / 3 * 4 + i % 3]);
    if (!done) {
        free(picture->bytes);
        picture->bytes = NULL;
    }
    free(rgba);
    return done;
}

static bool draw(Render *render, const ScenePictureOptions *options, PngPicture *picture, char **words)
{
    if (options->graph) {
        *words = render_graph(render);
        return true;
    }
    if (!render_frame(render) || !read_bytes(render, picture))
        return false;
    *words = options->stats ? render_stats(render) : NULL;
    return true;
}

bool scene_picture_draw(GlContext *gl, const Scene *scene, const ScenePictureOptions *options, PngPicture *picture,
                        char **words)
{
    Render *render = render_open(gl, &options->render);
    *picture = (PngPicture){0};
    *words = NULL;
    const bool done = render && render_scene(render, scene) && draw(render, options, picture, words);
    render_close(render);
    return done;
}
