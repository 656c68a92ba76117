/* Steps that many frame tests share. */
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void end(const char *why)
{
    fprintf(stderr, "%s\n", why);
    abort();
}

MatcOptions frame_exact_options(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.layout = "integer";
    options.precision = "exact";
    options.aa = "none";
    options.pixels = true;
    return options;
}

MatcOptions frame_float_options(MatcLayout **layout)
{
    static const char text[] =
        "layout: floats\ntargets: [RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI]\n"
        "fields:\n"
        "- { slot: normal, encoding: full }\n- { slot: shininess, encoding: full }\n"
        "- { slot: diffuse, encoding: full }\n- { slot: specular, encoding: full }\n"
        "- { slot: ambient, encoding: full }\n- { slot: emissive, encoding: full }\n"
        "- { slot: diffuseTransparency, encoding: full }\n"
        "- { slot: transparency, encoding: full }\n"
        "- { slot: transparencyShininess, encoding: full }\n"
        "- { slot: interpolatedTransparency, encoding: full }\n";
    MatcOptions options = frame_exact_options();
    options.layout = NULL;
    *layout = matc_layout_read("floats.yaml", text, sizeof text - 1, &options);
    if (!matc_layout_ok(*layout))
        end(matc_layout_diagnostics(*layout, MATC_TEXT));
    options.custom = *layout;
    return options;
}

Scene *frame_scene(const char *text, const MatcOptions *options, MatcDocument **document)
{
    Scene *scene = NULL;
    *document = scene_read("scene.yaml", text, strlen(text), options, &scene);
    if (!scene)
        end(matc_diagnostics(*document, MATC_TEXT));
    return scene;
}

GlContext *frame_context_of(GlKind kind)
{
    char error[512] = "";
    GlContext *gl = gl_open(kind, true, error, sizeof error);
    if (!gl)
        end(error);
    return gl;
}

GlContext *frame_context(void) { return frame_context_of(GL_KIND_osmesa); }

GlKind frame_kind(int count, char **arguments)
{
    GlKind kind;
    return count > 1 && gl_kind_find(arguments[count - 1], &kind) ? kind : GL_KIND_osmesa;
}

float *frame_floats_by(GlContext *gl, Renderer *renderer, const Scene *scene)
{
    if (!renderer || !renderer_set_scene(renderer, scene) || !renderer_frame(renderer))
        end(gl->error);
    float *rgba =
        calloc((size_t)renderer_tile_width(renderer) * (size_t)renderer_tile_height(renderer),
               4 * sizeof *rgba);
    if (!rgba || !renderer_read(renderer, rgba))
        end(gl->error);
    return rgba;
}

float *frame_floats(GlContext *gl, const Scene *scene, const RendererOptions *options)
{
    Renderer *renderer = renderer_open(gl, options);
    float *rgba = frame_floats_by(gl, renderer, scene);
    renderer_close(renderer);
    return rgba;
}

/* Copies a tile into a picture, at its first pixel. */
static void put_tile(const Renderer *renderer, const float *tile, const int at[2], float *picture)
{
    const int width = renderer_width(renderer), height = renderer_height(renderer),
              tile_width = renderer_tile_width(renderer);
    const int columns = width - at[0] < tile_width ? width - at[0] : tile_width;
    for (int row = 0; row < renderer_tile_height(renderer) && at[1] + row < height; row++)
        memcpy(picture + 4 * ((size_t)(at[1] + row) * (size_t)width + (size_t)at[0]),
               tile + 4 * (size_t)row * (size_t)tile_width, 4 * (size_t)columns * sizeof *tile);
}

float *frame_tiles(GlContext *gl, const Scene *scene, const RendererOptions *options)
{
    Renderer *renderer = renderer_open(gl, options);
    if (!renderer || !renderer_set_scene(renderer, scene))
        end(gl->error);
    const int width = renderer_tile_width(renderer), height = renderer_tile_height(renderer);
    float *picture = calloc((size_t)renderer_width(renderer) * (size_t)renderer_height(renderer),
                            4 * sizeof *picture);
    float *tile = calloc((size_t)width * (size_t)height, 4 * sizeof *tile);
    for (int y = (renderer_height(renderer) - 1) / height * height; y >= 0; y -= height)
        for (int x = (renderer_width(renderer) - 1) / width * width; x >= 0; x -= width) {
            renderer_set_tile(renderer, x, y);
            if (!picture || !tile || !renderer_frame(renderer) || !renderer_read(renderer, tile))
                end(gl->error);
            put_tile(renderer, tile, (int[]){x, y}, picture);
        }
    free(tile);
    renderer_close(renderer);
    return picture;
}

char *frame_graph(const Renderer *renderer)
{
    char *graph = renderer_graph(renderer), *to = graph;
    if (!graph)
        end("no memory for a graph");
    for (const char *from = graph; *from; from++)
        if (*from != ' ' || from[1] != ' ')
            *to++ = *from;
    *to = 0;
    return graph;
}

char *frame_graph_or_fault(GlContext *gl, const Scene *scene, const RendererOptions *options)
{
    Renderer *renderer = renderer_open(gl, options);
    const bool done = renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer);
    char *reported = done ? frame_graph(renderer) : strdup(gl->error);
    renderer_close(renderer);
    return reported;
}

void frame_forget(Scene *scene, MatcDocument *document)
{
    scene_free(scene);
    matc_document_free(document);
}
