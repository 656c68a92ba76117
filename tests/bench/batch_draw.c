/* Reads programs, constants, textures and targets from a manifest. */
#include "batch_draw.h"
#include "runtime/gl/message.h"
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
    const char *names[FRAMEBUFFER_COLORS];
    FramebufferSpec spec = {.width = width, .height = height};
    cJSON_ArrayForEach(target, cJSON_GetObjectItem(layout, "targets"))
    {
        if (spec.color_count < FRAMEBUFFER_COLORS)
            names[spec.color_count++] = target->valuestring;
    }
    return framebuffer_make_named(meter->gl, &spec, names, &output->targets) ||
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
    const cJSON *one = cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "materials"), material),
                *item;
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

/* Fills the std140 block that the manifest describes with the material's constants. */
static void set_block(Material *made, const cJSON *constants, const cJSON *use)
{
    unsigned char block[LARGEST_BLOCK] = {0};
    const cJSON *member, *values = cJSON_GetObjectItem(use, "constants");
    int i = 0;
    cJSON_ArrayForEach(member, cJSON_GetObjectItem(constants, "members"))
        put_member(block, member, cJSON_GetArrayItem(values, i++));
    material_write(made, cJSON_GetObjectItem(constants, "block")->valuestring, block, sizeof block);
}

/* Sets up the sampler with that name by the reflection. */
static void set_sampler(TextureSpec *spec, const cJSON *textures, const char *name)
{
    const cJSON *texture;
    cJSON_ArrayForEach(texture, textures)
    {
        if (strcmp(cJSON_GetObjectItem(texture, "name")->valuestring, name) != 0)
            continue;
        spec->mipmaps = !strcmp(cJSON_GetObjectItem(texture, "filter")->valuestring, "mipmaps");
        spec->anisotropy = cJSON_GetObjectItem(texture, "anisotropy")->valueint;
        spec->wrap = texture_wrap(cJSON_GetObjectItem(texture, "wrap")->valuestring);
    }
}

/* Every picture is a pattern of bytes, because its content does not influence the cost. */
static bool set_textures(Material *made, const cJSON *use, const cJSON *reflection)
{
    static const size_t size = (size_t)PICTURE_SIDE * PICTURE_SIDE * 4;
    const cJSON *texture;
    bool fine = true;
    uint8_t *bytes = malloc(size);
    if (!bytes)
        abort();
    for (size_t i = 0; i < size; i++)
        bytes[i] = (uint8_t)(i * 2654435761u >> 24);
    cJSON_ArrayForEach(texture, cJSON_GetObjectItem(use, "textures"))
    {
        TextureSpec spec = {
            .width = PICTURE_SIDE, .height = PICTURE_SIDE, .components = 4, .bytes = bytes};
        set_sampler(&spec, cJSON_GetObjectItem(reflection, "textures"), texture->string);
        fine = fine && material_set_texture(made, texture->string, &spec);
    }
    free(bytes);
    return fine;
}

/* NULL: missing or invalid. */
static cJSON *read_json(const BatchOutput *output, const cJSON *name)
{
    char *text = name ? batch_read(output->folder, output->out, name->valuestring) : NULL;
    cJSON *json = text ? cJSON_Parse(text) : NULL;
    free(text);
    return json;
}

bool batch_draw_make(Meter *meter, const BatchOutput *output, int material, Material *made)
{
    const cJSON *use, *program = batch_program(output->manifest, material, "gbuffer", &use);
    const char *name = program ? cJSON_GetObjectItem(program, "fragment")->valuestring : "";
    char *text = program ? batch_read(output->folder, output->out, name) : NULL;
    *made = (Material){0};
    bool fine =
        text && field_material(meter->store, NULL, &(FieldText){TARGET_glsl330, text, NULL}, made);
    const cJSON *constants = fine ? cJSON_GetObjectItem(program, "constants") : NULL;
    free(text);
    if (constants)
        set_block(made, constants, use);
    cJSON *reflection = read_json(output, cJSON_GetObjectItem(program, "reflection"));
    fine = fine && set_textures(made, use, reflection);
    cJSON_Delete(reflection);
    return fine || message_fail(meter->error, sizeof meter->error, "%s/%s: %s", output->out, name,
                                meter->gl->error);
}
