/* Opens a renderer for one picture. Tiles are drawn from the top row of them to the lowest: files begin there. */
#include "runtime/view/scene_picture.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    GlContext *gl;
    const ScenePictureOptions *options;
    Render *render;
    PictureFile *file;
    float *band; /* a row of tiles, four floats a pixel */
    float *tile; /* what was read last, where a row has several; or NULL */
} Drawing;

static int least(int a, int b) { return a < b ? a : b; }

static bool is_picture(const char *view) { return !view || !strcmp(view, "shown"); }

static PictureSpec spec_of(const ScenePictureOptions *o, const Render *render)
{
    const bool exr = o->format == PICTURE_FORMAT_exr;
    const char *view = o->render.view ? o->render.view : "shown";
    const bool color = is_picture(view) || !strcmp(view, "light");
    const int lanes = render_lanes(render);
    return (PictureSpec){.format = o->format,
                         .width = render_width(render),
                         .height = render_height(render),
                         .lanes = lanes == 4 && !exr ? 3 : lanes,
                         .bits = o->bits ? o->bits
                                 : !exr  ? 8
                                 : color ? 16
                                         : 32,
                         .color = is_picture(view)};
}

/* One tile into its place in the band, whose lowest row is the picture's row y. */
static bool draw_tile(Drawing *d, int x, int y, int rows)
{
    const size_t tile = (size_t)render_tile_width(d->render), width = (size_t)render_width(d->render);
    const size_t seen = (size_t)least((int)tile, (int)width - x);
    render_move(d->render, x, y);
    if (!render_frame(d->render) || !render_read(d->render, d->tile ? d->tile : d->band))
        return false;
    for (size_t row = 0; d->tile && row < (size_t)rows; row++)
        memcpy(d->band + 4 * (row * width + (size_t)x), d->tile + 4 * row * tile, 4 * seen * sizeof *d->band);
    return true;
}

static bool write_rows(Drawing *d, int rows)
{
    const size_t floats = 4 * (size_t)render_width(d->render);
    const char *why = NULL;
    for (int row = rows - 1; row >= 0 && !why; row--)
        why = picture_file_row(d->file, d->band + (size_t)row * floats);
    return !why || gl_fail(d->gl, "%s", why);
}

static bool draw_bands(Drawing *d)
{
    const ScenePictureOptions *o = d->options;
    const int width = render_width(d->render), height = render_height(d->render);
    const int tile[2] = {render_tile_width(d->render), render_tile_height(d->render)};
    for (int y = (height - 1) / tile[1] * tile[1]; y >= 0; y -= tile[1]) {
        const int rows = least(tile[1], height - y);
        for (int x = 0; x < width; x += tile[0])
            if (!draw_tile(d, x, y, rows))
                return false;
        if (!write_rows(d, rows))
            return false;
        if (o->progress && y > 0)
            o->progress(o->user, height - y, height);
    }
    return true;
}

static bool write_picture(Drawing *d, ScenePicture *picture)
{
    const char *why;
    const PictureSpec spec = spec_of(d->options, d->render);
    const size_t rows = (size_t)render_tile_height(d->render) * 4 * sizeof(float);
    const size_t tile = (size_t)render_tile_width(d->render), width = (size_t)render_width(d->render);
    d->file = picture_file_open(&spec, &why);
    if (!d->file)
        return gl_fail(d->gl, "%s", why);
    d->tile = tile < width ? malloc(rows * tile) : NULL;
    d->band = malloc(rows * width);
    if ((tile < width && !d->tile) || !d->band)
        return gl_fail(d->gl, "out of memory");
    if (!draw_bands(d))
        return false;
    why = picture_file_finish(d->file, d->options->path);
    picture->faulty = why ? d->options->path : NULL;
    return !why || gl_fail(d->gl, "%s", why);
}

static bool draw(Drawing *d, ScenePicture *picture)
{
    if (d->options->graph) {
        picture->words = render_graph(d->render);
        return true;
    }
    if (!write_picture(d, picture))
        return false;
    picture->words = d->options->stats ? render_stats(d->render) : NULL;
    return true;
}

bool scene_picture_draw(GlContext *gl, const Scene *scene, const ScenePictureOptions *options, ScenePicture *picture)
{
    RenderOptions render = options->render;
    Drawing d = {.gl = gl, .options = options};
    const bool exr = options->format == PICTURE_FORMAT_exr;
    render.linear = exr;
    render.deep = options->bits > (exr ? 16 : 8);
    *picture = (ScenePicture){0};
    d.render = render_open(gl, &render);
    const bool done = d.render && render_scene(d.render, scene) && draw(&d, picture);
    render_close(d.render);
    picture_file_close(d.file);
    free(d.tile);
    free(d.band);
    return done;
}
