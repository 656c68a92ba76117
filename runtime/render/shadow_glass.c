/* Lists of what is transparent, for each texel of the shadow maps: the buffer. glass_store.glsl fills it, shadow.glsl reads it. */
#include "runtime/render/frame.h"

/* The buffer's first words, as glass_store.glsl has them; words of a fragment. */
enum { SIZE, TEXELS, ROOM, COUNT, HEADS, NODE = 4 };

bool shadow_glass_needed(const Render *render)
{
    return render->cache.caster_count && render->set.casts == SET_CASTS_colored;
}

static size_t texels_of(const Render *render)
{
    const size_t size = (size_t)render->scene->shadow_size;
    return size * size * (size_t)render->shadows.views.count;
}

static size_t bytes_of(const Render *render, GLuint room)
{
    return sizeof(GLuint) * (HEADS + texels_of(render) + NODE * (size_t)room);
}

static bool make_buffer(Render *render, GLuint room)
{
    const GlContext *gl = render->gl;
    ShadowGlass *glass = &render->shadows.glass;
    const size_t bytes = bytes_of(render, room), most = transparency_most_bytes(render);
    if (bytes > most)
        return gl_fail(render->gl,
                       "shadows of what is transparent take %lu bytes for %lu fragments, and there may be %lu: smaller "
                       "maps take less, and shadowMaps: { colored: false } none",
                       (unsigned long)bytes, (unsigned long)room, (unsigned long)most);
    const GLuint head[HEADS] = {
        [SIZE] = (GLuint)render->scene->shadow_size, [TEXELS] = (GLuint)texels_of(render), [ROOM] = room};
    if (!glass->buffer)
        gl->GenBuffers(1, &glass->buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, glass->buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_COPY);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof head, head);
    glass->bytes = bytes;
    glass->room = room;
    return gl_check(render->gl, "making room for shadows of what is transparent");
}

bool shadow_glass_make(Render *render) { return !shadow_glass_needed(render) || make_buffer(render, 0); }

void shadow_glass_begin(const Render *render)
{
    const GlContext *gl = render->gl;
    const size_t heads = sizeof(GLuint) * (HEADS - COUNT + texels_of(render));
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_LISTS, render->shadows.glass.buffer);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, COUNT * sizeof(GLuint), (GLsizeiptr)heads,
                           GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
}

void shadow_glass_end(const Render *render)
{
    render->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

bool shadow_glass_check(Render *render, bool *again)
{
    const GlContext *gl = render->gl;
    GLuint count = 0;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, render->shadows.glass.buffer);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, COUNT * sizeof(GLuint), sizeof count, &count);
    *again = count > render->shadows.glass.room;
    return gl_check(render->gl, "counting what is transparent in shadow maps") &&
           (!*again || make_buffer(render, count));
}

void shadow_glass_delete(Render *render)
{
    render->gl->DeleteBuffers(1, &render->shadows.glass.buffer); /* GL ignores the name 0 */
    render->shadows.glass = (ShadowGlass){0};
}
