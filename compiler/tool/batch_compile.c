/* Compiles a material's program in every pass to IR, and writes the files of programs. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/output.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Writes a program for one of its materials, and keeps its data for the manifest. */
static void write_program(Batch *b, BatchDocument *document, const BatchEdition *edition,
                          MatcProgram *program)
{
    Unit *unit = edition->unit;
    if (!matc_emit(program, b->outputs)) {
        batch_report_of(b, document, unit->material,
                        matc_program_diagnostics(program, b->line->diagnostics));
        batch_fault(b);
        return;
    }
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        size_t size;
        if (!b->line->emit[emit] || !batch_is_of_program(emit))
            continue;
        const char *text = options_emit_text(&b->options, emit, program, &size);
        const BatchFile file = {edition->base, options_emit_suffix(&b->options, emit)};
        batch_put_file(b, document, file, text, size);
    }
    written_free(unit->written);
    unit->written = unit_written(program, b->numbers == NUMBERS_uniform);
    batch_store_program(b, edition, program);
}

/* Returns true for the first caller per program. */
static bool first_of_program(Batch *b, const Unit *unit)
{
    bool added;
    pthread_mutex_lock(&b->mutex);
    key_set_add(&b->seen, b->numbers == NUMBERS_auto ? unit->shape : unit->key, &added);
    pthread_mutex_unlock(&b->mutex);
    return added;
}

/* Writes generated textures. A material's textures are named after its program, since each pass
 * numbers its own; noise tables have their own names. */
static void write_textures(Batch *b, BatchDocument *document, const char *base,
                           MatcProgram *program)
{
    char name[2 * LONGEST_NAME];
    for (int i = 0; b->textures && i < matc_texture_count(program); i++) {
        const MatcTexture *texture = matc_texture(program, i);
        bool table = !strncmp(texture->name, "matc_", 5);
        size_t size;
        if (texture->path)
            continue;
        snprintf(name, sizeof name, "%s%s%s.ktx", table ? "" : base, table ? "" : ".",
                 texture->name);
        char *bytes = output_ktx(texture, &size);
        const char *why = staging_put(b->textures, name, bytes, size);
        free(bytes);
        if (why)
            batch_complain_within(b, document, b->line->textures, name, why);
    }
}

/* Compiles the material in a pass. With members, these numbers come from a uniform block.
 * Returns NULL after reporting a fault. */
static MatcProgram *compile(Batch *b, BatchDocument *document, const Unit *unit, const int *members)
{
    const MatcDocument *parsed = batch_document_parsed(b, document);
    int material = document->offset + unit->material;
    MatcOptions options = b->options;
    options.pass = b->requests[unit->request];
    if (material >= matc_material_count(parsed)) {
        batch_complain(b, document, document->path, "the file changed while it was compiled");
        return NULL;
    }
    if (b->line->max_error && !b->calls->choose(b->calls->user, parsed, material, &options)) {
        batch_fault(b);
        return NULL;
    }
    options.members = members;
    options.member_count = members ? unit->count : 0;
    MatcProgram *program = matc_compile(parsed, material, MATC_KEY, &options);
    if (matc_ok(program))
        return program;
    batch_report_of(b, document, unit->material,
                    matc_program_diagnostics(program, b->line->diagnostics));
    batch_fault(b);
    matc_program_free(program);
    return NULL;
}

static void compile_request(Batch *b, BatchDocument *document, BatchMaterial *own, Unit *unit)
{
    char name[LONGEST_NAME], textures[LONGEST_PATH];
    MatcProgram *program = compile(b, document, unit, NULL);
    if (!program)
        return;
    /* diagnostics of a successful compilation are warnings only */
    batch_report_of(b, document, unit->material,
                    matc_program_diagnostics(program, b->line->diagnostics));
    unit->pass = unit_pass(program);
    batch_name(b, unit, name);
    snprintf(textures, sizeof textures, "%s/%s", b->line->textures ? b->line->textures : "", name);
    unit_fill(unit, program, b->numbers == NUMBERS_uniform, b->textures ? textures : NULL);
    if (!unit->request)
        own->opacity = matc_opacity(program);
    bool first = first_of_program(b, unit);
    if (first)
        write_program(b, document, &(BatchEdition){unit, NULL, name}, program);
    if (first || b->textures)
        write_textures(b, document, name, program);
    matc_program_free(program);
}

/* Uses a cached program; its files are written from the cache if they are there, too. */
static void stored_request(Batch *b, BatchDocument *document, Unit *unit)
{
    char name[LONGEST_NAME];
    const BatchEdition edition = {unit, NULL, name};
    batch_name(b, unit, name);
    if (!first_of_program(b, unit) || batch_stored_program(b, document, &edition))
        return;
    MatcProgram *program = compile(b, document, unit, NULL);
    if (program)
        write_program(b, document, &edition, program);
    matc_program_free(program);
}

void batch_compile_material(Batch *b, int number, int material)
{
    BatchDocument *document = &b->documents[number];
    BatchMaterial *own = &document->materials[material];
    for (int request = 0; request < b->request_count; request++) {
        Unit *unit = &own->units[request];
        unit->document = number;
        unit->material = material;
        unit->request = request;
        if (document->stored)
            stored_request(b, document, unit);
        else
            compile_request(b, document, own, unit);
    }
}

void batch_compile_again(Batch *b, BatchDocument *document, BatchProgram *again)
{
    const BatchEdition edition = {again->first, again->members, again->name};
    if (batch_stored_program(b, document, &edition))
        return;
    MatcProgram *program = compile(b, document, again->first, again->members);
    if (program)
        write_program(b, document, &edition, program);
    matc_program_free(program);
}
