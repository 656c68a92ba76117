/* JSON to structs. Paths in a manifest are relative to its folder. */
#include "manifest.h"
#include "gl.h"
#include <cjson/cJSON.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *read_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END))
        fail(path, "cannot be read");
    size_t size = (size_t)ftell(file);
    char *text = calloc(1, size + 1);
    rewind(file);
    if (!text || fread(text, 1, size, file) != size)
        fail(path, "cannot be read");
    fclose(file);
    return text;
}

static const char *text_of(const cJSON *object, const char *key)
{
    const char *text = cJSON_GetStringValue(cJSON_GetObjectItem(object, key));
    if (!text)
        fail(key, "is missing in the manifest");
    return text;
}

/* The file beside `manifest` that a member of an object names. */
static char *file_of(const char *manifest, const cJSON *object, const char *key)
{
    char path[4096];
    const char *slash = strrchr(manifest, '/');
    snprintf(path, sizeof path, "%.*s%s", slash ? (int)(slash - manifest) + 1 : 0, manifest,
             text_of(object, key));
    return read_text(path);
}

static void read_program(Program *program, const char *path, const cJSON *json)
{
    program->file = text_of(json, "fragment");
    program->vertex = file_of(path, json, "vertex");
    program->fragment = file_of(path, json, "fragment");
    const cJSON *constants = cJSON_GetObjectItem(json, "constants");
    program->block_bytes = constants ? cJSON_GetObjectItem(constants, "size")->valueint : 0;
    char *reflection = file_of(path, json, "reflection");
    program->textures = cJSON_GetObjectItem(cJSON_Parse(reflection), "textures");
    free(reflection);
}

/* How a program samples the picture that it has under that name. */
static Sampling sampling_of(const Program *program, const char *name)
{
    const cJSON *texture;
    cJSON_ArrayForEach(texture, (const cJSON *)program->textures)
    {
        if (!strcmp(text_of(texture, "name"), name))
            return (Sampling){
                .mipmaps = !strcmp(text_of(texture, "filter"), "mipmaps"),
                .srgb = !strcmp(text_of(texture, "format"), "SRGB8_ALPHA8"),
                .anisotropy = (int)cJSON_GetNumberValue(cJSON_GetObjectItem(texture, "anisotropy")),
                .wrap = text_of(texture, "wrap")};
    }
    fail(name, "is not in the program's reflection");
}

/* A material's numbers, where the program's members lie in the block. */
static void fill_block(unsigned char *block, const cJSON *members, const cJSON *values)
{
    const cJSON *member, *numbers = values ? values->child : NULL, *number;
    cJSON_ArrayForEach(member, members)
    {
        size_t at = (size_t)cJSON_GetNumberValue(cJSON_GetObjectItem(member, "offset"));
        int words = text_of(member, "type")[0] == 'u'; /* uint, uvec4 */
        cJSON_ArrayForEach(number, numbers)
        {
            float real = (float)number->valuedouble;
            uint32_t whole = words ? (uint32_t)number->valuedouble : 0;
            memcpy(block + at, words ? (void *)&whole : (void *)&real, 4);
            at += 4;
        }
        numbers = numbers ? numbers->next : NULL;
    }
}

static void read_settings(Material *material, const Program *program, const cJSON *use)
{
    const cJSON *item, *number;
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(use, "textures"))
    {
        if (material->texture_count == MAX_TEXTURES)
            fail(material->name, "too many textures");
        material->textures[material->texture_count++] =
            (Setting){.name = item->string,
                      .file = item->valuestring,
                      .sampling = sampling_of(program, item->string)};
    }
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(use, "uniforms"))
    {
        if (material->uniform_count == MAX_UNIFORMS)
            fail(material->name, "too many uniforms");
        Setting *setting = &material->uniforms[material->uniform_count++];
        setting->name = item->string;
        cJSON_ArrayForEach(number, item) if (setting->components < 4)
            setting->numbers[setting->components++] = (float)number->valuedouble;
    }
}

/* What the material does in the G-buffer pass. */
static void read_material(Material *material, const Manifest *manifest, const cJSON *json,
                          const cJSON *programs)
{
    const cJSON *use;
    material->name = text_of(json, "name");
    cJSON_ArrayForEach(use, cJSON_GetObjectItem(json, "programs"))
    {
        if (strcmp(text_of(use, "pass"), "gbuffer") != 0)
            continue;
        material->program = (int)cJSON_GetNumberValue(cJSON_GetObjectItem(use, "program"));
        const cJSON *constants =
            cJSON_GetObjectItem(cJSON_GetArrayItem(programs, material->program), "constants");
        int bytes = manifest->programs[material->program].block_bytes;
        if (bytes) {
            material->block = calloc(1, (size_t)bytes);
            fill_block(material->block, cJSON_GetObjectItem(constants, "members"),
                       cJSON_GetObjectItem(use, "constants"));
        }
        read_settings(material, &manifest->programs[material->program], use);
    }
}

Manifest manifest_read(const char *path)
{
    char *text = read_text(path);
    cJSON *json = cJSON_Parse(text);
    if (!json)
        fail(path, "is not JSON");
    free(text);
    const cJSON *layout = cJSON_GetObjectItem(json, "layout"), *item;
    const cJSON *programs = cJSON_GetObjectItem(json, "programs"),
                *materials = cJSON_GetObjectItem(json, "materials");
    Manifest manifest = {.layout = text_of(layout, "name"),
                         .unpack = file_of(path, layout, "unpack")};
    manifest.bytes = (int)cJSON_GetNumberValue(cJSON_GetObjectItem(layout, "bytes"));
    cJSON_ArrayForEach(item, cJSON_GetObjectItem(layout, "targets")) if (manifest.target_count <
                                                                         MAX_TARGETS)
        manifest.targets[manifest.target_count++] = item->valuestring;
    manifest.programs = calloc((size_t)cJSON_GetArraySize(programs), sizeof *manifest.programs);
    manifest.materials = calloc((size_t)cJSON_GetArraySize(materials), sizeof *manifest.materials);
    cJSON_ArrayForEach(item, programs)
        read_program(&manifest.programs[manifest.program_count++], path, item);
    cJSON_ArrayForEach(item, materials)
        read_material(&manifest.materials[manifest.material_count++], &manifest, item, programs);
    return manifest; /* its names lie in the JSON, which stays */
}
