/* Compiles, links, sets textures and uniforms. */
#include "runtime/measure/shader.h"
#include "runtime/measure/field.h"
#include "runtime/gl/block.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <stdlib.h>
#include <string.h>

MatcProgram *shader_compile(const MatcDocument *document, int material, unsigned outputs, const MatcOptions *options)
{
    MatcOptions quiet = *options;
    quiet.target = NULL;
    quiet.validate = quiet.check = quiet.measure = false;
    MatcProgram *program = matc_compile(document, material, outputs, &quiet);
    if (matc_ok(program))
        return program;
    matc_program_free(program);
    return NULL;
}

static bool link(GlContext *gl, const char *const *fragment, int pieces, Shader *made)
{
    char vertex[FIELD_TEXT];
    ProgramText text = {.vertex = {vertex}, .attributes = field_attributes, .attribute_count = FIELD_VARYINGS + 1};
    for (int i = 0; i < pieces && i < PROGRAM_PIECES; i++)
        text.fragment[i] = fragment[i];
    field_vertex_text(fragment[0], vertex);
    made->name = program_make(gl, &text);
    return made->name != 0;
}

static bool make_textures(GlContext *gl, Shader *made)
{
    int count = matc_texture_count(made->program);
    if (count > SHADER_TEXTURES)
        return gl_fail(gl, "a material with more than %d textures", SHADER_TEXTURES);
    for (int i = 0; i < count; i++) {
        MatcTexture t = *matc_texture(made->program, i);
        TextureSpec spec = {t.width, t.height, t.lanes, t.bytes, t.floats, false, true, t.mipmaps};
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)i); /* making a texture binds it */
        made->textures[i] = texture_make(gl, &spec);
        if (!made->textures[i])
            return false;
        program_set(gl, made->name, &(ProgramValue){t.name, 1, &(float){(float)i}});
        made->texture_count++;
    }
    return true;
}

enum { CONSTANTS_BINDING = 1 };

static void make_constants(GlContext *gl, Shader *made)
{
    size_t size = (size_t)matc_constant_bytes(made->program);
    void *bytes = malloc(size + 1);
    if (!bytes)
        abort();
    matc_constant_block(made->program, bytes);
    made->constants = block_make(gl, made->name, "Constants", CONSTANTS_BINDING, bytes, size);
    free(bytes);
}

static void set_uniforms(GlContext *gl, const Shader *made)
{
    program_set(gl, made->name, &(ProgramValue){"matc_ior", 1, &(float){1}});
    program_set(gl, made->name, &(ProgramValue){"matc_eyeFromWorld", 9, (float[9]){1, 0, 0, 0, 1, 0, 0, 0, 1}});
    for (int i = 0; i < matc_uniform_count(made->program); i++) {
        MatcUniform uniform = *matc_uniform(made->program, i);
        float numbers[4];
        for (int lane = 0; lane < 4; lane++)
            numbers[lane] = (float)uniform.initial[lane];
        program_set(gl, made->name, &(ProgramValue){uniform.name, uniform.lanes, numbers});
    }
}

bool shader_make(GlContext *gl, MatcProgram *program, Shader *made)
{
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
    *made = (Shader){.program = program};
    if (!link(gl, &fragment, 1, made) || !make_textures(gl, made))
        return false;
    set_uniforms(gl, made);
    make_constants(gl, made);
    return true;
}

bool shader_make_plain(GlContext *gl, const char *const *fragment, int pieces, Shader *made)
{
    *made = (Shader){0};
    return link(gl, fragment, pieces, made);
}

void shader_use(GlContext *gl, const Shader *shader, const float jitter[2])
{
    for (int i = 0; i < shader->texture_count; i++)
        texture_bind(gl, shader->textures[i], i);
    if (shader->constants)
        gl->BindBufferBase(GL_UNIFORM_BUFFER, CONSTANTS_BINDING, shader->constants);
    gl->UseProgram(shader->name);
    program_set(gl, shader->name, &(ProgramValue){"measure_jitter", 2, jitter});
}

void shader_delete(const GlContext *gl, Shader *shader)
{
    gl->DeleteProgram(shader->name);
    gl->DeleteBuffers(1, &shader->constants);
    gl->DeleteTextures(shader->texture_count, shader->textures);
    matc_program_free(shader->program);
    *shader = (Shader){0};
}
