/* The pass shadow: depth as lights see it. Maps stay until the scene changes: a further frame draws none. shadow.glsl says what becomes of
 * them. */
#include "runtime/frame/frame.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/silhouette.h"
#include "runtime/shadow/volume.h"

extern const char render_text_shadow_depth[];

enum { SHADOW_MAPS_MIB = 4096 };

bool pass_shadow_needed(const Render *render) { return render->shadows.views.count > 0; }

/* Some drivers give memory that they do not have, and end the program when it is written. */
static bool check_maps(const Render *render)
{
    GlContext *gl = render->gl;
    const int size = render->scene->shadow_size, count = render->shadows.views.count;
    const int64_t mib = (int64_t)count * size * size * (int64_t)sizeof(float) >> 20;
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (count > most || size > gl->max_texture_size)
        return gl_fail(gl, "%d shadow maps of %d x %d are asked for, the driver has %d of %d x %d", count, size, size,
                       most, gl->max_texture_size, gl->max_texture_size);
    return mib <= SHADOW_MAPS_MIB || gl_fail(gl, "%d shadow maps of %d x %d take %d MiB; at most %d are made", count,
                                             size, size, (int)mib, SHADOW_MAPS_MIB);
}

static bool make_maps(Render *render)
{
    GlContext *gl = render->gl;
    ShadowMaps *maps = &render->shadows;
    const int size = render->scene->shadow_size, count = maps->views.count;
    if (!check_maps(render))
        return false;
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
    return make_maps(render) && make_solid(render) && silhouette_make(render) && volume_blur_make(render) &&
           volume_data_make(render) && shadow_parts_make(render) && pass_shadow_count(render);
}

void pass_shadow_draw(Render *render)
{
    if (render->shadows.drawn)
        return;
    shadow_draw_depths(render);
    volume_data_write(render);
    if (shadow_glass_needed(render) && !render->parted)
        shadow_draw_lists(render, render->shadows.glass.parts);
    render->shadows.drawn = true;
}

bool pass_shadow_count(Render *render)
{
    if (!shadow_glass_needed(render) || !render->shadows.maps || render->shadows.drawn)
        return true;
    shadow_draw_depths(render);
    volume_data_write(render);
    render->shadows.drawn = shadow_parts_count(render);
    return render->shadows.drawn;
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
    shadow_sheet_delete(render);
    silhouette_delete(render);
    *maps = (ShadowMaps){.solid = maps->solid};
}
