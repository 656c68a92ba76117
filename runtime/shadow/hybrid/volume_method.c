/* The technique's row: hybrid shadows. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/hybrid/volume.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

enum { COMPONENT_LIGHTS = 8 /* number of lights per component of the mask, one bit each */ };

static bool crossed(const Scene *scene)
{
    return scene->shadow_volume == KEYWORD_Volume_silhouette;
}

/* Returns the formats of targets: depth with a stencil, and a mask with a bit for each light. */
static const char *target(const Renderer *renderer, FrameTarget target)
{
    if (target == FRAME_TARGET_depth && volume_lights_cast(renderer))
        return "DEPTH32F_STENCIL8";
    return target == FRAME_TARGET_mask && volume_lights_count(renderer) > COMPONENT_LIGHTS ? "RGBA8"
                                                                                           : NULL;
}

static bool make_maps(Renderer *renderer)
{
    return volume_blur_make(renderer) && volume_data_make(renderer);
}

/* Draws one side of opaque casters, and nothing at the border, so that the resulting volume is
 * closed. */
static void draw(Renderer *renderer, const GpuSceneSource *source, int view)
{
    const GlContext *gl = renderer->gl;
    const Scene *scene = renderer->scene;
    const bool blurred = scene->shadow_volume == KEYWORD_Volume_blurred;
    const int inner = scene->shadow_size - 2;
    if (blurred) {
        volume_blur_use(renderer);
        gl->ClearBufferfv(GL_DEPTH, 0, (float[]){0});
    }
    gl->Enable(GL_CULL_FACE);
    gl->CullFace(blurred ? GL_BACK : GL_FRONT);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(1, 1, inner, inner);
    gl->PolygonOffset((blurred ? -(float)scene->shadow_offset : 0) - 1.0f / 64, -2);
    shadow_draw_cast(renderer, source, view, false);
    gl->Disable(GL_CULL_FACE);
    gl->CullFace(GL_BACK);
    gl->Disable(GL_SCISSOR_TEST);
    if (blurred) {
        shadow_draw_layer(renderer, view);
        volume_blur_draw(renderer);
    }
}

/* -- for lighting */

/* Returns the text for transparent surfaces, which look up a volume's cells; opaque surfaces
 * read the mask. */
static const char *cells_text(const Renderer *renderer, bool nearest)
{
    return volume_cells_are(renderer) && !nearest
               ? "#define SHADOW_CUT\n#define VOLUME_HAS\n#define VOLUME_DEPTHS shadow_maps\n"
                 "#define VOLUME_CROSSINGS silhouette_crossings\n"
               : "";
}

static void write_text(const Renderer *renderer, bool nearest, ShadowMethodText *made)
{
    if (!volume_lights_cast(renderer))
        return;
    snprintf(made->defined, sizeof made->defined,
             "#define SHADOW_APART\n%s%s#define SHADOW_QUADS %s\n#define SHADOW_STRETCHED %s\n",
             nearest ? "#define SHADOW_MASK\n" : "", cells_text(renderer, nearest),
             renderer->scene->shadow_volume == KEYWORD_Volume_perfect ? "true" : "false",
             renderer->scene->shadow_stretched ? "true" : "false");
    made->texts[0] = render_text_shadow_volume;
    made->texts[1] = render_text_volume_share;
    made->texts[2] = volume_cells_are(renderer) && !nearest ? render_text_volume_cells : NULL;
    made->calls[SHADOW_CALL_light] = "volumeLight";
}

static void bind(const Renderer *renderer, int unit)
{
    if (frame_texture(renderer, FRAME_TARGET_mask, 0))
        texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_mask, 0), unit);
}

/* Selects a variant: one for each kind of volume. */
static bool vary(Scene *scene, Keyword variant)
{
    if (!scene_volume_name(variant))
        return false;
    scene->shadow_volume = variant;
    return true;
}

extern const ShadowMethod shadow_hybrid;
const ShadowMethod shadow_hybrid = {
    .word = KEYWORD_Shadows_hybrid,
    .state = sizeof(FrameVolumes),
    .beside = true,
    .meshes = true,
    .apart = true,
    .target = target,
    .border = true,
    .single = true,
    .crossed = crossed,
    .make_maps = make_maps,
    .draw = draw,
    .drawn = volume_data_write,
    .text = write_text,
    .sampler = "shadow_mask",
    .bind = bind,
    .put = volume_data_put,
    .look = volume_shown_find,
    .look_make = volume_shown_make,
    .look_place = volume_shown_place,
    .look_draw = volume_shown_draw,
    .vary = vary,
};
