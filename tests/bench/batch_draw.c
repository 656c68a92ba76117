/* Programs, constants, textures and targets from a manifest. */
#include "batch_draw.h"
#include "runtime/gl/message.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PICTURE_SIDE = 64, LARGEST_BLOCK = 1 << 14 };

bool batch_output_read(BatchOutput *output, const BatchFolder *folder, const char *out)
{
    *output = (BatchOutput){.folder = folder, .out = out};
    char *text = batch_read(folder, out, "manifest.json");
    output->manifest = text ? cJSON_Parse(text) : NULL;
    free(text);
    if (!output->manifest)
        fprintf(stderr, "matbench: %s has no manifest\n", out);
    return output->manifest != NULL;
}

bool batch_output_targets(BatchOutput *output, Meter *meter, int width, int height)
{
    const cJSON *layout = cJSON_GetObjectItem(output->manifest, "layout"), *target;
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    FramebufferSpec spec = {.width = width, .height = height};
    cJSON_ArrayForEach(target, cJSON_GetObjectItem(layout, "targets"))
    {
        if (spec.color_count < FRAMEBUFFER_COLORS)
            formats[spec.color_count++] = framebuffer_format(target->valuestring);
    }
    return framebuffer_make_of(meter->gl, &spec, formats, &output->targets) ||
           message_fail(meter->error, sizeof meter->error, "%s", meter->gl->error);
}

void batch_output_delete(BatchOutput *output, Meter *meter)
{
    if (meter)
        framebuffer_delete(meter->gl, &output->targets);
    cJSON_Delete(output->manifest);
    *output = (BatchOutput){0};
}

const cJSON *batch_program(const cJSON *manifest, int material, const char *pass, const cJSON **use)
{
    const cJSON *one = cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "materials"), material), *item;
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(one, "programs"))
    {
        const cJSON *number = cJSON_GetObjectItem(item, "program");
        if (strcmp(cJSON_GetObjectItem(item, "pass")->valuestring, pass) != 0 || !number)
            continue;
        *use = item;
        return cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "programs"), number->valueint);
    }
    return NULL;
}

static void put_member(unsigned char *block, const cJSON *member, const cJSON *values)
{
    const bool word = !strcmp(cJSON_GetObjectItem(member, "type")->valuestring, "uint");
    int at = cJSON_GetObjectItem(member, "offset")->valueint;
    const cJSON *value;
    cJSON_ArrayForEach(value, values)
    {
        float number = (float)value->valuedouble;
        uint32_t whole = (uint32_t)value->valuedouble;
        if (at >= 0 && at <= LARGEST_BLOCK - 4)
            memcpy(block + at, word ? (void *)&whole : (void *)&number, 4);
        at += 4;
    }
}

/* The block of std140 that the manifest describes, filled in for the material. */
static void make_block(GlContext *gl, const cJSON *constants, const cJSON *use, int binding, BatchDraw *made)
{
    unsigned char block[LARGEST_BLOCK] = {0};
    const cJSON *member, *values = cJSON_GetObjectItem(use, "constants");
    int i = 0;
    cJSON_ArrayForEach(member, cJSON_GetObjectItem(constants, "members"))
        put_member(block, member, cJSON_GetArrayItem(values, i++));
    GLuint index = gl->GetUniformBlockIndex(made->shader.name, cJSON_GetObjectItem(constants, "block")->valuestring);
    gl->GenBuffers(1, &made->buffer);
    gl->BindBuffer(GL_UNIFORM_BUFFER, made->buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, LARGEST_BLOCK, block, GL_STATIC_DRAW);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, (GLuint)binding, made->buffer);
    if (index != GL_INVALID_INDEX)
        gl->UniformBlockBinding(made->shader.name, index, (GLuint)binding);
}

/* Every picture is a pattern of bytes: what it shows costs nothing more or less. */
static bool make_textures(GlContext *gl, const cJSON *use, Shader *shader)
{
    static const size_t size = (size_t)PICTURE_SIDE * PICTURE_SIDE * 4;
    const cJSON *texture;
    uint8_t *bytes = malloc(size);
    if (!bytes)
        abort();
    for (size_t i = 0; i < size; i++)
        bytes[i] = (uint8_t)(i * 2654435761u >> 24);
    const TextureSpec spec = {
        .width = PICTURE_SIDE, .height = PICTURE_SIDE, .lanes = 4, .bytes = bytes, .repeat = true};
    cJSON_ArrayForEach(texture, cJSON_GetObjectItem(use, "textures"))
    {
        int unit = shader->texture_count;
        if (unit == SHADER_TEXTURES)
            break;
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        shader->textures[unit] = texture_make(gl, &spec);
        shader->texture_count += shader->textures[unit] != 0;
        program_set(gl, shader->name, &(ProgramValue){texture->string, 1, &(float){(float)unit}});
    }
    free(bytes);
    return shader->texture_count == cJSON_GetArraySize(cJSON_GetObjectItem(use, "textures"));
}

bool batch_draw_make(Meter *meter, const BatchOutput *output, int material, int binding, BatchDraw *made)
{
    GlContext *gl = meter->gl;
    const cJSON *use, *program = batch_program(output->manifest, material, "gbuffer", &use);
    *made = (BatchDraw){0};
    const char *name = program ? cJSON_GetObjectItem(program, "fragment")->valuestring : "";
    char *text = program ? batch_read(output->folder, output->out, name) : NULL;
    bool fine = text && shader_make_plain(gl, &(const char *){text}, 1, &made->shader);
    free(text);
    if (!fine)
        return message_fail(meter->error, sizeof meter->error, "%s/%s: %s", output->out, name, gl->error);
    program_set(gl, made->shader.name, &(ProgramValue){"matc_ior", 1, &(float){1}});
    program_set(gl, made->shader.name, &(ProgramValue){"matc_eyeFromWorld", 9, (float[9]){1, 0, 0, 0, 1, 0, 0, 0, 1}});
    const cJSON *constants = cJSON_GetObjectItem(program, "constants");
    if (constants)
        make_block(gl, constants, use, binding, made);
    return make_textures(gl, use, &made->shader) ||
           message_fail(meter->error, sizeof meter->error, "%s/%s: %s", output->out, name, gl->error);
}

void batch_draw_delete(Meter *meter, BatchDraw *draw)
{
    shader_delete(meter->gl, &draw->shader);
    meter->gl->DeleteBuffers(1, &draw->buffer);
    *draw = (BatchDraw){0};
}
