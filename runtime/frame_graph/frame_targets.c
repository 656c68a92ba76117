/* Names, textures and framebuffers of a frame's targets, and the input of the GPU scene. */
#include "runtime/frame_graph/frame.h"
#include <string.h>

static const char *const names[FRAME_TARGET_COUNT] = {
    "depth",       "gbuffer", "traced", "shadow",  "voxels",   "cubes",    "mesh",    "radiance",
    "triangle_id", "lists",   "far",    "light",   "rays",     "temporal", "denoise", "ao",
    "edge",        "mask",    "layer",  "layer.z", "layer.id", "tools",    "final"};

const char *frame_target_name(FrameTarget target) { return names[target]; }

const char *frame_format(const Renderer *renderer, FrameTarget target, int texture)
{
    return renderer->targets.forms[target].formats[texture];
}

static const struct {
    const char *format;
    int bytes;
} sizes[] = {{"DEPTH32F", 4}, {"DEPTH32F_STENCIL8", 8}, {"R8", 1},       {"RGBA8", 4},
             {"RGBA16", 8},   {"RGBA16F", 8},           {"RGBA32F", 16}, {"R32UI", 4},
             {"RG32UI", 8},   {"RGBA32UI", 16},         {"RGBA16UI", 8}};
enum { DEPTH_SIZES = 2, SIZE_COUNT = sizeof sizes / sizeof *sizes };

/* Returns the row of `sizes` for a format. */
static int size_of(const char *format)
{
    int i = 0;
    while (strcmp(sizes[i].format, format) != 0)
        i++;
    return i;
}

/* Returns the class of formats that can share memory: formats of equal size if the driver has
 * texture views, otherwise equal formats. Each depth format is a class of its own. */
static int class_of(const Renderer *renderer, const char *format)
{
    const int size = size_of(format);
    int first = DEPTH_SIZES;
    if (size < DEPTH_SIZES || !framebuffer_has_views(renderer->gl))
        return size;
    while (sizes[first].bytes != sizes[size].bytes)
        first++;
    return first;
}

/* Targets of lower resolution, and the final picture, share memory only among themselves. */
FramePlanTarget frame_plan_target(const Renderer *renderer, FrameTarget target)
{
    const int apart = renderer->targets.forms[target].coarse == 1 ? 0
                      : target == FRAME_TARGET_final              ? SIZE_COUNT
                                                                  : 2 * SIZE_COUNT;
    FramePlanTarget made = {0};
    const char *format;
    while (made.count < FRAME_PLAN_TEXTURES &&
           (format = frame_format(renderer, target, made.count)))
        made.classes[made.count++] = class_of(renderer, format) + apart;
    return made;
}

int frame_bytes(const Renderer *renderer, FrameTarget target)
{
    int bytes = 0;
    for (int t = 0; frame_format(renderer, target, t); t++)
        bytes += sizes[size_of(frame_format(renderer, target, t))].bytes;
    return bytes;
}

int frame_edge(const Renderer *renderer, FrameTarget target, int axis)
{
    const int coarse = renderer->targets.forms[target].coarse;
    return (renderer->size[axis] + coarse - 1) / coarse;
}

/* Reports whether a texture of an earlier target lies in the piece. */
static bool is_taken(const FramePlan *plan, int target, int piece)
{
    for (int k = 0; k < target; k++)
        for (int t = 0; t < FRAME_PLAN_TEXTURES; t++)
            if (plan->memory[k][t] == piece)
                return true;
    return false;
}

int frame_shared_bytes(const Renderer *renderer, FrameTarget target)
{
    const FramePlan *plan = &renderer->targets.plan;
    int bytes = 0;
    for (int t = 0; t < FRAME_PLAN_TEXTURES && plan->memory[target][t] >= 0; t++)
        if (is_taken(plan, (int)target, plan->memory[target][t]))
            bytes += sizes[size_of(frame_format(renderer, target, t))].bytes;
    return bytes;
}

/* Counts a low-resolution target per pixel of the frame: its bytes divided by the pixels that
 * each texel covers. */
int frame_plan_bytes(const Renderer *renderer)
{
    int bytes = 0;
    for (int i = 0; i < FRAME_TARGET_COUNT; i++)
        if (renderer->targets.plan.memory[i][0] >= 0) {
            const int added = frame_bytes(renderer, (FrameTarget)i) -
                              frame_shared_bytes(renderer, (FrameTarget)i);
            const int coarse = renderer->targets.forms[i].coarse, pixels = coarse * coarse;
            bytes += (added + pixels - 1) / pixels;
        }
    return bytes;
}

GLuint frame_texture(const Renderer *renderer, FrameTarget target, int texture)
{
    return renderer->targets.textures[target][texture];
}

/* Color target of each framebuffer, and its depth target; -1: none. */
static const struct {
    FrameTarget color;
    int depth;
} draws[FRAME_DRAW_COUNT] = {
    [FRAME_DRAW_surface] = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth},
    [FRAME_DRAW_triangle_id] = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth},
    [FRAME_DRAW_traced] = {FRAME_TARGET_traced, FRAME_TARGET_depth},
    [FRAME_DRAW_sky] = {FRAME_TARGET_light, FRAME_TARGET_depth},
    [FRAME_DRAW_cubes] = {FRAME_TARGET_cubes, -1},
    [FRAME_DRAW_positions] = {FRAME_TARGET_positions, FRAME_TARGET_layer_depth},
    [FRAME_DRAW_light] = {FRAME_TARGET_light, -1},
    [FRAME_DRAW_rays] = {FRAME_TARGET_rays, -1},
    [FRAME_DRAW_denoise] = {FRAME_TARGET_denoise, -1},
    [FRAME_DRAW_ao] = {FRAME_TARGET_ao, -1},
    [FRAME_DRAW_edge] = {FRAME_TARGET_edge, -1},
    [FRAME_DRAW_mask] = {FRAME_TARGET_mask, FRAME_TARGET_depth},
    [FRAME_DRAW_final] = {FRAME_TARGET_final, -1}};

/* Appends a target's textures to the color attachments. */
static void add_colors(const Renderer *renderer, FrameTarget target, FramebufferSpec *spec,
                       FramebufferTextures *textures)
{
    const char *format;
    for (int i = 0;
         spec->color_count < FRAMEBUFFER_COLORS && (format = frame_format(renderer, target, i));
         i++) {
        textures->formats[spec->color_count] = format;
        textures->colors[spec->color_count++] = frame_texture(renderer, target, i);
    }
}

bool frame_make_draw(Renderer *renderer, FrameDraw draw)
{
    const FrameTarget color = draws[draw].color;
    const int depth = draws[draw].depth;
    const bool deep = depth >= 0;
    const unsigned there = renderer->targets.plan.there;
    FramebufferTextures textures = {.depth =
                                        deep ? frame_texture(renderer, (FrameTarget)depth, 0) : 0,
                                    .stencil = draw == FRAME_DRAW_mask};
    FramebufferSpec spec = {frame_edge(renderer, color, 0), frame_edge(renderer, color, 1), 0, 0,
                            deep};
    if (!(there >> color & 1) || (deep && !(there >> depth & 1)) ||
        (draw == FRAME_DRAW_triangle_id && !(there >> FRAME_TARGET_triangle_id & 1)))
        return true; /* no pass draws into the target */
    add_colors(renderer, color, &spec, &textures);
    if (draw == FRAME_DRAW_triangle_id)
        add_colors(renderer, FRAME_TARGET_triangle_id, &spec, &textures);
    return framebuffer_make_around(renderer->gl, &spec, &textures, &renderer->targets.draws[draw]);
}

void frame_use(const Renderer *renderer, const Framebuffer *framebuffer)
{
    framebuffer_use(renderer->gl, framebuffer);
    renderer->gl->Viewport(-renderer->at[0], -renderer->at[1], renderer->whole[0],
                           renderer->whole[1]);
}

static bool casts(const Renderer *renderer)
{
    return renderer->scene && !renderer->options.no_shadows && scene_casts(renderer->scene);
}

/* Reports whether only the camera reads the scene: indirect light and some shadows also need
 * objects outside the view. */
static bool is_alone(const Renderer *renderer)
{
    return renderer->scene && !scene_indirect_is(renderer->scene) &&
           !(casts(renderer) && renderer->beside);
}

GpuSceneSource frame_source(const Renderer *renderer)
{
    return (GpuSceneSource){renderer->scene,
                            &renderer->set,
                            &renderer->space,
                            renderer->options.unculled ? NULL : &renderer->volume,
                            &renderer->volume,
                            renderer->whole,
                            renderer->at,
                            &renderer->compile,
                            renderer->triangles,
                            is_alone(renderer),
                            casts(renderer),
                            renderer->transparency,
                            renderer->triangle_id_text,
                            renderer->look && renderer->look->scene == FRAME_LOOK_lines};
}
