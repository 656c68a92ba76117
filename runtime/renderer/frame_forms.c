/* Formats and bytes of a frame's targets, by the scene, its shadows and its indirect light. */
#include "runtime/indirect/settings/indirect.h"
#include "runtime/light/light_far.h"
#include "runtime/renderer/passes.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"

/* Reports whether light needs 32-bit floats: with normals more accurate than this bound a half
 * float's error would dominate; rounding also adds up over several parts of shadow lists. */
static bool is_exact(const Renderer *renderer)
{
    const double degrees = 0.005;
    if (renderer->options.deep || renderer->tiled)
        return true;
    const LayoutRow *layout = material_set_layout(&renderer->set, &renderer->compile);
    for (int i = 0; i < layout->cases[0].field_count; i++) {
        const FieldRow *field = &layout->cases[0].fields[i];
        if (field->source[0].slot == SLOT_normal)
            return field_error(field) < degrees;
    }
    return false;
}

static const char *shown_format(const Renderer *renderer)
{
    const bool deep = renderer->options.deep;
    return renderer->options.linear ? deep ? "RGBA32F" : "RGBA16F" : deep ? "RGBA16" : "RGBA8";
}

static const char *format_of(const Renderer *renderer, FrameTarget target, int texture)
{
    const char *const light = is_exact(renderer) ? "RGBA32F" : "RGBA16F";
    const char *const open = renderer->options.deep ? "RGBA32F" : "RGBA16F";
    const char *const one[FRAME_TARGET_COUNT] = {[FRAME_TARGET_depth] = "DEPTH32F",
                                                 [FRAME_TARGET_mask] = "R8",
                                                 [FRAME_TARGET_layer_depth] = "DEPTH32F",
                                                 [FRAME_TARGET_light] = light,
                                                 [FRAME_TARGET_rays] = open,
                                                 [FRAME_TARGET_denoise] = open,
                                                 [FRAME_TARGET_ao] = open,
                                                 [FRAME_TARGET_tools] = light,
                                                 [FRAME_TARGET_cubes] = "RGBA8",
                                                 [FRAME_TARGET_positions] = "RGBA8",
                                                 [FRAME_TARGET_traced] = "RGBA32UI",
                                                 [FRAME_TARGET_triangle_id] = "R32UI",
                                                 [FRAME_TARGET_edge] = "R32UI",
                                                 [FRAME_TARGET_final] = shown_format(renderer)};
    const char *const own = shadow_methods_target(renderer, target);
    if (own)
        return texture == 0 ? own : NULL;
    if (target == FRAME_TARGET_layer_keys)
        return texture < 2 ? "RG32UI" : NULL;
    if (target == FRAME_TARGET_gbuffer || target == FRAME_TARGET_layer)
        return texture < FRAMEBUFFER_COLORS ? material_set_format(&renderer->set, texture) : NULL;
    return texture == 0 ? one[target] : NULL;
}

/* Returns the resolution divisor of a target per axis. */
static int coarse_of(const Renderer *renderer, FrameTarget target)
{
    if (target == FRAME_TARGET_final)
        return renderer->samples;
    return target == FRAME_TARGET_rays || target == FRAME_TARGET_denoise ? indirect_coarse(renderer)
                                                                         : 1;
}

void frame_forms_find(Renderer *renderer)
{
    for (FrameTarget target = 0; target < FRAME_TARGET_COUNT; target++) {
        FrameForm *form = &renderer->targets.forms[target];
        *form = (FrameForm){.coarse = coarse_of(renderer, target)};
        for (int t = 0;
             t < FRAME_PLAN_TEXTURES && (form->formats[t] = format_of(renderer, target, t)); t++)
            ;
    }
}

int frame_all_bytes(const Renderer *renderer)
{
    return frame_plan_bytes(renderer) + light_far_bytes(renderer) +
           plane_transmittance_bytes(renderer);
}
