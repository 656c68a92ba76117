/* Drawing of surfaces for the rasterizing passes: context state, the GPU scene's objects in the
 * view's style, and infinite planes. */
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/surface_draw.h"

void surface_draw_begin(const Renderer *renderer, const Framebuffer *framebuffer, GLenum test)
{
    const GlContext *gl = renderer->gl;
    frame_use(renderer, framebuffer);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(test);
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void surface_draw_end(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

bool surface_draw_is_shown(const Renderer *renderer)
{
    return !renderer->look || renderer->look->scene != FRAME_LOOK_none;
}

void surface_draw_objects(Renderer *renderer, bool transparent)
{
    const bool lines = renderer->look && renderer->look->scene == FRAME_LOOK_lines;
    if (!surface_draw_is_shown(renderer))
        return;
    if (lines)
        renderer->gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gpu_scene_draw(renderer->gl, &renderer->gpu_scene, transparent);
    if (lines)
        renderer->gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void surface_draw_planes(Renderer *renderer, bool transparent)
{
    for (int i = 0; i < renderer->gpu_scene.plane_count; i++) {
        GpuScenePlane *plane = &renderer->gpu_scene.planes[i];
        if (plane->transparent != transparent)
            continue;
        material_use(&plane->material);
        screen_draw(renderer->gl, &renderer->screen);
    }
}
