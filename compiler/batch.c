/* A batch: every document's materials are compiled to IR, side by side; the first of each program writes it; when all are known,
 * programs that several materials share with different numbers are written again with those in a buffer. Only then do files
 * appear in the folder. */
#include "batch_state.h"
#include "document.h"
#include "file.h"
#include "layout_option.h"
#include "output.h"
#include "queue.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LONGEST_PATH = 4096 };
static const char manifest_name[] = "manifest.json";

Unit *batch_unit(const Batch *b, int document, int material, int turn)
{
    return &b->documents[document].materials[material].units[turn];
}

void batch_name(const Batch *b, const Unit *unit, char name[LONGEST_NAME])
{
    const char *material = b->documents[unit->document].names[unit->material];
    bool plain = b->turn_count == 1 || unit->pass == PASS_gbuffer;
    snprintf(name, LONGEST_NAME, "%s%s%s", material, plain ? "" : ".", plain ? "" : pass_table[unit->pass].name);
}

/* Diagnostics up to the first document that is not done. The mutex is held. */
static void say_complete(Batch *b)
{
    for (; b->said < b->document_count && b->documents[b->said].closed; b->said++) {
        Bytes *said = &b->documents[b->said].said;
        bytes_add(said, "", 1);
        if (said->size > 1)
            b->calls->say(b->calls->user, said->at);
        bytes_free(said);
    }
}

/* Adds to what is said of the document, if it is anything. */
static void add_said(Batch *b, BatchDocument *document, const char *text)
{
    if (!*text || !strcmp(text, "[]\n"))
        return;
    pthread_mutex_lock(&b->mutex);
    bytes_add(document ? &document->said : &b->general, text, strlen(text));
    pthread_mutex_unlock(&b->mutex);
}

static void set_fault(Batch *b, BatchDocument *document)
{
    pthread_mutex_lock(&b->mutex);
    b->fault = true;
    if (document)
        document->fault = true;
    pthread_mutex_unlock(&b->mutex);
}

void batch_complain(Batch *b, BatchDocument *document, const char *what, const char *why)
{
    char text[LONGEST_PATH + 256];
    snprintf(text, sizeof text, "matc: error: %s: %s\n", what, why);
    add_said(b, document, text);
    set_fault(b, document);
}

static const char *suffix_of(const Batch *b, int emit)
{
    bool spirv = emit == EMIT_glsl && b->options.target && !strcmp(b->options.target, "spirv");
    return emit_table[spirv ? EMIT_spirv : emit].suffix;
}

static MatcOutput output_of(const Batch *b, int emit)
{
    bool spirv = emit == EMIT_glsl && b->options.target && !strcmp(b->options.target, "spirv");
    return spirv ? MATC_SPIRV : (MatcOutput)emit_table[emit].output;
}

/* An output that every program has a file of. */
static bool is_of_program(int emit) { return emit != EMIT_unpack && emit != EMIT_tree; }

static void put_file(Batch *b, BatchDocument *document, const char *base, const char *suffix, const char *bytes,
                     size_t size)
{
    char name[LONGEST_NAME + 16];
    snprintf(name, sizeof name, "%s%s", base, suffix);
    const char *why = stage_put(b->stage, name, bytes, size);
    if (why)
        batch_complain(b, document, name, why);
}

bool batch_write(Batch *b, BatchDocument *document, Unit *unit, MatcProgram *program, const char *base)
{
    bool fine = matc_emit(program, b->outputs);
    add_said(b, document, matc_program_diagnostics(program, b->line->diagnostics));
    if (!fine) {
        set_fault(b, document);
        return false;
    }
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        size_t size;
        if (!b->line->emit[emit] || !is_of_program(emit))
            continue;
        const char *text = matc_output(program, output_of(b, emit), &size);
        put_file(b, document, base, suffix_of(b, emit), text, size);
    }
    written_free(unit->written);
    unit->written = unit_written(program, b->numbers == NUMBERS_uniform);
    return true;
}

/* True for whoever asks first. */
static bool first_of_program(Batch *b, const Unit *unit)
{
    bool added;
    pthread_mutex_lock(&b->mutex);
    keys_add(&b->seen, b->numbers == NUMBERS_auto ? unit->shape : unit->key, &added);
    pthread_mutex_unlock(&b->mutex);
    return added;
}

/* Textures that matc makes: those of the material by its name, tables of noise by their own. */
static void write_textures(Batch *b, BatchDocument *document, const char *material, MatcProgram *program)
{
    char name[2 * LONGEST_NAME];
    for (int i = 0; b->textures && i < matc_texture_count(program); i++) {
        const MatcTexture *texture = matc_texture(program, i);
        bool table = !strncmp(texture->name, "matc_", 5);
        size_t size;
        if (texture->path)
            continue;
        snprintf(name, sizeof name, "%s%s%s.ktx", table ? "" : material, table ? "" : ".", texture->name);
        char *bytes = output_ktx(texture, &size);
        const char *why = stage_put(b->textures, name, bytes, size);
        free(bytes);
        if (why)
            batch_complain(b, document, name, why);
    }
}

static MatcOptions options_for(const Batch *b, int turn)
{
    MatcOptions options = b->options;
    options.pass = b->turns[turn];
    return options;
}

static void compile_turn(Batch *b, int number, int material, int turn)
{
    BatchDocument *document = &b->documents[number];
    BatchMaterial *own = &document->materials[material];
    Unit *unit = &own->units[turn];
    MatcOptions options = options_for(b, turn);
    char name[LONGEST_NAME], textures[LONGEST_PATH];
    *unit = (Unit){.document = number, .material = material, .turn = turn};
    if (b->line->max_error &&
        !b->calls->choose(b->calls->user, document->document, document->offset + material, &options)) {
        set_fault(b, document);
        return;
    }
    MatcProgram *program = matc_compile(document->document, document->offset + material, MATC_KEY, &options);
    if (!matc_ok(program)) {
        add_said(b, document, matc_program_diagnostics(program, b->line->diagnostics));
        set_fault(b, document);
        matc_program_free(program);
        return;
    }
    snprintf(textures, sizeof textures, "%s/%s", b->line->textures ? b->line->textures : "", own->name);
    unit_fill(unit, program, b->numbers == NUMBERS_uniform, b->textures ? textures : NULL);
    if (!turn)
        own->opacity = matc_opacity(program);
    bool first = first_of_program(b, unit);
    batch_name(b, unit, name);
    if (first)
        batch_write(b, document, unit, program, name);
    if (first || b->textures)
        write_textures(b, document, own->name, program);
    matc_program_free(program);
}

/* -- the queue's calls: first all materials, then what must be written again */

static void compile_material(void *user, int number, int material)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (b->line->emit[EMIT_tree] && !material) {
        const char *text = matc_tree_text(document->document);
        for (int i = 0; i < document->material_count; i++)
            put_file(b, document, document->names[i], emit_table[EMIT_tree].suffix, text, strlen(text));
    }
    for (int turn = 0; turn < b->turn_count; turn++)
        compile_turn(b, number, material, turn);
}

static bool parse_document(Batch *b, BatchDocument *document)
{
    size_t size;
    const char *why;
    bool standard = !strcmp(document->path, "-");
    char *text = standard ? file_read_from(STDIN_FILENO, &size, &why) : file_read(document->path, &size, &why);
    if (!text) {
        batch_complain(b, document, document->path, why);
        return false;
    }
    document->document = matc_read(standard ? "<stdin>" : document->path, text, size, &b->options);
    free(text);
    return true;
}

static void list_materials(BatchDocument *document)
{
    int count = document->material_count;
    document->materials = sets_resize(NULL, (size_t)count * sizeof *document->materials);
    document->names = sets_resize(NULL, (size_t)count * sizeof *document->names);
    memset(document->materials, 0, (size_t)count * sizeof *document->materials);
    for (int i = 0; i < count; i++)
        document->materials[i].name = document->names[i] =
            sets_copy(matc_material_name(document->document, document->offset + i));
    document->depend_count = matc_depend_count(document->document);
    document->depends = sets_resize(NULL, (size_t)document->depend_count * sizeof *document->depends);
    for (int i = 0; i < document->depend_count; i++)
        document->depends[i] = sets_copy(matc_depend(document->document, i));
}

/* All of the document, or the one that is asked for. */
static int count_materials(Batch *b, BatchDocument *document)
{
    const char *wanted = b->line->material;
    document->material_count = matc_material_count(document->document);
    if (!wanted || !document->material_count)
        return document->material_count;
    document->offset = matc_material_find(document->document, wanted);
    document->material_count = document->offset >= 0;
    if (document->offset < 0)
        batch_complain(b, document, wanted, "no such material in the document");
    return document->material_count;
}

static int open_to_compile(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (!parse_document(b, document))
        return 0;
    add_said(b, document, matc_diagnostics(document->document, b->line->diagnostics));
    if (!count_materials(b, document))
        set_fault(b, document);
    list_materials(document);
    return document->material_count;
}

static void close_compiled(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    matc_document_free(document->document);
    document->document = NULL;
    pthread_mutex_lock(&b->mutex);
    document->closed = true;
    b->closed++;
    if (b->calls->progress)
        b->calls->progress(b->calls->user, b->closed, b->document_count);
    say_complete(b);
    pthread_mutex_unlock(&b->mutex);
}

static int open_again(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (!document->again_count || !parse_document(b, document))
        return 0;
    if (matc_material_count(document->document) >= document->offset + document->material_count)
        return document->again_count;
    batch_complain(b, document, document->path, "it changed while it was compiled");
    return 0;
}

static void write_again(void *user, int number, int part)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    BatchProgram *made = &b->programs[document->again[part]];
    Unit *unit = made->first;
    MatcOptions options = options_for(b, unit->turn);
    if (b->line->max_error &&
        !b->calls->choose(b->calls->user, document->document, document->offset + unit->material, &options))
        return;
    if (made->members) {
        options.members = made->members;
        options.member_count = unit->count;
    }
    MatcProgram *program = matc_compile(document->document, document->offset + unit->material, MATC_KEY, &options);
    if (matc_ok(program))
        batch_write(b, document, unit, program, made->name);
    else
        batch_complain(b, document, document->path, "it changed while it was compiled");
    matc_program_free(program);
}

static void close_again(void *user, int number)
{
    Batch *b = user;
    matc_document_free(b->documents[number].document);
    b->documents[number].document = NULL;
}

/* What was written for a material that does not give the program its name. */
static void drop_files(Batch *b)
{
    char name[LONGEST_NAME], file[LONGEST_NAME + 16];
    for (int i = 0; i < b->program_count; i++)
        for (Unit *unit = b->programs[i].first; unit; unit = unit->next) {
            if (!unit->written || unit == b->programs[i].first)
                continue;
            batch_name(b, unit, name);
            for (int emit = 0; emit < EMIT_COUNT; emit++) {
                snprintf(file, sizeof file, "%s%s", name, suffix_of(b, emit));
                if (b->line->emit[emit] && is_of_program(emit))
                    stage_drop(b->stage, file);
            }
        }
}

/* Two materials of one name would overwrite each other. */
static void check_names(Batch *b)
{
    StringSet names = {0};
    for (int d = 0; d < b->document_count; d++)
        for (int m = 0; m < b->documents[d].material_count; m++) {
            bool added;
            strings_add(&names, b->documents[d].names[m], &added);
            if (!added)
                batch_complain(b, &b->documents[d], b->documents[d].names[m], "two materials have this name");
            else if (b->line->emit[EMIT_reflect] && !strcmp(b->documents[d].names[m], "manifest"))
                batch_complain(b, &b->documents[d], "manifest",
                               "the manifest has this name; call the material otherwise");
        }
    strings_free(&names);
    for (int i = 0; !b->fault && i < b->program_count; i++) {
        bool added;
        strings_add(&names, b->programs[i].name, &added);
        if (!added)
            batch_complain(b, &b->documents[b->programs[i].first->document], b->programs[i].name,
                           "two programs have this name");
    }
    strings_free(&names);
}

static void run_phase(Batch *b, int (*open)(void *, int), void (*work)(void *, int, int), void (*close)(void *, int))
{
    int threads = b->line->max_error ? 1 : b->line->threads ? b->line->threads : queue_processors();
    const Queue queue = {b->document_count, threads, open, work, close, b};
    queue_run(&queue);
}

/* One file for all programs: the layout is theirs. */
static void write_unpack(Batch *b)
{
    for (int i = 0; b->line->emit[EMIT_unpack] && i < b->program_count; i++) {
        const BatchProgram *program = &b->programs[i];
        BatchDocument *document = &b->documents[program->first->document];
        if (program->first->pass != PASS_gbuffer && program->first->pass != PASS_plane)
            continue;
        Arena arena = {0};
        Compile c = compile_with(&b->options, &arena);
        Job job;
        job_of(&b->options, &job);
        const char *text = emit_unpack(&c, &job);
        put_file(b, document, job.layout->name, emit_table[EMIT_unpack].suffix, text, strlen(text));
        arena_free(&arena);
        return;
    }
}

/* Where the manifest is, for what is said and for make. */
static void manifest_path(const Batch *b, char path[LONGEST_PATH])
{
    snprintf(path, LONGEST_PATH, "%s/%s", b->line->folder, manifest_name);
}

static void write_manifest(Batch *b)
{
    Arena arena = {0};
    const char *text = manifest_text(b, &arena), *why = stage_put(b->stage, manifest_name, text, strlen(text));
    if (why)
        batch_complain(b, NULL, manifest_name, why);
    arena_free(&arena);
}

/* The manifest depends on all documents, on what they are made from, and on the lists. */
static void write_depfile(Batch *b)
{
    StringSet files = {0};
    char target[LONGEST_PATH], path[LONGEST_PATH + 8];
    manifest_path(b, target);
    snprintf(path, sizeof path, "%s/manifest.d", b->line->folder);
    for (int d = 0; d < b->document_count; d++)
        for (int i = 0; i < b->documents[d].depend_count; i++)
            strings_add(&files, b->documents[d].depends[i], NULL);
    for (int i = 0; i < b->line->list_count; i++)
        strings_add(&files, b->line->lists[i], NULL);
    if (b->line->compile.layout && layout_is_file(b->line->compile.layout))
        strings_add(&files, b->line->compile.layout, NULL);
    const char *depfile = b->line->depfile ? b->line->depfile : path;
    const char *why =
        output_depfile(depfile, b->line->target ? b->line->target : target, (const char *const *)files.at, files.count);
    if (why)
        batch_complain(b, NULL, depfile, why);
    strings_free(&files);
}

/* All is well: the files appear, and those of the last batch that are no longer made go. */
static void commit(Batch *b)
{
    char path[LONGEST_PATH];
    const char *why = NULL;
    size_t size;
    manifest_path(b, path);
    char *old = file_read(path, &size, &why);
    why = b->textures ? stage_commit(b->textures) : NULL;
    if (!why)
        why = stage_commit(b->stage);
    if (why)
        batch_complain(b, NULL, b->line->folder, why);
    else if (old)
        manifest_remove_stale(b, old);
    free(old);
    if (b->line->depend && !why)
        write_depfile(b);
}

static bool start(Batch *b, const CommandLine *line, const BatchCalls *calls)
{
    static const char *const modes[] = {
        [NUMBERS_baked] = "baked", [NUMBERS_uniform] = "uniform", [NUMBERS_auto] = "auto"};
    const char *why = NULL;
    *b = (Batch){.line = line, .calls = calls, .numbers = NUMBERS_auto, .options = line->compile};
    pthread_mutex_init(&b->mutex, NULL);
    for (int i = 0; line->compile.constants && i <= NUMBERS_auto; i++)
        if (!strcmp(line->compile.constants, modes[i]))
            b->numbers = (Numbers)i;
    b->options.constants = modes[b->numbers];
    b->options.pass = NULL; /* each turn has its own */
    b->turn_count = line->pass_count;
    for (int i = 0; i < line->pass_count; i++)
        b->turns[i] = line->passes[i];
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        if (line->emit[emit] && is_of_program(emit))
            b->outputs |= output_of(b, emit);
    b->outputs |= b->outputs ? 0 : MATC_FRAGMENT;
    b->document_count = line->input_count;
    b->documents = sets_resize(NULL, (size_t)b->document_count * sizeof *b->documents);
    memset(b->documents, 0, (size_t)b->document_count * sizeof *b->documents);
    for (int i = 0; i < b->document_count; i++)
        b->documents[i].path = line->inputs[i];
    b->stage = stage_open(line->folder, &why);
    if (b->stage && line->textures)
        b->textures = stage_open(line->textures, &why);
    if (why)
        batch_complain(b, NULL, b->stage ? line->textures : line->folder, why);
    return !why;
}

static void free_document(BatchDocument *document, int turns)
{
    for (int m = 0; m < document->material_count; m++) {
        for (int t = 0; t < turns; t++)
            unit_free(&document->materials[m].units[t]);
        free(document->names[m]);
    }
    for (int i = 0; i < document->depend_count; i++)
        free(document->depends[i]);
    free(document->depends);
    free(document->names);
    free(document->materials);
    free(document->again);
    bytes_free(&document->said);
}

static void finish(Batch *b)
{
    for (int d = 0; d < b->document_count; d++)
        free_document(&b->documents[d], b->turn_count);
    for (int i = 0; i < b->program_count; i++) {
        free(b->programs[i].members);
        free(b->programs[i].name);
    }
    free(b->documents);
    free(b->programs);
    keys_free(&b->seen);
    bytes_free(&b->general);
    stage_close(b->stage);
    stage_close(b->textures);
    pthread_mutex_destroy(&b->mutex);
}

/* What was found when all documents were known. */
static void say_rest(Batch *b)
{
    for (int d = 0; d <= b->document_count; d++) {
        Bytes *said = d < b->document_count ? &b->documents[d].said : &b->general;
        bytes_add(said, "", 1);
        if (said->size > 1)
            b->calls->say(b->calls->user, said->at);
    }
}

static void count(const Batch *b, BatchResult *result)
{
    *result =
        (BatchResult){.documents = b->document_count, .programs = b->program_count, .written = stage_written(b->stage)};
    for (int d = 0; d < b->document_count; d++)
        result->materials += b->documents[d].material_count;
    for (int i = 0; i < b->program_count; i++) {
        result->passes[b->programs[i].first->pass]++;
        result->buffered +=
            b->programs[i].members != NULL || (b->numbers == NUMBERS_uniform && b->programs[i].first->count);
    }
}

bool batch_run(const CommandLine *line, const BatchCalls *calls, BatchResult *result)
{
    Batch b;
    *result = (BatchResult){0};
    if (start(&b, line, calls))
        run_phase(&b, open_to_compile, compile_material, close_compiled);
    if (!b.fault) {
        batch_group(&b);
        check_names(&b);
        drop_files(&b);
    }
    if (!b.fault)
        run_phase(&b, open_again, write_again, close_again);
    if (!b.fault) {
        write_unpack(&b);
        write_manifest(&b);
    }
    if (!b.fault)
        commit(&b);
    if (!b.fault)
        count(&b, result);
    say_rest(&b);
    bool fine = !b.fault;
    finish(&b);
    return fine;
}
