/* Draws shadow maps: depth from the lights, and transparent casters into their lists. */
#include "runtime/frame/frame.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/shadow/soft_views.h"
#include <math.h>

/* Sets the matrix from world space to clip space, with depth from 0 to 1, or from -1 to 1 (twice
 * that minus w). */
static void clip_of(const ShadowView *view, bool zero_to_one, double m[16])
{
    static const double one[4] = {0, 0, 0, 1};
    const double near[4] = {0, 0, 0, view->near};
    const double *const depth = view->near > 0 ? near : view->rows[2], *const w =
                                                                           view->near > 0
                                                                               ? view->rows[2]
                                                                               : one;
    for (int column = 0; column < 4; column++) {
        m[4 * column] = view->rows[0][column];
        m[4 * column + 1] = view->rows[1][column];
        m[4 * column + 2] = zero_to_one ? depth[column] : 2 * depth[column] - w[column];
        m[4 * column + 3] = w[column];
    }
}

enum { STEPS_PUSHED = -2 }; /* depth offset units */

/* Returns the slope-scaled bias of a map in texels. shadow.glsl gives its size and reason. */
static float slopes_of(const Render *render)
{
    return -(float)(render->scene->shadow_filter + 1) - 1.0f / 64;
}

static void push(const Render *render)
{
    render->gl->PolygonOffset(slopes_of(render), STEPS_PUSHED);
}

static void begin(const Render *render)
{
    const GlContext *gl = render->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, render->shadows->framebuffer);
    gl->DrawBuffers(1, (GLenum[]){GL_NONE});
    gl->ReadBuffer(GL_NONE);
    gl->Viewport(0, 0, render->scene->shadow_size, render->scene->shadow_size);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);
    gl->Enable(GL_POLYGON_OFFSET_FILL);
    push(render);
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

/* Restores the context's initial state. */
static void end(const Render *render)
{
    const GlContext *gl = render->gl;
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl->PolygonOffset(0, 0);
    gl->Disable(GL_POLYGON_OFFSET_FILL);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

/* A view, its layer, and the bias and texel size for ray-marched casters. */
typedef struct {
    const ShadowView *view;
    int number;
    GpuSceneLightTrace trace;
} Casting;

/* Draws the opaque or the transparent shadow casters of a view. */
static void cast_view(Render *render, const GpuSceneSource *source, const Casting *casting,
                      bool transparent)
{
    const ShadowView *view = casting->view;
    const CullVolume volume = shadow_views_volume(view);
    double clip[16];
    clip_of(view, render->zero_to_one, clip);
    gpu_scene_cast(render->gl, source, &render->gpu_scene,
                   &(GpuSceneLight){.clip_from_world = clip,
                                    .volume = &volume,
                                    .mirrored = view->mirrored,
                                    .solid = &render->shadows->solid,
                                    .number = casting->number,
                                    .varying = view->method->even,
                                    .traced = view->method->meshes ? NULL : &casting->trace},
                   transparent);
}

/* Draws a half-cube map, whose faces share one layer. Lookups go along the point's own ray, so a
 * slope-scaled bias of one texel suffices. */
static void cast_soft(Render *render, const GpuSceneSource *source, int number, bool transparent)
{
    const GlContext *gl = render->gl;
    const int size = render->scene->shadow_size;
    const float slopes = -1.0f - 1.0f / 64;
    gl->PolygonOffset(slopes, STEPS_PUSHED);
    for (int face = 0; face < SOFT_VIEWS_FACES; face++) {
        ShadowView view;
        int rect[4];
        soft_views_face(&render->shadows->views.views[number], size, face, &view, rect);
        gl->Viewport(rect[0], rect[1], rect[2], rect[3]);
        const float texel[2] = {2 / (float)rect[2], 2 / (float)rect[3]};
        const float corner[2] = {-texel[0] * (float)rect[0] - 1, -texel[1] * (float)rect[1] - 1};
        const Casting casting = {
            &view, number, {{slopes, STEPS_PUSHED}, {texel[0], texel[1]}, {corner[0], corner[1]}}};
        cast_view(render, source, &casting, transparent);
    }
    gl->Viewport(0, 0, size, size);
    push(render);
}

void shadow_draw_cast(Render *render, const GpuSceneSource *source, int number, bool transparent)
{
    const ShadowView *view = &render->shadows->views.views[number];
    if (view->soft)
        cast_soft(render, source, number, transparent);
    else {
        const float texel = 2 / (float)render->scene->shadow_size;
        const Casting casting = {
            view, number, {{slopes_of(render), STEPS_PUSHED}, {texel, texel}, {-1, -1}}};
        cast_view(render, source, &casting, transparent);
    }
}

void shadow_draw_layer(const Render *render, int number)
{
    render->gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, render->shadows->maps,
                                        0, number);
}

void shadow_draw_depths(Render *render)
{
    const GpuSceneSource source = frame_source(render);
    begin(render);
    for (int i = 0; i < render->shadows->views.count; i++) {
        const ShadowMethod *method = render->shadows->views.views[i].method;
        shadow_draw_layer(render, i);
        render->gl->ClearBufferfv(GL_DEPTH, 0, (float[]){0});
        if (method->draw)
            method->draw(render, &source, i);
        else if (!method->even)
            shadow_draw_cast(render, &source, i, false);
        push(render);
        if (!shadow_glass_needed(render) && !method->apart)
            shadow_draw_cast(render, &source, i, true);
    }
    end(render);
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if ((*row)->drawn)
            (*row)->drawn(render);
}

/* Scissors a part's texels in a map; the viewport clips at the map's end. */
static void cut(const GlContext *gl, const ShadowPart *part, GLuint map_row)
{
    const GLint first = (GLint)part->row - (GLint)map_row, low = first > 0 ? first : 0;
    gl->Scissor((GLint)part->column, low, (GLsizei)part->columns,
                first + (GLsizei)part->rows - low);
}

/* Draws the lists of a part, for all maps in which it has texels. */
void shadow_draw_lists(Render *render, const ShadowPart *part)
{
    const GpuSceneSource source = frame_source(render);
    const GLuint size = (GLuint)render->scene->shadow_size;
    begin(render);
    render->gl->DepthMask(GL_FALSE); /* transparent casters do not occlude */
    render->gl->Enable(GL_SCISSOR_TEST);
    shadow_glass_begin(render, part);
    for (GLuint i = part->row / size; i * size < part->row + part->rows; i++) {
        shadow_draw_layer(render, (int)i);
        cut(render->gl, part, i * size);
        render->gl->DepthFunc(render->shadows->views.views[i].method->apart ? GL_ALWAYS
                                                                            : GL_GREATER);
        shadow_draw_cast(render, &source, (int)i, true);
    }
    shadow_glass_end(render);
    render->gl->Disable(GL_SCISSOR_TEST);
    render->gl->DepthMask(GL_TRUE);
    end(render);
}
