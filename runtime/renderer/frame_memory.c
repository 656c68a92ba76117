/* Memory of a frame's targets: textures by the plan's pieces of memory, and the size of a tile. */
#include "runtime/renderer/frame_memory.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/light/light_far.h"
#include "runtime/renderer/passes.h"
#include <string.h>

/* Returns a target's texture: the piece of memory itself, made on first use, or, for another
 * format, a texture view of it. */
static bool make_texture(Renderer *renderer, FrameMemory *memory, const TargetSpec *spec,
                         GLuint *made)
{
    if (!memory->texture)
        *memory = (FrameMemory){framebuffer_target(renderer->gl, spec), spec->format};
    const bool as_it_is = !memory->texture || !strcmp(memory->format, spec->format);
    *made =
        as_it_is ? memory->texture : framebuffer_view(renderer->gl, memory->texture, spec->format);
    return *made != 0;
}

bool frame_memory_make(Renderer *renderer)
{
    bool fine = true;
    for (FrameTarget target = 0; target < FRAME_TARGET_COUNT; target++)
        for (int i = 0;
             fine && i < FRAMEBUFFER_COLORS && renderer->targets.plan.memory[target][i] >= 0; i++) {
            const TargetSpec spec = {frame_edge(renderer, target, 0),
                                     frame_edge(renderer, target, 1),
                                     frame_format(renderer, target, i)};
            fine = make_texture(renderer,
                                &renderer->targets.memory[renderer->targets.plan.memory[target][i]],
                                &spec, &renderer->targets.textures[target][i]);
        }
    return fine;
}

void frame_memory_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    for (int target = 0; target < FRAME_TARGET_COUNT; target++)
        for (int i = 0; i < FRAMEBUFFER_COLORS; i++) {
            const int piece = renderer->targets.plan.memory[target][i];
            if (renderer->targets.textures[target][i] &&
                renderer->targets.textures[target][i] != renderer->targets.memory[piece].texture)
                gl->DeleteTextures(1, &renderer->targets.textures[target][i]);
        }
    for (int piece = 0; piece < FRAME_PLAN_PIECES; piece++)
        gl->DeleteTextures(1, &renderer->targets.memory[piece].texture); /* GL ignores the name 0 */
    memset(renderer->targets.textures, 0, sizeof renderer->targets.textures);
    memset(renderer->targets.memory, 0, sizeof renderer->targets.memory);
}

static int least(int a, int b) { return a < b ? a : b; }

static int round_up(int a, int step) { return (a + step - 1) / step * step; }

/* Returns the size of indivisible blocks: a multiple of 2 x 2 pixels, of a pixel of the ray
 * pass, and of the samples of a pixel. */
static int step_of(const Renderer *renderer)
{
    const int block = indirect_coarse(renderer) > 2 ? indirect_coarse(renderer) : 2;
    int step = renderer->samples;
    while (step % block)
        step += renderer->samples;
    return step;
}

/* Reports whether some pass reads so much of the picture that it cannot be tiled. */
static bool is_whole(const Renderer *renderer)
{
    const unsigned there = renderer->targets.plan.there;
    return there & 1u << FRAME_TARGET_positions ||
           (there & 1u << FRAME_TARGET_ao && indirect_margin(renderer) < 0);
}

/* Returns the guard band of a tile: antialiasing reads adjacent pixels, indirect light pixels
 * farther away. */
static int margin_of(const Renderer *renderer)
{
    const unsigned there = renderer->targets.plan.there;
    const int step = step_of(renderer), beside = there & 1u << FRAME_TARGET_edge ? step : 0;
    const int around = there & 1u << FRAME_TARGET_ao && !is_whole(renderer)
                           ? indirect_margin(renderer) + beside
                           : 0;
    return around > beside ? round_up(around, step) : beside;
}

/* Returns the number of rows that fit into memory; blocks of light clustering are not split
 * either. */
static size_t rows_in_memory(const Renderer *renderer, int width)
{
    const size_t memory = renderer->options.memory ? renderer->options.memory : RENDERER_MEMORY;
    const size_t block = (size_t)light_far_block(renderer), step = (size_t)step_of(renderer);
    const size_t across = ((size_t)width + block - 1) / block * block;
    size_t down = step; /* least common multiple of both steps */
    while (down % block)
        down += step;
    return memory / (across * (size_t)frame_all_bytes(renderer)) / down * down;
}

/* Returns the width of a tile in samples: all of the picture, or, if the driver's limit is
 * lower, an even share, so that no tile is almost empty. */
static int find_width(const Renderer *renderer, int margin)
{
    const int whole = renderer->whole[0], step = step_of(renderer);
    const int most = renderer->gl->max_texture_size / step * step - 2 * margin;
    const int columns = (whole + most - 1) / most;
    return columns > 1 ? round_up((whole + columns - 1) / columns, step) : whole;
}

/* Computes the size of a tile in samples. The number of rows is the one that memory allows at
 * the picture's full width, since the caller writes the picture by rows of tiles. */
static void find_tile(const Renderer *renderer, int margin, int tile[2])
{
    const RendererOptions *options = &renderer->options;
    const int step = step_of(renderer),
              most = renderer->gl->max_texture_size / step * step - 2 * margin;
    const int width = find_width(renderer, margin), beside = renderer->whole[0] + 2 * margin;
    const int height = least(least(renderer->whole[1], most),
                             light_far_rows(renderer, width + 2 * margin) - 2 * margin);
    const bool whole = is_whole(renderer);
    const size_t rows =
        whole ? (size_t)height + 2 * (size_t)margin : rows_in_memory(renderer, beside);
    const int wanted[2] = {whole ? 0 : options->tile[0] * renderer->samples,
                           whole ? 0 : options->tile[1] * renderer->samples};
    const int spare = rows < (size_t)height ? (int)rows - 2 * margin : height;
    const int fewest = RENDERER_TILE_MIN * renderer->samples;
    tile[0] = least(width, wanted[0] ? wanted[0] : width);
    tile[1] = least(height, wanted[1] ? wanted[1] : spare < fewest ? fewest : spare);
    for (int i = 0; i < 2; i++) {
        const int together = indirect_coarse(renderer) > 1 && tile[i] < renderer->whole[i]
                                 ? step
                                 : renderer->samples;
        tile[i] = tile[i] > together ? tile[i] - tile[i] % together : together;
    }
}

static bool is_tiled(const Renderer *renderer, const int tile[2])
{
    return tile[0] < renderer->whole[0] || tile[1] < renderer->whole[1];
}

bool frame_memory_fits(const Renderer *renderer)
{
    const int margin = renderer->margin,
              tile[2] = {renderer->size[0] - 2 * margin, renderer->size[1] - 2 * margin};
    /* a picture that is drawn at once only needs the band of antialiasing */
    const int needed = margin_of(renderer);
    return !is_tiled(renderer, tile) || (is_whole(renderer) ? margin <= needed : needed <= margin);
}

/* A tile is drawn with a guard band, since antialiasing reads adjacent pixels, and indirect
 * light pixels farther away. */
void frame_memory_size(Renderer *renderer)
{
    const int margin = margin_of(renderer);
    int tile[2];
    find_tile(renderer, margin, tile);
    renderer->margin = is_tiled(renderer, tile) ? margin : 0;
    for (int i = 0; i < 2; i++) {
        renderer->size[i] = tile[i] + 2 * renderer->margin;
        renderer->at[i] = -renderer->margin;
    }
    view_space_place(&renderer->space, renderer->whole, renderer->at);
}
