/* Lists of transparent fragments, for each texel of the shadow maps: the buffer.
 * glass_store.glsl fills it, shadow.glsl reads it. */
#include "gen/shadow_glass_layout.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/shadow.h"
#include <stdlib.h>

enum { NODE = 4 /* words of a list node */ };

bool shadow_glass_needed(const Renderer *renderer)
{
    return renderer->gpu_scene.caster_count && renderer->set.uses.casts == SET_CASTS_colored;
}

ShadowPart shadow_glass_whole(const Renderer *renderer)
{
    const GLuint size = (GLuint)renderer->scene->shadow_size;
    return (ShadowPart){.columns = size, .rows = size * (GLuint)renderer->shadows->views.count};
}

static size_t texels_of(const ShadowPart *part) { return (size_t)part->columns * part->rows; }

size_t shadow_glass_bytes(const ShadowPart *part)
{
    return sizeof(GLuint) *
           (SHADOW_GLASS_STATE_WORDS + texels_of(part) + NODE * (size_t)part->fragments);
}

bool shadow_glass_make(Renderer *renderer, size_t bytes)
{
    const GlContext *gl = renderer->gl;
    ShadowGlass *glass = &renderer->shadows->glass;
    glass->bytes = bytes > sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS
                       ? bytes
                       : sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS;
    if (!glass->buffer)
        gl->GenBuffers(1, &glass->buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, glass->buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)glass->bytes, NULL, GL_DYNAMIC_COPY);
    return gl_check(renderer->gl, "making room for shadows of what is transparent");
}

/* Writes four words by a clear, which a frame may do without a transfer. */
static void write_words(const GlContext *gl, GLuint first, const GLuint words[4])
{
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_RGBA32UI, (GLintptr)(first * sizeof *words),
                           4 * sizeof *words, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words);
}

void shadow_glass_begin(const Renderer *renderer, const ShadowPart *part)
{
    const GlContext *gl = renderer->gl;
    const ShadowGlass *glass = &renderer->shadows->glass;
    const GLuint size = (GLuint)renderer->scene->shadow_size;
    const size_t start = sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS,
                 all = sizeof(GLuint) * texels_of(part);
    /* the lists have no capacity yet: the draw only counts fragments */
    const bool counts = glass->bytes < start + all;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_LISTS, glass->buffer);
    write_words(gl, SHADOW_GLASS_COLUMN,
                (GLuint[]){part->column, part->row, part->columns, part->rows});
    write_words(gl, SHADOW_GLASS_HEADS,
                (GLuint[]){(GLuint)texels_of(part), counts ? 0 : part->fragments, size, 0});
    if (!counts)
        gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, (GLintptr)start, (GLsizeiptr)all,
                               GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
}

void shadow_glass_end(const Renderer *renderer)
{
    renderer->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

bool shadow_glass_count(Renderer *renderer, GLuint *count)
{
    const GlContext *gl = renderer->gl;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, renderer->shadows->glass.buffer);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_COUNT * sizeof(GLuint),
                         sizeof *count, count);
    return gl_check(renderer->gl, "counting what is transparent in shadow maps");
}

void shadow_glass_delete(Renderer *renderer)
{
    renderer->gl->DeleteBuffers(1, &renderer->shadows->glass.buffer); /* GL ignores the name 0 */
    free(renderer->shadows->glass.parts);
    renderer->shadows->glass = (ShadowGlass){0};
}
