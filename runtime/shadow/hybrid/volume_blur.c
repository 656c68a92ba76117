/* Depth blurring: a map's depths are first drawn to a separate texture; their weighted means
 * become the map. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/hybrid/volume.h"

bool volume_blur_make(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    const int size = renderer->scene->shadow_size;
    const ProgramText text = {.vertex = {"#version 330 core\n", screen_text},
                              .fragment = {"#version 330 core\n", render_text_volume_blur}};
    if (renderer->scene->shadow_volume != KEYWORD_Volume_blurred || !volume_lights_cast(renderer))
        return true;
    volumes->sharp = framebuffer_target(gl, &(TargetSpec){size, size, "DEPTH32F"});
    return volumes->sharp && material_make(renderer->store, NULL, &text, &volumes->blur);
}

void volume_blur_use(const Renderer *renderer)
{
    renderer->gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                                       volume_state(renderer)->sharp, 0);
}

void volume_blur_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const int inner = renderer->scene->shadow_size - 2;
    gl->ClearBufferfv(GL_DEPTH, 0, (float[]){0});
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(1, 1, inner, inner);
    gl->DepthFunc(GL_ALWAYS);
    gl->Disable(GL_POLYGON_OFFSET_FILL);
    texture_bind(gl, volume_state(renderer)->sharp, 0);
    material_use(&volume_state(renderer)->blur);
    screen_draw(gl, &renderer->screen);
    gl->Enable(GL_POLYGON_OFFSET_FILL);
    gl->DepthFunc(GL_GREATER);
    gl->Disable(GL_SCISSOR_TEST);
}

void volume_blur_delete(Renderer *renderer)
{
    if (volume_state(renderer)->blur.store)
        material_delete(&volume_state(renderer)->blur);
    renderer->gl->DeleteTextures(1, &volume_state(renderer)->sharp); /* GL ignores the name 0 */
}
