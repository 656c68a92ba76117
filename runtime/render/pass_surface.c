/* The passes that rasterise: surfaces into depth and G-buffer, planes beside them, the sky where nothing is. Depth is reversed: it begins at
 * 0, and what is nearer is greater. */
#include "runtime/cache/cache_trace.h"
#include "runtime/render/frame.h"

bool pass_surface_needed(const Render *render) { return render->scene != NULL; }
bool pass_plane_needed(const Render *render)
{
    return render->cache.opaque_plane_count > 0 && volume_view_has_scene(render);
}
bool pass_sky_needed(const Render *render) { return render->cache.has_sky && volume_view_has_scene(render); }

static void clear(const GlContext *gl, const Framebuffer *framebuffer)
{
    static const GLuint no_words[4];
    static const float no_floats[4];
    for (int i = 0; i < framebuffer->spec.color_count; i++)
        if (framebuffer_has_words(framebuffer, i))
            gl->ClearBufferuiv(GL_COLOR, i, no_words);
        else
            gl->ClearBufferfv(GL_COLOR, i, no_floats);
    gl->ClearBufferfv(GL_DEPTH, 0, no_floats);
}

void pass_surface_begin(const Render *render, const Framebuffer *framebuffer, GLenum test)
{
    const GlContext *gl = render->gl;
    frame_use(render, framebuffer);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(test);
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void pass_surface_end(const Render *render)
{
    const GlContext *gl = render->gl;
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

/* First which surfaces rays meet, then what these are made of: whatever else is nearer comes over them. */
static void draw_traced(Render *render, const Framebuffer *framebuffer)
{
    static const GLuint nothing[4];
    GlContext *gl = render->gl;
    const CacheSource source = frame_source(render);
    frame_use(render, &render->draws[FRAME_DRAW_traced]);
    gl->ClearBufferuiv(GL_COLOR, 0, nothing);
    cache_trace_rays(gl, &source, &render->cache);
    frame_use(render, framebuffer);
    gl->Disable(GL_DEPTH_TEST);
    cache_trace_surfaces(gl, &source, &render->cache, frame_texture(render, FRAME_TARGET_traced, 0));
    gl->Enable(GL_DEPTH_TEST);
}

/* Numbers of triangles stay where they are until something moves. */
void pass_surface_draw(Render *render)
{
    const bool numbers = facet_lights_seen(render) && !render->exact.seen;
    const Framebuffer *framebuffer = &render->draws[numbers ? FRAME_DRAW_seen : FRAME_DRAW_surface];
    pass_surface_begin(render, framebuffer, GL_GREATER);
    clear(render->gl, framebuffer);
    pass_exact_begin(render);
    if (render->cache.tracing && volume_view_has_scene(render))
        draw_traced(render, framebuffer);
    volume_view_draw_surfaces(render, false);
    pass_surface_end(render);
    render->exact.seen |= numbers;
}

void pass_plane_planes(Render *render, bool transparent)
{
    for (int i = 0; i < render->cache.plane_count; i++) {
        CachePlane *plane = &render->cache.planes[i];
        if (plane->transparent != transparent)
            continue;
        material_use(&plane->material);
        screen_draw(render->gl, &render->screen);
    }
}

void pass_plane_draw(Render *render)
{
    pass_surface_begin(render, &render->draws[FRAME_DRAW_surface], GL_GREATER);
    pass_plane_planes(render, false);
    pass_surface_end(render);
}

/* Every depth of the triangle is 0, whatever clip space it comes from. */
void pass_sky_draw(Render *render)
{
    const GlContext *gl = render->gl;
    pass_surface_begin(render, &render->draws[FRAME_DRAW_sky], GL_EQUAL);
    gl->DepthRange(0, 0);
    material_use(&render->cache.sky);
    screen_draw(gl, &render->screen);
    gl->DepthRange(0, 1);
    pass_surface_end(render);
}
