#include "runtime/indirect/voxels/voxels.h"
#include "tests/frame/frame_voxels.h"
#include "tests/frame/frame_draw.h"
#include "tests/test.h"
#include <stdio.h>
#include <stdlib.h>

static const char head[] = "image: { width: 96, height: 72 }\ncamera: { camera: Perspective, "
                           "position: [2, -5, 3], target: [0, 0, .6] }\n"
                           "materials: { m: { material: Phong, diffuse: .6 } }\n";

bool frame_voxels_bit(const FrameVoxelsDrawn *d, const int at[3])
{
    const size_t column = (size_t)at[1] * (size_t)d->size + (size_t)at[0];
    return d->words[column * (size_t)(d->size / 32) + (size_t)(at[2] / 32)] >> at[2] % 32 & 1;
}

uint32_t *frame_voxels_level(const FrameVoxelsDrawn *d, int level)
{
    const FrameVoxels *voxels = d->renderer->voxels;
    const GlContext *gl = d->gl;
    const int edge = d->size >> level, words = d->size / 32;
    uint32_t *made = malloc((size_t)edge * (size_t)edge * (size_t)words * sizeof *made);
    uint32_t *layer = malloc((size_t)edge * (size_t)edge * 4 * sizeof *layer);
    assert_true(made && layer);
    for (int k = 0; k < voxels->layers; k++) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, voxels->framebuffer);
        for (int i = 0; i < VOXELS_LAYERS_MAX; i++)
            gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + (GLenum)i,
                                        i ? 0 : voxels->map, i ? 0 : level, i ? 0 : k);
        gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl->ReadPixels(0, 0, edge, edge, GL_RGBA_INTEGER, GL_UNSIGNED_INT, layer);
        for (int i = 0; i < edge * edge; i++)
            for (int component = 0; component < 4 && 4 * k + component < words; component++)
                made[(size_t)i * (size_t)words + (size_t)(4 * k + component)] =
                    layer[4 * i + component];
    }
    free(layer);
    assert_int_equal(gl->GetError(), 0);
    return made;
}

FrameVoxelsDrawn frame_voxels_drawn(const char *objects, int size)
{
    const MatcOptions options = frame_exact_options();
    char text[4096];
    FrameVoxelsDrawn d = {.size = size, .gl = frame_context()};
    snprintf(text, sizeof text, "%svoxels: { size: %d }\nobjects:\n%s", head, size, objects);
    d.scene = frame_scene(text, &options, &d.document);
    d.renderer = renderer_open(d.gl, &(RendererOptions){.compile = &options, .view = "voxels"});
    assert_true(d.renderer && renderer_set_scene(d.renderer, d.scene) &&
                renderer_frame(d.renderer));
    d.words = frame_voxels_level(&d, 0);
    return d;
}

void frame_voxels_forget(FrameVoxelsDrawn *d)
{
    renderer_close(d->renderer);
    frame_forget(d->scene, d->document);
    gl_close(d->gl);
    free(d->words);
}
