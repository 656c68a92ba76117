/* Makes uniforms, textures and buffers of a compiled program. */
#include "runtime/gpu_material/material.h"
#include "runtime/gpu_material/material_feed.h"
#include <stdlib.h>
#include <string.h>

struct MaterialBlock {
    GLuint buffer;
    unsigned char *bytes;
    bool changed; /* the block has changed since the last upload */
};

static GlContext *context(const Material *m) { return store_context(m->store); }

static const GlUniforms *uniforms_of(const Material *m) { return &m->program->uniforms; }

static bool make_capacity(Material *m)
{
    const GlUniforms *all = uniforms_of(m);
    m->values = calloc((size_t)all->count + 1, sizeof *m->values);
    m->blocks = calloc((size_t)all->block_count + 1, sizeof *m->blocks);
    if (!m->values || !m->blocks)
        return gl_fail(context(m), "out of memory");
    for (int i = 0; i < all->block_count; i++) {
        m->blocks[i].changed = true;
        m->blocks[i].bytes = calloc((size_t)all->block_sizes[i] + 1, 1);
        if (!m->blocks[i].bytes)
            return gl_fail(context(m), "out of memory");
    }
    return true;
}

bool material_set(Material *m, const MaterialValue *value)
{
    int found = uniforms_find(uniforms_of(m), value->name);
    const GlUniform *uniform = found < 0 ? NULL : &uniforms_of(m)->at[found];
    if (!uniform || uniform->components != value->components)
        return false;
    if (uniform->block >= 0) {
        uniform_write(uniform, value->values, m->blocks[uniform->block].bytes);
        m->blocks[uniform->block].changed = true;
        return true;
    }
    memcpy(m->values[found], value->values, (size_t)value->components * sizeof *value->values);
    return true;
}

bool material_set_number(Material *m, const char *name, float number)
{
    return material_set(m, &(MaterialValue){name, 1, &number});
}

bool material_has(const Material *m, const char *name)
{
    return uniforms_find(uniforms_of(m), name) >= 0;
}

static int most_textures(const Material *m)
{
    const int units = context(m)->max_texture_units;
    return units < MATERIAL_TEXTURES ? units : MATERIAL_TEXTURES;
}

bool material_set_texture(Material *m, const char *sampler, const TextureSpec *spec)
{
    GlContext *gl = context(m);
    const int unit = m->texture_count;
    if (!material_set_number(m, sampler, (float)unit))
        return true;
    if (unit >= most_textures(m))
        return gl_fail(gl, "more textures than the driver's %d", most_textures(m));
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit); /* making a texture binds it to this unit */
    m->textures[unit] = store_texture(m->store, spec);
    m->texture_count += m->textures[unit] != NULL;
    return m->textures[unit] != NULL;
}

static bool set_textures(Material *m, MatcProgram *program)
{
    for (int i = 0; i < matc_texture_count(program); i++) {
        const MatcTexture *t = matc_texture(program, i);
        const TextureSpec spec = {.width = t->width,
                                  .height = t->height,
                                  .components = t->components,
                                  .bytes = t->bytes,
                                  .floats = t->floats,
                                  .wrap = texture_wrap(t->wrap),
                                  .mipmaps = t->mipmaps,
                                  .anisotropy = t->anisotropy,
                                  .words = t->words,
                                  .format = texture_format(t->format)};
        if (!material_set_texture(m, t->name, &spec))
            return false;
    }
    return true;
}

static void set_uniforms(Material *m, const MatcProgram *program)
{
    for (int i = 0; i < matc_uniform_count(program); i++) {
        const MatcUniform *uniform = matc_uniform(program, i);
        float numbers[4] = {0};
        for (int component = 0; component < uniform->components; component++)
            numbers[component] = (float)uniform->initial[component];
        material_set(m, &(MaterialValue){uniform->name, uniform->components, numbers});
    }
}

/* Sets constants as plain uniforms: GLSL 1.10 has no blocks, and its constants are all floats. */
static void set_plain_numbers(Material *m, const MatcProgram *program, unsigned char *bytes)
{
    for (int i = 0; i < matc_constant_count(program); i++) {
        const MatcConstant *member = matc_constant(program, i);
        float numbers[4] = {0};
        memcpy(numbers, bytes + member->offset, (size_t)member->components * sizeof *numbers);
        material_set(m, &(MaterialValue){member->name, member->components, numbers});
    }
}

bool material_set_numbers(Material *m, const MatcProgram *program)
{
    const size_t size = matc_constant_count(program) ? (size_t)matc_constant_bytes(program) : 0;
    unsigned char *bytes = size ? malloc(size) : NULL;
    if (!size)
        return true;
    if (!bytes)
        return gl_fail(context(m), "out of memory");
    matc_constant_block(program, bytes);
    if (!material_write(m, "Constants", bytes, size))
        set_plain_numbers(m, program, bytes);
    free(bytes);
    return true;
}

bool material_write(Material *m, const char *block, const void *bytes, size_t size)
{
    const GlContext *gl = context(m);
    if (uniforms_of(m)->block_count == 0)
        return false;
    const GLuint index = gl->GetUniformBlockIndex(m->program->name, block);
    if (index == GL_INVALID_INDEX)
        return false;
    const size_t capacity = (size_t)uniforms_of(m)->block_sizes[index];
    memcpy(m->blocks[index].bytes, bytes, size < capacity ? size : capacity);
    m->blocks[index].changed = true;
    return true;
}

/* Returns the texts with omitted stages taken from the program. */
static ProgramText complete(const ProgramText *text, const MatcProgram *program)
{
    ProgramText whole = *text;
    if (whole.compute[0])
        return whole;
    if (program && !whole.vertex[0])
        whole.vertex[0] = matc_output(program, MATC_VERTEX, NULL);
    if (program && !whole.fragment[0])
        whole.fragment[0] = matc_output(program, MATC_FRAGMENT, NULL);
    return whole;
}

static bool make(Material *m, MatcProgram *program, const ProgramText *text)
{
    static const float identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, along_z[4] = {0, 0, 1, 0};
    const char *names[MATERIAL_FEED_NAMES];
    ProgramText whole = complete(text, program);
    if (program && !material_feed_make(m, program, names, &whole))
        return false;
    if (program && matc_texture_count(program) > most_textures(m))
        return gl_fail(context(m), "it has %d textures, and the driver room for %d",
                       matc_texture_count(program),
                       /* checked before the driver fails with an unclear message */
                       most_textures(m));
    m->program = store_program(m->store, &whole);
    if (!m->program || !make_capacity(m))
        return false;
    material_set_number(m, "matc_ior", 1);
    material_set(m, &(MaterialValue){"matc_viewer", 4, along_z});
    material_set(m, &(MaterialValue){"matc_eyeFromWorld", 9, identity});
    if (!program)
        return true;
    set_uniforms(m, program);
    return material_set_numbers(m, program) && set_textures(m, program) &&
           gl_check(context(m), "making a material");
}

bool material_make(Store *store, MatcProgram *program, const ProgramText *text, Material *made)
{
    *made = (Material){.store = store};
    if (make(made, program, text))
        return true;
    material_delete(made);
    return false;
}

void material_delete(Material *m)
{
    for (int i = 0; i < m->texture_count; i++)
        store_drop(m->store, m->textures[i]);
    for (int i = 0; m->blocks && i < uniforms_of(m)->block_count; i++) {
        context(m)->DeleteBuffers(1, &m->blocks[i].buffer); /* GL ignores the name 0 */
        free(m->blocks[i].bytes);
    }
    free(m->values);
    free(m->blocks);
    free(m->feeds);
    if (m->store)
        store_drop(m->store, m->program);
    *m = (Material){0};
}

static void use_block(const GlContext *gl, int index, int size, struct MaterialBlock *block)
{
    const bool made = block->buffer != 0;
    if (!made)
        gl->GenBuffers(1, &block->buffer);
    /* also binds the buffer for the calls below */
    gl->BindBufferBase(GL_UNIFORM_BUFFER, (GLuint)index, block->buffer);
    if (!made)
        gl->BufferData(GL_UNIFORM_BUFFER, size, block->bytes, GL_DYNAMIC_DRAW);
    else if (block->changed)
        gl->BufferSubData(GL_UNIFORM_BUFFER, 0, size, block->bytes);
    block->changed = false;
}

/* Passes a plain uniform, unless the driver already has the value: other materials that share
 * the program may have set their own. */
static void use_uniform(const GlContext *gl, const GlUniform *uniform, const float *values,
                        StoreHeld *held)
{
    const size_t size = (size_t)uniform->components * sizeof *values;
    if (held->known && !memcmp(held->values, values, size))
        return;
    uniform_set(gl, uniform, values);
    memcpy(held->values, values, size);
    held->known = true;
}

void material_use_after(Material *m, const Material *before)
{
    const GlContext *gl = context(m);
    const GlUniforms *all = uniforms_of(m);
    if (!before || before->program != m->program)
        gl->UseProgram(m->program->name);
    for (int i = 0; i < m->texture_count; i++)
        if (!before || i >= before->texture_count || before->textures[i] != m->textures[i])
            texture_bind(gl, m->textures[i]->name, i);
    for (int i = 0; i < all->count; i++)
        if (all->at[i].block < 0)
            use_uniform(gl, &all->at[i], m->values[i], &m->program->held[i]);
    for (int i = 0; i < all->block_count; i++)
        if (i != all->view)
            use_block(gl, i, all->block_sizes[i], &m->blocks[i]);
}

void material_use(Material *m) { material_use_after(m, NULL); }

Key material_key(const Material *m)
{
    const GlUniforms *all = uniforms_of(m);
    Key key = key_of_bytes(&m->program, sizeof m->program);
    const Key shared[] = {key, key_of_bytes(m->textures, sizeof m->textures),
                          key_of_bytes(m->values, (size_t)all->count * sizeof *m->values)};
    key = key_of_bytes(shared, sizeof shared);
    for (int i = 0; i < all->block_count; i++) {
        const Key parts[] = {key, key_of_bytes(m->blocks[i].bytes, (size_t)all->block_sizes[i])};
        key = key_of_bytes(parts, sizeof parts);
    }
    return key;
}
