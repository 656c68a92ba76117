/* Draws all pictures with one renderer. Tiles are drawn from the top row of tiles down, since
 * image files start at the top. */
#include "runtime/viewer/scene_picture.h"
#include "runtime/scene/scene_origin.h"
#include "runtime/viewer/view_look.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct ScenePictures {
    GlContext *gl;
    ScenePictureOptions options;
    const Scene *scene;   /* the current scene */
    const ViewLook *look; /* maps the view to [0, 1] for a PNG; NULL: no mapping */
    Renderer *renderer;
    float *band; /* one row of tiles, four floats per pixel; NULL before the first picture */
    float *tile; /* the last tile read, if a row has several tiles; NULL: none */
};

static int least(int a, int b) { return a < b ? a : b; }

static bool is_picture(const char *view) { return !view || renderer_view_is_picture(view); }

/* Destination of a picture: a file (top row first), or RGB bytes (bottom row first). */
typedef struct {
    PictureFile *file;
    unsigned char *rgb;
} Sink;

static PictureSpec spec_of(const ScenePictures *p)
{
    const ScenePictureOptions *o = &p->options;
    const Renderer *renderer = p->renderer;
    const bool exr = o->format == PICTURE_FORMAT_exr;
    const char *view = o->renderer.view ? o->renderer.view : "final";
    const bool color = is_picture(view) || !strcmp(view, "light");
    const int components = o->look ? 3 : renderer_components(renderer);
    return (PictureSpec){.format = o->format,
                         .width = renderer_width(renderer),
                         .height = renderer_height(renderer),
                         .components = components == 4 && !exr ? 3 : components,
                         .bits = o->bits ? o->bits
                                 : !exr  ? 8
                                 : color ? 16
                                         : 32,
                         .color = is_picture(view) || o->look ||
                                  (p->look && view_look_is_color(p->look))};
}

/* Draws the tile at (x, y) into the band; y is the picture row of the band's lowest row. */
static bool draw_tile(ScenePictures *p, int x, int y, int rows)
{
    const size_t tile = (size_t)renderer_tile_width(p->renderer),
                 width = (size_t)renderer_width(p->renderer);
    const size_t seen = (size_t)least((int)tile, (int)width - x);
    renderer_set_tile(p->renderer, x, y);
    if (!renderer_frame(p->renderer) || !renderer_read(p->renderer, p->tile ? p->tile : p->band))
        return false;
    for (size_t row = 0; p->tile && row < (size_t)rows; row++)
        memcpy(p->band + 4 * (row * width + (size_t)x), p->tile + 4 * row * tile,
               4 * seen * sizeof *p->band);
    return true;
}

/* Converts floats in [0, 1] to bytes, rounded to nearest. */
static void put_bytes(const float *rgba, int width, unsigned char *rgb)
{
    for (int i = 0; i < 3 * width; i++)
        rgb[i] = (unsigned char)(255 * fminf(fmaxf(rgba[i / 3 * 4 + i % 3], 0), 1) + .5f);
}

/* Writes a band; y is the picture row of the band's lowest row. */
static bool write_rows(const ScenePictures *p, const Sink *sink, int y, int rows)
{
    const int width = renderer_width(p->renderer);
    const char *why = NULL;
    for (int row = rows - 1; row >= 0 && !why; row--) {
        const float *rgba = p->band + 4 * (size_t)row * (size_t)width;
        if (sink->file)
            why = picture_file_row(sink->file, rgba);
        else
            put_bytes(rgba, width, sink->rgb + 3 * (size_t)(y + row) * (size_t)width);
    }
    return !why || gl_fail(p->gl, "%s", why);
}

static bool draw_bands(ScenePictures *p, const Sink *sink)
{
    const ScenePictureOptions *o = &p->options;
    const int width = renderer_width(p->renderer), height = renderer_height(p->renderer);
    const int tile[2] = {renderer_tile_width(p->renderer), renderer_tile_height(p->renderer)};
    for (int y = (height - 1) / tile[1] * tile[1]; y >= 0; y -= tile[1]) {
        const int rows = least(tile[1], height - y);
        for (int x = 0; x < width; x += tile[0])
            if (!draw_tile(p, x, y, rows))
                return false;
        if (o->look)
            slot_look_show(o->look, p->band, (size_t)width * (size_t)rows);
        if (p->look)
            view_look_show(p->look, &p->scene->camera, p->band, (size_t)width * (size_t)rows);
        if (!write_rows(p, sink, y, rows))
            return false;
        if (o->progress && y > 0)
            o->progress(o->user, height - y, height);
    }
    return true;
}

/* Allocates a row of tiles, once for all pictures of a scene. */
static bool make_band(ScenePictures *p)
{
    const size_t rows = (size_t)renderer_tile_height(p->renderer) * 4 * sizeof(float);
    const size_t tile = (size_t)renderer_tile_width(p->renderer),
                 width = (size_t)renderer_width(p->renderer);
    if (p->band)
        return true;
    p->tile = tile < width ? malloc(rows * tile) : NULL;
    p->band = tile == width || p->tile ? malloc(rows * width) : NULL;
    return p->band || gl_fail(p->gl, "out of memory");
}

/* Writes all shadow maps side by side, the first on the left. */
static bool write_map_rows(ScenePictures *p, PictureFile *file, float *depths, float *rgba)
{
    const int count = renderer_map_count(p->renderer), size = renderer_map_size(p->renderer);
    const char *why = NULL;
    for (int map = 0; map < count; map++)
        if (!renderer_read_map(p->renderer, map,
                               depths + (size_t)map * (size_t)size * (size_t)size))
            return false;
    for (int row = size - 1; row >= 0 && !why; row--) {
        for (int i = 0; i < count * size; i++)
            rgba[4 * i] = depths[((size_t)(i / size) * (size_t)size + (size_t)row) * (size_t)size +
                                 (size_t)(i % size)];
        why = picture_file_row(file, rgba);
    }
    return !why || gl_fail(p->gl, "%s", why);
}

static bool write_maps(ScenePictures *p, const char *path, ScenePicture *picture)
{
    const int count = renderer_map_count(p->renderer),
              size = count ? renderer_map_size(p->renderer) : 0;
    const bool exr = p->options.format == PICTURE_FORMAT_exr;
    const PictureSpec spec = {p->options.format,
                              count * size,
                              size,
                              1,
                              p->options.bits ? p->options.bits : exr ? 32 : 8,
                              false};
    const char *why = "no light of the scene casts shadows by a map";
    PictureFile *file = count ? picture_file_open(&spec, &why) : NULL;
    if (!file)
        return gl_fail(p->gl, "%s", why);
    float *depths = malloc((size_t)count * (size_t)size * ((size_t)size + 4) * sizeof *depths);
    bool done = depths ? renderer_frame(p->renderer) : gl_fail(p->gl, "out of memory");
    done = done &&
           write_map_rows(p, file, depths, depths + (size_t)count * (size_t)size * (size_t)size);
    why = done ? picture_file_finish(file, path) : NULL;
    picture->faulty = why ? path : NULL;
    picture_file_close(file);
    free(depths);
    return done && (!why || gl_fail(p->gl, "%s", why));
}

static bool is_maps(const ScenePictures *p)
{
    return p->options.renderer.view && !strcmp(p->options.renderer.view, "shadow");
}

static bool write_picture(ScenePictures *p, const char *path, ScenePicture *picture)
{
    const char *why;
    const PictureSpec spec = spec_of(p);
    PictureFile *file = make_band(p) ? picture_file_open(&spec, &why) : NULL;
    if (!p->band)
        return false;
    if (!file)
        return gl_fail(p->gl, "%s", why);
    bool done = draw_bands(p, &(Sink){.file = file});
    why = done ? picture_file_finish(file, path) : NULL;
    picture->faulty = why ? path : NULL;
    picture_file_close(file);
    return done && (!why || gl_fail(p->gl, "%s", why));
}

bool scene_pictures_draw(ScenePictures *p, const char *path, ScenePicture *picture)
{
    *picture = (ScenePicture){0};
    if (p->options.graph) {
        picture->words = renderer_graph(p->renderer);
        return true;
    }
    if (!(is_maps(p) ? write_maps : write_picture)(p, path, picture))
        return false;
    picture->words = p->options.stats ? renderer_stats(p->renderer) : NULL;
    return true;
}

bool scene_pictures_pixels(ScenePictures *p, unsigned char *rgb)
{
    return make_band(p) && draw_bands(p, &(Sink){.rgb = rgb});
}

/* A moved origin changes the whole scene. */
bool scene_pictures_turn(ScenePictures *p, Scene *scene, Scene *seen)
{
    if (!scene_origin_follow(scene, &seen->camera))
        return renderer_changed(p->renderer, RENDERER_CAMERA | RENDERER_TIME);
    memcpy(seen->origin, scene->origin, sizeof seen->origin);
    return scene_pictures_show(p, seen);
}

char *scene_pictures_diagnostics(const ScenePictures *p)
{
    return renderer_diagnostics(p->renderer);
}

bool scene_pictures_param(ScenePictures *p, const char *uniform, const float *components, int count)
{
    return renderer_param(p->renderer, 0, uniform, components, count);
}

static void forget_band(ScenePictures *p)
{
    free(p->tile);
    free(p->band);
    p->tile = p->band = NULL;
}

bool scene_pictures_show(ScenePictures *p, const Scene *scene)
{
    forget_band(p); /* the new scene may have another tile size */
    p->scene = scene;
    if (!renderer_set_scene(p->renderer, scene))
        return false;
    return !renderer_missing_view(p->renderer) || !p->options.look ||
           gl_fail(p->gl,
                   "the layout does not store that slot; --layout=integer stores all of them");
}

ScenePictures *scene_pictures_open(GlContext *gl, const ScenePictureOptions *options)
{
    ScenePictures *made = calloc(1, sizeof *made);
    const bool exr = options->format == PICTURE_FORMAT_exr;
    if (!made)
        return gl_fail(gl, "out of memory"), NULL;
    *made = (ScenePictures){.gl = gl, .options = *options};
    made->options.renderer.linear = exr;
    if (!exr && !options->look) {
        made->options.look = options->renderer.view ? slot_look_find(options->renderer.view) : NULL;
        made->look = view_look_find(options->renderer.view);
    }
    made->options.renderer.deep = options->bits > (exr ? 16 : 8);
    made->renderer = renderer_open(gl, &made->options.renderer);
    if (made->renderer)
        return made;
    scene_pictures_close(made);
    return NULL;
}

void scene_pictures_close(ScenePictures *p)
{
    if (!p)
        return;
    renderer_close(p->renderer);
    forget_band(p);
    free(p);
}
