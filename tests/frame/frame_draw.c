/* What tests of frames do again and again. */
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
    static const char text[] = "layout: floats\ntargets: [RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI]\n"
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

GlContext *frame_context(void)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    if (!gl)
        end(error);
    return gl;
}

float *frame_floats(GlContext *gl, const Scene *scene, const RenderOptions *options)
{
    Render *render = render_open(gl, options);
    if (!render || !render_scene(render, scene) || !render_frame(render))
        end(gl->error);
    float *rgba = calloc((size_t)render_tile_width(render) * (size_t)render_tile_height(render), 4 * sizeof *rgba);
    if (!rgba || !render_read(render, rgba))
        end(gl->error);
    render_close(render);
    return rgba;
}

char *frame_graph(const Render *render)
{
    char *graph = render_graph(render), *to = graph;
    if (!graph)
        end("no memory for a graph");
    for (const char *from = graph; *from; from++)
        if (*from != ' ' || from[1] != ' ')
            *to++ = *from;
    *to = 0;
    return graph;
}

void frame_forget(Scene *scene, MatcDocument *document)
{
    scene_free(scene);
    matc_document_free(document);
}
