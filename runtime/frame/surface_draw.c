/* Drawing of surfaces for the rasterizing passes: context state, the GPU scene's objects in the
 * view's style, and infinite planes. */
#include "runtime/frame/frame.h"
#include "runtime/frame/surface_draw.h"

void surface_draw_begin(const Render *render, const Framebuffer *framebuffer, GLenum test)
{
    const GlContext *gl = render->gl;
    frame_use(render, framebuffer);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(test);
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void surface_draw_end(const Render *render)
{
    const GlContext *gl = render->gl;
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

bool surface_draw_is_shown(const Render *render)
{
    return !render->look || render->look->scene != FRAME_LOOK_none;
}

void surface_draw_objects(Render *render, bool transparent)
{
    const bool lines = render->look && render->look->scene == FRAME_LOOK_lines;
    if (!surface_draw_is_shown(render))
        return;
    if (lines)
        render->gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gpu_scene_draw(render->gl, &render->gpu_scene, transparent);
    if (lines)
        render->gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void surface_draw_planes(Render *render, bool transparent)
{
    for (int i = 0; i < render->gpu_scene.plane_count; i++) {
        GpuScenePlane *plane = &render->gpu_scene.planes[i];
        if (plane->transparent != transparent)
            continue;
        material_use(&plane->material);
        screen_draw(render->gl, &render->screen);
    }
}
