/* Draws shadow maps: depth from the lights, and transparent casters into their lists. */
#include "runtime/frame_graph/frame.h"
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

enum { STEPS_PUSHED = -2 }; /* units of the depth offset */

/* Returns the slope-scaled bias of a map in texels. shadow.glsl gives its size and reason. */
static float slopes_of(const Renderer *renderer)
{
    return -(float)(renderer->scene->shadow_filter + 1) - 1.0f / 64;
}

static void push(const Renderer *renderer)
{
    renderer->gl->PolygonOffset(slopes_of(renderer), STEPS_PUSHED);
}

static void begin(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->shadows->framebuffer);
    gl->DrawBuffers(1, (GLenum[]){GL_NONE});
    gl->ReadBuffer(GL_NONE);
    gl->Viewport(0, 0, renderer->scene->shadow_size, renderer->scene->shadow_size);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);
    gl->Enable(GL_POLYGON_OFFSET_FILL);
    push(renderer);
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

/* Restores the context's initial state. */
static void end(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    if (renderer->zero_to_one)
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
static void cast_view(Renderer *renderer, const GpuSceneSource *source, const Casting *casting,
                      bool transparent)
{
    const ShadowView *view = casting->view;
    const CullVolume volume = shadow_views_volume(view);
    double clip[16];
    clip_of(view, renderer->zero_to_one, clip);
    gpu_scene_cast(renderer->gl, source, &renderer->gpu_scene,
                   &(GpuSceneLight){.clip_from_world = clip,
                                    .volume = &volume,
                                    .mirrored = view->mirrored,
                                    .solid = &renderer->shadows->solid,
                                    .number = casting->number,
                                    .varying = view->method->even,
                                    .traced = view->method->meshes ? NULL : &casting->trace},
                   transparent);
}

/* Draws a half-cube map, whose faces share one layer. Lookups go along the point's own ray, so a
 * slope-scaled bias of one texel suffices. */
static void cast_soft(Renderer *renderer, const GpuSceneSource *source, int number,
                      bool transparent)
{
    const GlContext *gl = renderer->gl;
    const int size = renderer->scene->shadow_size;
    const float slopes = -1.0f - 1.0f / 64;
    gl->PolygonOffset(slopes, STEPS_PUSHED);
    for (int face = 0; face < SOFT_VIEWS_FACES; face++) {
        ShadowView view;
        int rect[4];
        soft_views_face(&renderer->shadows->views.views[number], size, face, &view, rect);
        gl->Viewport(rect[0], rect[1], rect[2], rect[3]);
        const float texel[2] = {2 / (float)rect[2], 2 / (float)rect[3]};
        const float corner[2] = {-texel[0] * (float)rect[0] - 1, -texel[1] * (float)rect[1] - 1};
        const Casting casting = {
            &view, number, {{slopes, STEPS_PUSHED}, {texel[0], texel[1]}, {corner[0], corner[1]}}};
        cast_view(renderer, source, &casting, transparent);
    }
    gl->Viewport(0, 0, size, size);
    push(renderer);
}

void shadow_draw_cast(Renderer *renderer, const GpuSceneSource *source, int number,
                      bool transparent)
{
    const ShadowView *view = &renderer->shadows->views.views[number];
    if (view->soft)
        cast_soft(renderer, source, number, transparent);
    else {
        const float texel = 2 / (float)renderer->scene->shadow_size;
        const Casting casting = {
            view, number, {{slopes_of(renderer), STEPS_PUSHED}, {texel, texel}, {-1, -1}}};
        cast_view(renderer, source, &casting, transparent);
    }
}

void shadow_draw_layer(const Renderer *renderer, int number)
{
    renderer->gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                          renderer->shadows->maps, 0, number);
}

void shadow_draw_depths(Renderer *renderer)
{
    const GpuSceneSource source = frame_source(renderer);
    begin(renderer);
    for (int i = 0; i < renderer->shadows->views.count; i++) {
        const ShadowMethod *method = renderer->shadows->views.views[i].method;
        shadow_draw_layer(renderer, i);
        renderer->gl->ClearBufferfv(GL_DEPTH, 0, (float[]){0});
        if (method->draw)
            method->draw(renderer, &source, i);
        else if (!method->even)
            shadow_draw_cast(renderer, &source, i, false);
        push(renderer);
        if (!shadow_glass_needed(renderer) && !method->apart)
            shadow_draw_cast(renderer, &source, i, true);
    }
    end(renderer);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->drawn)
            (*row)->drawn(renderer);
}

/* Scissors a part's texels in a map; the viewport clips at the map's end. */
static void cut(const GlContext *gl, const ShadowPart *part, GLuint map_row)
{
    const GLint first = (GLint)part->row - (GLint)map_row, low = first > 0 ? first : 0;
    gl->Scissor((GLint)part->column, low, (GLsizei)part->columns,
                first + (GLsizei)part->rows - low);
}

/* Draws the lists of a part, for all maps in which it has texels. */
void shadow_draw_lists(Renderer *renderer, const ShadowPart *part)
{
    const GpuSceneSource source = frame_source(renderer);
    const GLuint size = (GLuint)renderer->scene->shadow_size;
    begin(renderer);
    renderer->gl->DepthMask(GL_FALSE); /* transparent casters do not occlude */
    renderer->gl->Enable(GL_SCISSOR_TEST);
    shadow_glass_begin(renderer, part);
    for (GLuint i = part->row / size; i * size < part->row + part->rows; i++) {
        shadow_draw_layer(renderer, (int)i);
        cut(renderer->gl, part, i * size);
        renderer->gl->DepthFunc(renderer->shadows->views.views[i].method->apart ? GL_ALWAYS
                                                                                : GL_GREATER);
        shadow_draw_cast(renderer, &source, (int)i, true);
    }
    shadow_glass_end(renderer);
    renderer->gl->Disable(GL_SCISSOR_TEST);
    renderer->gl->DepthMask(GL_TRUE);
    end(renderer);
}
