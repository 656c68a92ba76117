/* Names, formats and textures of a frame's targets; drawing to them; and what the cache is made of. */
#include "runtime/render/frame.h"
#include <string.h>

static const char *const names[FRAME_TARGET_COUNT] = {"depth", "gbuffer", "shadow",  "lists",    "far",   "light",
                                                      "edge",  "layer",   "layer.z", "layer.id", "tools", "shown"};

const char *frame_target_name(FrameTarget target) { return names[target]; }

/* Light is kept as exactly as what it is made of: where a normal is off by less than this, a half float would be the worse. So it would where many
 * parts add up. */
static bool is_exact(const Render *render)
{
    const double degrees = 0.005;
    if (render->options.deep || render->parted)
        return true;
    const LayoutRow *layout = set_layout(&render->set, &render->compile);
    for (int i = 0; i < layout->cases[0].field_count; i++) {
        const FieldRow *field = &layout->cases[0].fields[i];
        if (field->source[0].slot == SLOT_normal)
            return field_error(field) < degrees;
    }
    return false;
}

static const char *shown_format(const Render *render)
{
    const bool deep = render->options.deep;
    return render->options.linear ? deep ? "RGBA32F" : "RGBA16F" : deep ? "RGBA16" : "RGBA8";
}

const char *frame_format(const Render *render, FrameTarget target, int texture)
{
    const char *const light = is_exact(render) ? "RGBA32F" : "RGBA16F";
    const char *const one[FRAME_TARGET_COUNT] = {
        [FRAME_TARGET_depth] = "DEPTH32F", [FRAME_TARGET_layer_depth] = "DEPTH32F",
        [FRAME_TARGET_light] = light,      [FRAME_TARGET_tools] = light,
        [FRAME_TARGET_edge] = "R32UI",     [FRAME_TARGET_shown] = shown_format(render)};
    if (target == FRAME_TARGET_layer_keys)
        return texture < 2 ? "RG32UI" : NULL;
    if (target == FRAME_TARGET_gbuffer || target == FRAME_TARGET_layer)
        return texture < FRAMEBUFFER_COLORS ? set_format(&render->set, texture) : NULL;
    return texture == 0 ? one[target] : NULL;
}

static const struct {
    const char *format;
    int bytes;
} sizes[] = {{"DEPTH32F", 4}, {"RGBA8", 4},  {"RGBA16", 8},    {"RGBA16F", 8}, {"RGBA32F", 16},
             {"R32UI", 4},    {"RG32UI", 8}, {"RGBA32UI", 16}, {"RGBA16UI", 8}};

int frame_bytes(const Render *render, FrameTarget target)
{
    int bytes = 0;
    for (int t = 0; frame_format(render, target, t); t++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
            bytes += strcmp(sizes[i].format, frame_format(render, target, t)) ? 0 : sizes[i].bytes;
    return bytes;
}

int frame_edge(const Render *render, FrameTarget target, int axis)
{
    return target == FRAME_TARGET_shown ? render->size[axis] / render->samples : render->size[axis];
}

bool frame_shares(const Render *render, FrameTarget target)
{
    const int *memory = render->plan.memory;
    bool shared = false;
    for (int k = 0; k < (int)target; k++)
        shared |= memory[target] >= 0 && memory[k] == memory[target];
    return shared;
}

/* The picture's are spread over the samples of a pixel. */
int frame_all_bytes(const Render *render)
{
    const int samples = render->samples * render->samples;
    int bytes = light_far_bytes(render);
    for (int i = 0; i < FRAME_TARGET_COUNT; i++)
        if (render->plan.memory[i] >= 0 && !frame_shares(render, (FrameTarget)i))
            bytes += i == FRAME_TARGET_shown ? (frame_bytes(render, (FrameTarget)i) + samples - 1) / samples
                                             : frame_bytes(render, (FrameTarget)i);
    return bytes;
}

GLuint frame_texture(const Render *render, FrameTarget target, int texture)
{
    const int piece = render->plan.memory[target];
    return piece < 0 ? 0 : render->memory[piece].textures[texture];
}

void frame_use(const Render *render, const Framebuffer *framebuffer)
{
    framebuffer_use(render->gl, framebuffer);
    render->gl->Viewport(-render->at[0], -render->at[1], render->whole[0], render->whole[1]);
}

CacheSource frame_source(const Render *render)
{
    return (CacheSource){render->scene,  &render->set,
                         &render->space, render->options.unculled ? NULL : &render->volume,
                         render->whole,  render->transparency};
}
