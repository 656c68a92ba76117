/* Lists of transparent fragments for each texel of the shadow maps, in a buffer: glass_store.glsl
 * fills it, shadow.glsl reads it. Lists that take more memory than there may be are drawn in parts.
 * A part is a rectangle of texels of all maps, one above the other, whose lists find room. Light is
 * a sum over the texels that a point reads, so it is exact to sum over those of one part after the
 * other: each pass that lights runs once for each part (lighting_run), and the lists are drawn
 * again before it.
 *
 * Worked example: two maps of 4 x 4 texels with three fragments each, 8 + 32 + 96 words. If there
 * may be 80: rows 0 to 3 take 8 + 16 + 48, so they are one part, and rows 4 to 7 the other. If
 * there may be 20: a row takes 8 + 4 + 12 and is too much, two of its texels take 16. */
#include "gen/shadow_glass_layout.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/shadow/shadow.h"
#include <stdlib.h>

enum { NODE = 4 /* words of a fragment */ };

bool shadow_glass_needed(const Render *render)
{
    return render->cache.caster_count && render->set.uses.casts == SET_CASTS_colored;
}

ShadowPart shadow_glass_whole(const Render *render)
{
    const GLuint size = (GLuint)render->scene->shadow_size;
    return (ShadowPart){.columns = size, .rows = size * (GLuint)render->shadows->views.count};
}

static size_t texels_of(const ShadowPart *part) { return (size_t)part->columns * part->rows; }

size_t shadow_glass_bytes(const ShadowPart *part)
{
    return sizeof(GLuint) *
           (SHADOW_GLASS_STATE_WORDS + texels_of(part) + NODE * (size_t)part->fragments);
}

bool shadow_glass_make(Render *render, size_t bytes)
{
    const GlContext *gl = render->gl;
    ShadowGlass *glass = &render->shadows->glass;
    glass->bytes = bytes > sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS
                       ? bytes
                       : sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS;
    if (!glass->buffer)
        gl->GenBuffers(1, &glass->buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, glass->buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)glass->bytes, NULL, GL_DYNAMIC_COPY);
    return gl_check(render->gl, "making room for shadows of what is transparent");
}

/* Four words. Nothing but a clear, so that a frame may do it. */
static void write_words(const GlContext *gl, GLuint first, const GLuint words[4])
{
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_RGBA32UI, (GLintptr)(first * sizeof *words),
                           4 * sizeof *words, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words);
}

void shadow_glass_begin(const Render *render, const ShadowPart *part)
{
    const GlContext *gl = render->gl;
    const ShadowGlass *glass = &render->shadows->glass;
    const GLuint size = (GLuint)render->scene->shadow_size;
    const size_t start = sizeof(GLuint) * SHADOW_GLASS_STATE_WORDS,
                 all = sizeof(GLuint) * texels_of(part);
    const bool counts = glass->bytes < start + all; /* it holds no list yet */
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_LISTS, glass->buffer);
    write_words(gl, SHADOW_GLASS_COLUMN,
                (GLuint[]){part->column, part->row, part->columns, part->rows});
    write_words(gl, SHADOW_GLASS_HEADS,
                (GLuint[]){(GLuint)texels_of(part), counts ? 0 : part->fragments, size, 0});
    if (!counts)
        gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, (GLintptr)start, (GLsizeiptr)all,
                               GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
}

void shadow_glass_end(const Render *render)
{
    render->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

bool shadow_glass_count(Render *render, GLuint *count)
{
    const GlContext *gl = render->gl;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, render->shadows->glass.buffer);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_COUNT * sizeof(GLuint),
                         sizeof *count, count);
    return gl_check(render->gl, "counting what is transparent in shadow maps");
}

void shadow_glass_delete(Render *render)
{
    render->gl->DeleteBuffers(1, &render->shadows->glass.buffer); /* GL ignores the name 0 */
    free(render->shadows->glass.parts);
    render->shadows->glass = (ShadowGlass){0};
}

/* -- lists of a part */

static bool count(Render *render, ShadowPart *part)
{
    part->fragments = 0;
    shadow_draw_lists(render, part);
    return shadow_glass_count(render, &part->fragments);
}

/* -- in one piece */

static bool fail_room(Render *render, const ShadowPart *part)
{
    return gl_fail(render->gl,
                   "shadows of what is transparent take %lu bytes for %lu fragments, and there may "
                   "be %lu: smaller "
                   "maps take less, and shadowMaps: { colored: false } none",
                   (unsigned long)shadow_glass_bytes(part), (unsigned long)part->fragments,
                   (unsigned long)transparency_most_bytes(render));
}

/* Room for all that there is, if there may be so much. */
static bool make_whole(Render *render, const ShadowPart *whole)
{
    ShadowGlass *glass = &render->shadows->glass;
    glass->full = shadow_glass_bytes(whole) > transparency_most_bytes(render);
    if (glass->full)
        return fail_room(render, whole);
    *glass->parts = *whole;
    return shadow_glass_make(render, shadow_glass_bytes(whole));
}

/* Draws until all fragments find room. */
static bool count_whole(Render *render)
{
    ShadowPart part = *render->shadows->glass.parts;
    shadow_draw_lists(render, &part);
    if (!shadow_glass_count(render, &part.fragments))
        return false;
    if (part.fragments <= render->shadows->glass.parts->fragments)
        return true;
    return make_whole(render, &part) && count_whole(render);
}

/* -- in parts */

static bool add(Render *render, const ShadowPart *part)
{
    ShadowGlass *glass = &render->shadows->glass;
    ShadowPart *parts = realloc(glass->parts, ((size_t)glass->part_count + 1) * sizeof *parts);
    if (!parts)
        return gl_fail(render->gl, "out of memory");
    glass->parts = parts;
    parts[glass->part_count++] = *part;
    return true;
}

static GLuint shorter(GLuint length, double share)
{
    const GLuint wanted = (GLuint)(length * share);
    return wanted < 1 ? 1 : wanted < length ? wanted : length - 1;
}

/* Fewer rows of it, or of a single row fewer columns, until they find room. */
static bool fit(Render *render, ShadowPart *part)
{
    const size_t most = transparency_most_bytes(render);
    while (count(render, part)) {
        const size_t bytes = shadow_glass_bytes(part);
        if (bytes <= most)
            return true;
        if (part->rows == 1 && part->columns == 1)
            return fail_room(render, part);
        GLuint *length = part->rows > 1 ? &part->rows : &part->columns;
        *length = shorter(*length, (double)most / (double)bytes);
    }
    return false;
}

static bool divide(Render *render)
{
    ShadowGlass *glass = &render->shadows->glass;
    const ShadowPart whole = shadow_glass_whole(render);
    GLuint row = 0, column = 0, rows = whole.rows;
    size_t bytes = 0;
    glass->part_count = 0;
    if (!shadow_glass_make(render, 0))
        return false;
    while (row < whole.rows) {
        ShadowPart part = {column, row, whole.columns - column, column ? 1 : rows, 0};
        part.rows = part.rows < whole.rows - row ? part.rows : whole.rows - row;
        if (!fit(render, &part) || !add(render, &part))
            return false;
        bytes = shadow_glass_bytes(&part) > bytes ? shadow_glass_bytes(&part) : bytes;
        rows = 2 * part.rows; /* the next one may have more */
        column = (column + part.columns) % whole.columns;
        row += column ? 0 : part.rows;
    }
    return shadow_glass_make(render, bytes);
}

/* -- */

bool shadow_parts_make(Render *render)
{
    const ShadowPart whole = shadow_glass_whole(render);
    return !shadow_glass_needed(render) ||
           (add(render, &whole) && (render->parted || make_whole(render, &whole)));
}

bool shadow_parts_count(Render *render)
{
    return render->parted ? divide(render) : count_whole(render);
}

bool shadow_parts_fall_back(const Render *render)
{
    return render->shadows->glass.full && !render->parted;
}

int shadow_parts_number(const Render *render)
{
    return render->parted ? render->shadows->glass.part_count : 1;
}

void shadow_parts_load(Render *render, int part)
{
    if (render->parted)
        shadow_draw_lists(render, &render->shadows->glass.parts[part]);
}
