/* Writes the manifest of a batch as JSON: programs, and for every material its programs and
 * constants. */
#include "compiler/tool/batch_state.h"
#include "compiler/choice.h"
#include "compiler/base/json_write.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include <cjson/cJSON.h>
#include <stdlib.h>
#include <string.h>

/* Appends , "key": "name.suffix" */
static void put_file_name(Text *out, const char *key, const char *name, const char *suffix)
{
    Text file = text_new(out->arena);
    text_put(&file, name);
    text_put(&file, suffix);
    json_next(out, key, file.at);
}

/* Writes the numbers of the cases that are read back; all if the set is 0. */
static void put_cases(Text *out, const LayoutRow *layout, unsigned cases)
{
    const char *before = "";
    for (int i = 0; i < layout->case_count; i++)
        if (!cases || cases >> i & 1) {
            text_format(out, "%s%d", before, i);
            before = ", ";
        }
}

static void put_layout(Text *out, const Batch *b)
{
    Job job;
    bool any = false;
    for (int i = 0; i < b->program_count; i++)
        any |=
            b->programs[i].first->pass == PASS_gbuffer || b->programs[i].first->pass == PASS_plane;
    if (!any || choice_job(&b->options, &job))
        return;
    text_put(out, ",\n  \"layout\": {");
    json_member(out, "name", job.layout->name);
    json_next(out, "normals", normals_table[job.normals].name);
    text_format(out, ", \"bytes\": %d, \"targets\": [", layout_bytes(job.layout));
    for (int i = 0; i < layout_targets(job.layout); i++) {
        text_put(out, i ? ", " : "");
        json_string(out, format_table[job.layout->formats[i]].name);
    }
    text_put(out, "], \"cases\": [");
    put_cases(out, job.layout, batch_cases(b));
    text_put(out, "]");
    if (b->line->emit[EMIT_unpack])
        put_file_name(out, "unpack", job.layout->name, emit_table[EMIT_unpack].suffix);
    if (b->line->emit[EMIT_layout])
        put_file_name(out, "file", job.layout->name, emit_table[EMIT_layout].suffix);
    text_put(out, "}");
}

/* Per emit: the member of a program that names the file; NULL: none. */
static const char *const file_keys[EMIT_COUNT] = {
    [EMIT_glsl] = "fragment",
    [EMIT_vertex] = "vertex",
    [EMIT_reflect] = "reflection",
    [EMIT_spirv] = "spirv",
    [EMIT_ir] = "ir",
    [EMIT_dot] = "dot",
    [EMIT_tessvertex] = "tessvertex",
    [EMIT_tesscontrol] = "tesscontrol",
    [EMIT_tesseval] = "tesseval",
    [EMIT_geometryvertex] = "geometryvertex",
    [EMIT_geometry] = "geometry",
    [EMIT_displace] = "displace",
    [EMIT_compute] = "compute",
};

static void put_files(Text *out, const Batch *b, const char *name)
{
    bool spirv = choice_target(&b->options)->spirv;
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        int as = emit == EMIT_glsl && spirv ? EMIT_spirv : emit;
        if (emit == EMIT_glsl && spirv && b->line->emit[EMIT_spirv])
            continue; /* two outputs were written to the same file */
        if (b->line->emit[emit] && file_keys[emit])
            put_file_name(out, file_keys[as], name, options_emit_suffix(&b->options, emit));
    }
}

static void put_program(Text *out, const Batch *b, const BatchProgram *program)
{
    char digits[KEY_TEXT];
    key_text(program->members ? program->first->shape : program->first->key, digits);
    text_put(out, "{");
    json_member(out, "pass", pass_table[program->first->pass].name);
    json_next(out, "key", digits);
    put_files(out, b, program->name);
    text_format(out, ", \"materials\": %d%s}", program->unit_count, program->first->written->json);
}

static void put_number(Text *out, uint32_t bits, bool word)
{
    float number;
    memcpy(&number, &bits, sizeof number);
    if (word)
        text_format(out, "%lu", (unsigned long)bits);
    else
        text_float(out, number);
}

/* Writes the material's values for the members of its program's uniform block. */
static void put_constants(Text *out, const Unit *unit, const Written *written)
{
    if (!written->member_count)
        return;
    int *offsets = unit_offsets(unit);
    text_put(out, ", \"constants\": [");
    for (int i = 0; i < written->member_count; i++) {
        int number = written->members[i], components = unit_components(unit, number);
        text_put(out, i ? ", [" : "[");
        for (int component = 0; component < components; component++) {
            text_put(out, component ? ", " : "");
            put_number(out, unit->bits[offsets[number] + component], unit_is_word(unit, number));
        }
        text_put(out, "]");
    }
    text_put(out, "]");
    free(offsets);
}

static void put_material(Text *out, const Batch *b, const BatchDocument *document,
                         const BatchMaterial *material)
{
    text_put(out, "{");
    json_member(out, "name", material->name);
    json_next(out, "source", document->depend_count ? document->depends[0] : document->path);
    json_next(out, "opacity", material->opacity);
    text_put(out, ", \"programs\": [");
    for (int request = 0; request < b->request_count; request++) {
        const Unit *unit = &material->units[request];
        text_put(out, request ? ",\n      {" : "\n      {");
        json_member(out, "pass", b->requests[request]);
        text_format(out, ", \"program\": %d", unit->program);
        put_constants(out, unit, b->programs[unit->program].first->written);
        text_format(out, "%s}", unit->own);
    }
    text_put(out, "]}");
}

/* Lists the files of this run, so that the next run recognizes them. */
static void put_folder(Text *out, const Batch *b)
{
    int count;
    char digits[KEY_TEXT];
    StagingFile *list = staging_list(b->staging, &count);
    text_put(out, ",\n  \"files\": {");
    for (int i = 0; i < count; i++) {
        text_put(out, i ? ",\n    " : "\n    ");
        key_text(list[i].hash, digits);
        json_member(out, list[i].name, digits);
    }
    text_put(out, "\n  }");
    free(list);
}

/* Moves the text so far to the bytes, since the manifest of many materials is long. */
static void flush(Text *out, Bytes *to)
{
    bytes_add(to, out->at, out->size);
    out->size = 0;
}

void manifest_put(const Batch *b, Bytes *to)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    bool any = false;
    text_put(&out, "{\n  ");
    json_member(&out, "matc", MATC_VERSION);
    text_put(&out, ",\n  ");
    json_member(&out, "target", choice_target(&b->options)->name);
    put_layout(&out, b);
    text_put(&out, ",\n  \"programs\": [");
    for (int i = 0; i < b->program_count; i++) {
        text_put(&out, i ? ",\n    " : "\n    ");
        put_program(&out, b, &b->programs[i]);
        flush(&out, to);
    }
    text_put(&out, "\n  ],\n  \"materials\": [");
    for (int d = 0; d < b->document_count; d++)
        for (int m = 0; m < b->documents[d].material_count; m++) {
            text_put(&out, any ? ",\n    " : "\n    ");
            put_material(&out, b, &b->documents[d], &b->documents[d].materials[m]);
            flush(&out, to);
            any = true;
        }
    text_put(&out, "\n  ]");
    put_folder(&out, b);
    text_put(&out, "\n}\n");
    flush(&out, to);
    arena_free(&arena);
}

/* Returns true for a file name that matc could have written. */
static bool is_output(const char *name)
{
    size_t size = strlen(name);
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        size_t end = strlen(emit_table[emit].suffix);
        if (size > end && !strcmp(name + size - end, emit_table[emit].suffix))
            return true;
    }
    return size > 4 && !strcmp(name + size - 4, ".ktx");
}

/* Marks stale files for removal. The old manifest may be foreign, and a file may have been
 * edited: a file is removed only if its bytes have the recorded hash. */
void manifest_remove_stale(Batch *b, const char *old)
{
    cJSON *json = cJSON_Parse(old);
    const cJSON *file;
    /* cJSON keeps a pointer to its last parse error, here in freed text; a successful parse
     * resets it. */
    if (!json)
        cJSON_Delete(cJSON_Parse("0"));
    cJSON_ArrayForEach(file, cJSON_GetObjectItemCaseSensitive(json, "files"))
    {
        const char *hash = cJSON_GetStringValue(file), *name = file->string;
        if (!name || !hash || strlen(hash) != KEY_TEXT - 1 || !is_output(name) ||
            batch_reads(b, name))
            continue;
        bool stays;
        const char *why = staging_remove(b->staging, name, key_read(hash), &stays);
        if (why)
            batch_complain_within(b, NULL, b->line->folder, name, why);
        else if (stays)
            batch_warn(b, name,
                       "it is obsolete, but is kept because it was changed after matc wrote it");
    }
    cJSON_Delete(json);
}
