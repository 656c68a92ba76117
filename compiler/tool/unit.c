/* A unit of a batch: a material in a pass. */
#include "compiler/tool/unit.h"
#include "grammar/tables.h"
#include "compiler/base/json_write.h"
#include "compiler/base/session.h"
#include "compiler/base/sets.h"
#include "compiler/base/text.h"
#include <stdlib.h>
#include <string.h>

int unit_pass(const MatcProgram *program)
{
    int pass = 0;
    while (pass < PASS_COUNT - 1 && strcmp(pass_table[pass].name, matc_pass(program)) != 0)
        pass++;
    return pass;
}

static void take_numbers(Unit *unit, MatcProgram *program, bool buffered)
{
    int components = 0;
    unit->count = buffered ? matc_constant_count(program) : matc_place_count(program);
    unit->components = sets_resize(NULL, (size_t)unit->count);
    unit->bits = sets_resize(NULL, (size_t)unit->count * 4 * sizeof *unit->bits);
    for (int i = 0; i < unit->count; i++) {
        const MatcConstant *number = buffered ? matc_constant(program, i) : matc_place(program, i);
        bool word = number->type[0] == 'u';
        unit->components[i] = (uint8_t)(number->components + (word ? UNIT_WORDS : 0));
        for (int component = 0; component < number->components; component++)
            unit->bits[components++] = constant_bits(number->values[component], word);
    }
    unit->bit_count = components;
    unit->bits = sets_resize(unit->bits, (size_t)components * sizeof *unit->bits);
}

static void put_uniforms(Text *out, const MatcProgram *program)
{
    int count = matc_uniform_count(program);
    for (int i = 0; i < count; i++) {
        const MatcUniform *uniform = matc_uniform(program, i);
        text_put(out, i ? ", " : ", \"uniforms\": {");
        json_key(out, uniform->name);
        text_put(out, "[");
        for (int component = 0; component < uniform->components; component++) {
            text_put(out, component ? ", " : "");
            text_double(out, uniform->initial[component]);
        }
        text_put(out, "]");
    }
    text_put(out, count ? "}" : "");
}

/* Writes the textures: images by their files; generated textures by the file that --textures
 * writes, if given. */
static void put_textures(Text *out, MatcProgram *program, const char *folder_and_material)
{
    bool any = false;
    for (int i = 0; i < matc_texture_count(program); i++) {
        const MatcTexture *texture = matc_texture(program, i);
        Text path = text_new(out->arena);
        if (!texture->path && !folder_and_material)
            continue;
        if (texture->path)
            text_put(&path, texture->path);
        else
            text_format(&path, "%s.%s.ktx", folder_and_material, texture->name);
        text_put(out, any ? ", " : ", \"textures\": {");
        json_member(out, texture->name, path.at);
        any = true;
    }
    text_put(out, any ? "}" : "");
}

void unit_fill(Unit *unit, MatcProgram *program, bool buffered, const char *textures)
{
    Arena arena = {0};
    Text own = text_new(&arena);
    unit->key = key_read(matc_key(program));
    unit->shape = key_read(matc_shape(program));
    unit->pass = unit_pass(program);
    unit->layout_case = matc_case(program);
    take_numbers(unit, program, buffered);
    put_uniforms(&own, program);
    put_textures(&own, program, textures);
    unit->own = sets_copy(own.size ? own.at : "");
    arena_free(&arena);
}

static void put_block(Text *out, const MatcProgram *program)
{
    if (!matc_constant_count(program))
        return;
    text_format(out,
                ",\n     \"constants\": {\"block\": \"Constants\", \"size\": %d, \"members\": [",
                matc_constant_bytes(program));
    for (int i = 0; i < matc_constant_count(program); i++) {
        const MatcConstant *member = matc_constant(program, i);
        text_put(out, i ? ",\n       {" : "\n       {");
        json_member(out, "name", member->name);
        json_next(out, "type", member->type);
        text_format(out, ", \"offset\": %d}", member->offset);
    }
    text_put(out, "]}");
}

/* Writes the noise tables, which are equal for all materials. */
static void put_tables(Text *out, MatcProgram *program)
{
    bool any = false;
    for (int i = 0; i < matc_texture_count(program); i++) {
        const MatcTexture *texture = matc_texture(program, i);
        if (texture->path || strncmp(texture->name, "matc_", 5) != 0)
            continue;
        text_put(out, any ? ", " : ",\n     \"tables\": [");
        json_string(out, texture->name);
        any = true;
    }
    text_put(out, any ? "]" : "");
}

Written *unit_written(MatcProgram *program, bool buffered)
{
    Arena arena = {0};
    Text json = text_new(&arena);
    Written *written = sets_resize(NULL, sizeof *written);
    put_block(&json, program);
    put_tables(&json, program);
    *written = (Written){.json = sets_copy(json.size ? json.at : ""),
                         .member_count = matc_constant_count(program)};
    written->members = sets_resize(NULL, (size_t)written->member_count * sizeof *written->members);
    for (int i = 0; i < written->member_count; i++)
        written->members[i] = buffered ? i : matc_constant(program, i)->member;
    arena_free(&arena);
    return written;
}

void written_free(Written *written)
{
    if (!written)
        return;
    free(written->json);
    free(written->members);
    free(written);
}

void unit_free(Unit *unit)
{
    free(unit->components);
    free(unit->bits);
    free(unit->own);
    free(unit->files);
    written_free(unit->written);
}

int *unit_offsets(const Unit *unit)
{
    int *offsets = sets_resize(NULL, (size_t)unit->count * sizeof *offsets), at = 0;
    for (int i = 0; i < unit->count; i++) {
        offsets[i] = at;
        at += unit_components(unit, i);
    }
    return offsets;
}

const Key *unit_find_files(const Unit *unit, Key members)
{
    for (int i = 0; i < unit->file_count; i++)
        if (key_equal(unit->files[i].members, members))
            return &unit->files[i].files;
    return NULL;
}

void unit_add_files(Unit *unit, Key members, Key files)
{
    const Key *known = unit_find_files(unit, members);
    if (known && key_equal(*known, files))
        return;
    if (!unit->files)
        unit->files = sets_resize(NULL, MAX_UNIT_FILES * sizeof *unit->files);
    if (unit->file_count == MAX_UNIT_FILES) /* drops the oldest cached program */
        unit->file_count--;
    memmove(unit->files + 1, unit->files, (size_t)unit->file_count++ * sizeof *unit->files);
    unit->files[0] = (UnitFiles){members, files};
    unit->changed = true;
}

void unit_store(Bytes *to, const Unit *unit)
{
    bytes_add(to, &unit->key, sizeof unit->key);
    bytes_add(to, &unit->shape, sizeof unit->shape);
    bytes_number(to, (uint32_t)unit->pass);
    bytes_number(to, (uint32_t)(unit->layout_case + 1));
    bytes_block(to, unit->components, (size_t)unit->count);
    bytes_block(to, unit->bits, (size_t)unit->bit_count * sizeof *unit->bits);
    bytes_text(to, unit->own);
    bytes_block(to, unit->files ? (const char *)unit->files : "",
                (size_t)unit->file_count * sizeof *unit->files);
}

static void *copy(const void *from, size_t size)
{
    return size ? memcpy(sets_resize(NULL, size), from, size) : sets_resize(NULL, 0);
}

bool unit_load(BytesReader *from, Unit *unit)
{
    size_t count, size, files_size;
    const void *key = bytes_take(from, sizeof unit->key),
               *shape = bytes_take(from, sizeof unit->shape);
    uint32_t pass = bytes_take_number(from), numbered = bytes_take_number(from);
    const char *components = bytes_take_block(from, &count), *bits = bytes_take_block(from, &size),
               *own = bytes_take_text(from);
    const char *files = bytes_take_block(from, &files_size);
    size_t wanted = 0;
    for (size_t i = 0; !from->broken && i < count; i++)
        wanted += (size_t)(components[i] > UNIT_WORDS ? components[i] - UNIT_WORDS : components[i]);
    if (from->broken || pass >= PASS_COUNT || numbered > LIMIT_LAYOUT_CASES ||
        size != wanted * sizeof *unit->bits || files_size > MAX_UNIT_FILES * sizeof *unit->files ||
        files_size % sizeof *unit->files)
        return false;
    memcpy(&unit->key, key, sizeof unit->key);
    memcpy(&unit->shape, shape, sizeof unit->shape);
    unit->pass = (int)pass;
    unit->layout_case = (int)numbered - 1;
    unit->count = (int)count;
    unit->bit_count = (int)wanted;
    unit->components = copy(components, count);
    unit->bits = copy(bits, size);
    unit->own = sets_copy(own);
    unit->file_count = (int)(files_size / sizeof *unit->files);
    if (files_size) {
        unit->files = sets_resize(NULL, MAX_UNIT_FILES * sizeof *unit->files);
        memcpy(unit->files, files, files_size);
    }
    return true;
}

void written_store(Bytes *to, const Written *written)
{
    bytes_text(to, written->json);
    bytes_block(to, written->members, (size_t)written->member_count * sizeof *written->members);
}

Written *written_load(BytesReader *from)
{
    size_t size;
    const char *json = bytes_take_text(from), *members = bytes_take_block(from, &size);
    if (from->broken || size % sizeof(int))
        return NULL;
    Written *written = sets_resize(NULL, sizeof *written);
    *written = (Written){sets_copy(json), copy(members, size), (int)(size / sizeof(int))};
    return written;
}
