/* Storage of light clustering between the passes light_cluster and light, by blocks of pixels
 * (light_bound.c): two buffers, and their sizes. */
#include "runtime/light/light_far.h"
#include <limits.h>

enum { GROUPS = LIGHT_FAR_GROUPS, TEXELS = LIGHT_FAR_TEXELS };
_Static_assert((int)LIGHT_FAR_GROUP_NUMBERS <= 4 * (int)TEXELS, "both are kept in one place");

/* bytes of a block */
static const size_t numbers_bytes = GROUPS * TEXELS * 4 * sizeof(float);

LightFarWords light_far_words(const Renderer *renderer)
{
    LightFarWords words = {.bits = light_far_most(renderer) / LIGHT_FAR_WORD};
    words.tops = (words.bits + LIGHT_FAR_WORD - 1) / LIGHT_FAR_WORD;
    words.near = words.tops + words.bits;
    words.marks = words.near + words.bits;
    words.block = LIGHT_FAR_MAP + GROUPS * words.marks;
    return words;
}

static size_t words_bytes(const Renderer *renderer)
{
    return (size_t)light_far_words(renderer).block * sizeof(GLuint);
}

int light_far_blocks(int pixels) { return (pixels + LIGHT_FAR_BLOCK - 1) / LIGHT_FAR_BLOCK; }

static bool is_there(const Renderer *renderer)
{
    return renderer->targets.plan.there >> FRAME_TARGET_far & 1;
}

int light_far_bytes(const Renderer *renderer)
{
    const size_t pixels = LIGHT_FAR_BLOCK * LIGHT_FAR_BLOCK;
    return is_there(renderer) ? (int)((numbers_bytes + words_bytes(renderer) + pixels - 1) / pixels)
                              : 0;
}

int light_far_block(const Renderer *renderer) { return is_there(renderer) ? LIGHT_FAR_BLOCK : 1; }

int light_far_rows(const Renderer *renderer, int width)
{
    GLint storage = 0, texels = 0;
    if (!is_there(renderer))
        return INT_MAX;
    renderer->gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
    renderer->gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    const size_t words = words_bytes(renderer),
                 bytes = words > numbers_bytes ? words : numbers_bytes;
    const size_t count = words / sizeof(GLuint),
                 most = count > GROUPS * TEXELS ? count : GROUPS * TEXELS;
    const size_t by_storage = (size_t)storage / bytes, by_texels = (size_t)texels / most;
    const size_t rows =
        (by_storage < by_texels ? by_storage : by_texels) / (size_t)light_far_blocks(width);
    return rows < INT_MAX / LIGHT_FAR_BLOCK ? (int)rows * LIGHT_FAR_BLOCK : INT_MAX;
}

static size_t block_count(const Renderer *renderer)
{
    return (size_t)light_far_blocks(renderer->size[0]) *
           (size_t)light_far_blocks(renderer->size[1]);
}

void light_far_put(Text *out, const Renderer *renderer)
{
    if (is_there(renderer))
        text_format(
            out, "%-13s  %-24s  %d: %lu bytes for blocks of %d x %d\n", "far", "two buffers",
            light_far_bytes(renderer),
            (unsigned long)(block_count(renderer) * (numbers_bytes + words_bytes(renderer))),
            LIGHT_FAR_BLOCK, LIGHT_FAR_BLOCK);
    else
        text_format(out, "%-13s  %-24s  not allocated\n", "far", "two buffers");
}

/* Makes a buffer with a number of bytes per block. */
static void make_buffer(const Renderer *renderer, size_t bytes, GLuint *buffer)
{
    const GlContext *gl = renderer->gl;
    gl->GenBuffers(1, buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, *buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)(block_count(renderer) * bytes), NULL,
                   GL_DYNAMIC_COPY);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

/* Makes a buffer texture. */
static void make_view(const Renderer *renderer, GLenum format, GLuint buffer, GLuint *view)
{
    const GlContext *gl = renderer->gl;
    gl->GenTextures(1, view);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, *view);
    gl->TexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    gl->BindTexture(GL_TEXTURE_BUFFER, 0);
}

bool light_far_make(Renderer *renderer)
{
    make_buffer(renderer, numbers_bytes, &renderer->light->far.numbers);
    make_buffer(renderer, words_bytes(renderer), &renderer->light->far.words);
    make_view(renderer, GL_RGBA32F, renderer->light->far.numbers, &renderer->light->far.texels);
    make_view(renderer, GL_R32UI, renderer->light->far.words, &renderer->light->far.bits);
    return gl_check(renderer->gl, "making room for many lights");
}

void light_far_delete(Renderer *renderer)
{
    frame_retire(renderer, &renderer->light->far.groups);
    frame_retire(renderer, &renderer->light->far.near);
    frame_retire(renderer, &renderer->light->far.gather);
    renderer->gl->DeleteTextures(1, &renderer->light->far.texels); /* GL ignores the name 0 */
    renderer->gl->DeleteTextures(1, &renderer->light->far.bits);
    renderer->gl->DeleteBuffers(1, &renderer->light->far.numbers);
    renderer->gl->DeleteBuffers(1, &renderer->light->far.words);
    renderer->light->far = (FrameFar){0};
}
