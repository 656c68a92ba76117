/* Target formats of a program or a layout; samplers for readers of the targets. */
#include "runtime/gpu_material/targets.h"
#include <stdio.h>

bool targets_make(GlContext *gl, const MatcProgram *program, const FramebufferSpec *spec,
                  Framebuffer *made)
{
    const char *names[FRAMEBUFFER_COLORS];
    FramebufferSpec whole = *spec;
    whole.color_count = matc_target_count(program);
    for (int i = 0; i < whole.color_count && i < FRAMEBUFFER_COLORS; i++)
        names[i] = matc_target_format(program, i);
    return framebuffer_make_named(gl, &whole, names, made);
}

bool targets_make_layout(GlContext *gl, const LayoutRow *layout, const FramebufferSpec *spec,
                         Framebuffer *made)
{
    const char *names[FRAMEBUFFER_COLORS];
    FramebufferSpec whole = *spec;
    whole.color_count = layout_targets(layout);
    for (int i = 0; i < whole.color_count && i < FRAMEBUFFER_COLORS; i++)
        names[i] = format_table[layout->formats[i]].name;
    return framebuffer_make_named(gl, &whole, names, made);
}

void targets_read(const Framebuffer *targets, Material *reader)
{
    char name[32];
    for (int i = 0; i < targets->spec.color_count; i++) {
        snprintf(name, sizeof name, "matc_gbuffer%d", i);
        material_set_number(reader, name, (float)i);
    }
    material_use(reader);
    for (int i = 0; i < targets->spec.color_count; i++)
        texture_bind(store_context(reader->store), targets->colors[i], i);
}
