/* The pass shadow: depth as lights see it. Maps stay until the scene changes: a further frame draws none. shadow.glsl says what becomes of
 * them. */
#include "runtime/render/frame.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

extern const char render_text_shadow_depth[];

bool pass_shadow_needed(const Render *render) { return render->shadows.views.count > 0; }

static bool make_maps(Render *render)
{
    GlContext *gl = render->gl;
    ShadowMaps *maps = &render->shadows;
    const int size = render->scene->shadow_size, count = maps->views.count;
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (count > most || size > gl->max_texture_size)
        return gl_fail(gl, "%d shadow maps of %d x %d are asked for, the driver has %d of %d x %d", count, size, size,
                       most, gl->max_texture_size, gl->max_texture_size);
    gl->GenTextures(1, &maps->maps);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, maps->maps);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, size, size, count, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   NULL);
    gl->GenFramebuffers(1, &maps->framebuffer);
    return gl_check(gl, "making shadow maps");
}

static bool make_solid(Render *render)
{
    ShadowMaps *maps = &render->shadows;
    const bool instances = render->cache.instances, modern = render->gl->major * 10 + render->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, instances ? "#define INSTANCES\n" : "", render_text_shadow_depth},
                              .fragment = {head, "void main() {}\n"}};
    return maps->solid.store || material_make(render->store, NULL, &text, &maps->solid);
}

bool pass_shadow_make(Render *render)
{
    return make_maps(render) && make_solid(render) && shadow_glass_make(render) && pass_shadow_count(render);
}

/* -- drawing */

/* Clip space from the world. Depth goes from 0 to 1 there, or from -1: twice that, less w. */
static void clip_of(const ShadowView *view, bool zero_to_one, double m[16])
{
    static const double one[4] = {0, 0, 0, 1};
    const double near[4] = {0, 0, 0, view->near};
    const double *const depth = view->near > 0 ? near : view->rows[2], *const w = view->near > 0 ? view->rows[2] : one;
    for (int column = 0; column < 4; column++) {
        m[4 * column] = view->rows[0][column];
        m[4 * column + 1] = view->rows[1][column];
        m[4 * column + 2] = zero_to_one ? depth[column] : 2 * depth[column] - w[column];
        m[4 * column + 3] = w[column];
    }
}

/* Half spaces that the map shows. */
static CullVolume volume_of(const ShadowView *view)
{
    CullVolume volume = {.count = 4};
    for (int i = 0; i < volume.count; i++) {
        double *plane = volume.planes[i];
        for (int k = 0; k < 4; k++) {
            const double far = view->near > 0 ? view->rows[2][k] : k == 3;
            plane[k] = far + (i % 2 ? 1 : -1) * view->rows[i / 2][k];
        }
        const double length = sqrt(scene_vector_dot(plane, plane));
        for (int k = 0; k < 4; k++)
            plane[k] /= length;
        volume.terms[i] = fabs(plane[3]);
    }
    return volume;
}

static void draw_view(Render *render, const CacheSource *source, int number)
{
    const GlContext *gl = render->gl;
    const ShadowView *view = &render->shadows.views.views[number];
    const CullVolume volume = volume_of(view);
    double clip[16];
    clip_of(view, render->zero_to_one, clip);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, render->shadows.maps, 0, number);
    gl->ClearBufferfv(GL_DEPTH, 0, (float[]){0});
    const CacheLight light = {clip, &volume, view->mirrored, &render->shadows.solid, number};
    cache_cast(render->gl, source, &render->cache, &light, false);
    gl->DepthMask(!shadow_glass_needed(render)); /* what is transparent hides nothing */
    cache_cast(render->gl, source, &render->cache, &light, true);
    gl->DepthMask(GL_TRUE);
}

/* Slopes push away from the light; so do two steps of depth. shadow.glsl says by how much, and why. */
static void begin(const Render *render)
{
    const GlContext *gl = render->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, render->shadows.framebuffer);
    gl->DrawBuffers(1, (GLenum[]){GL_NONE});
    gl->ReadBuffer(GL_NONE);
    gl->Viewport(0, 0, render->scene->shadow_size, render->scene->shadow_size);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);
    gl->Enable(GL_POLYGON_OFFSET_FILL);
    gl->PolygonOffset(-(float)(render->scene->shadow_filter + 1) - 1.0f / 64, -2);
    if (render->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

/* As a context begins. */
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

void pass_shadow_draw(Render *render)
{
    if (render->shadows.drawn)
        return;
    const CacheSource source = frame_source(render);
    begin(render);
    if (shadow_glass_needed(render))
        shadow_glass_begin(render);
    for (int i = 0; i < render->shadows.views.count; i++)
        draw_view(render, &source, i);
    if (shadow_glass_needed(render))
        shadow_glass_end(render);
    end(render);
    render->shadows.drawn = true;
}

bool pass_shadow_count(Render *render)
{
    bool again = shadow_glass_needed(render) && render->shadows.maps && !render->shadows.drawn, fine = true;
    while (again && fine) {
        pass_shadow_draw(render);
        fine = shadow_glass_check(render, &again);
        render->shadows.drawn = fine && !again;
    }
    return fine;
}

void pass_shadow_delete(Render *render)
{
    const GlContext *gl = render->gl;
    ShadowMaps *maps = &render->shadows;
    gl->DeleteFramebuffers(1, &maps->framebuffer); /* GL ignores the name 0 */
    gl->DeleteTextures(1, &maps->maps);
    gl->DeleteTextures(1, &maps->table);
    gl->DeleteTextures(1, &maps->planes);
    shadow_views_free(&maps->views);
    shadow_glass_delete(render);
    *maps = (ShadowMaps){.solid = maps->solid};
}
