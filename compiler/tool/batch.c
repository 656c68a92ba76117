/* Compiles a batch. All documents' materials are compiled to IR in parallel, and the first
 * material of each program writes its files. Once all programs are known, a program that several
 * materials share with different numbers is rewritten to read these from a uniform block. Only
 * then do files appear in the folder. */
#include "compiler/tool/batch_state.h"
#include "compiler/tool/depfile.h"
#include "compiler/base/diag.h"
#include "compiler/base/file.h"
#include "compiler/tool/layout_option.h"
#include "compiler/base/output.h"
#include "compiler/base/queue.h"
#include "compiler/base/watch.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char manifest_name[] = "manifest.json", depfile_name[] = "manifest.d";

/* -- The queue's callbacks: first for all materials, then for programs to be rewritten */

static void put_tree(Batch *b, BatchDocument *document)
{
    batch_document_parsed(b, document);
    const char *text = matc_tree_text(document->parsed);
    for (int i = 0; i < document->material_count; i++)
        batch_put_file(b, document,
                       (BatchFile){document->materials[i].name, emit_table[EMIT_tree].suffix}, text,
                       strlen(text));
}

static int open_to_compile(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (!batch_open(b, document))
        return 0;
    batch_stored_key(b, document);
    if (!batch_stored_document(b, document) && !batch_document_list(b, document))
        return 0;
    if (b->line->emit[EMIT_tree])
        put_tree(b, document);
    return document->material_count;
}

static void work_on_material(void *user, int number, int material)
{
    batch_compile_material(user, number, material);
}

static void close_compiled(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    batch_join_reports(document);
    batch_store_document(b, document);
    batch_close(document);
    pthread_mutex_lock(&b->mutex);
    document->closed = true;
    b->closed++;
    if (b->calls->progress)
        b->calls->progress(b->calls->user, b->closed, b->document_count);
    batch_report_complete(b);
    pthread_mutex_unlock(&b->mutex);
}

static int open_again(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (!document->again_count || !batch_open(b, document))
        return 0;
    Key before = document->key;
    batch_stored_key(b, document);
    if (key_equal(before, document->key))
        return document->again_count;
    batch_complain(b, document, document->path, "the file changed while it was compiled");
    return 0;
}

static void work_again(void *user, int number, int part)
{
    Batch *b = user;
    batch_compile_again(b, &b->documents[number], &b->programs[b->documents[number].again[part]]);
}

static void close_again(void *user, int number)
{
    Batch *b = user;
    batch_store_document(b, &b->documents[number]);
    batch_close(&b->documents[number]);
}

/* Drops files that were written for a material other than the one that names the program. */
static void drop_files(Batch *b)
{
    char name[LONGEST_NAME], file[LONGEST_NAME + 16];
    for (int i = 0; i < b->program_count; i++)
        for (Unit *unit = b->programs[i].first; unit; unit = unit->next) {
            if (!unit->written || unit == b->programs[i].first)
                continue;
            batch_name(b, unit, name);
            for (int emit = 0; emit < EMIT_COUNT; emit++) {
                snprintf(file, sizeof file, "%s%s", name, options_emit_suffix(&b->options, emit));
                if (b->line->emit[emit] && batch_is_of_program(emit))
                    staging_drop(b->staging, file);
            }
        }
}

/* Returns true if a file name of the material in some pass is also used by another material. */
static bool meets_other(const Batch *b, const BatchMaterial *material, StringSet *names)
{
    char name[LONGEST_NAME], earlier[LONGEST_NAME];
    bool added, met = false;
    for (int t = 0; t < b->request_count && !met; t++) {
        const Unit *unit = &material->units[t];
        batch_name(b, unit, name);
        string_set_add(names, name, &added);
        met = !added;
        /* two passes of a material can have the same program */
        for (int before = 0; before < t && met; before++) {
            batch_name(b, &material->units[before], earlier);
            met = strcmp(name, earlier) != 0;
        }
    }
    return met;
}

static bool is_utf8(const char *name)
{
    const unsigned char *at = (const unsigned char *)name, *end = at + strlen(name);
    while (at < end && text_utf8_length(at, end))
        at += text_utf8_length(at, end);
    return at == end;
}

/* Reports a batch without any material: files of definitions are documents, but cannot be
 * compiled alone. */
static void need_material(Batch *b)
{
    int materials = 0;
    for (int d = 0; d < b->document_count; d++)
        materials += b->documents[d].material_count;
    if (!materials)
        batch_complain(b, NULL, NULL, "no document has a material to compile");
}

/* Reports materials of equal name, which would overwrite each other's files. */
static void check_names(Batch *b)
{
    StringSet materials = {0}, files = {0};
    for (int d = 0; d < b->document_count; d++)
        for (int m = 0; m < b->documents[d].material_count; m++) {
            bool added;
            const BatchMaterial *material = &b->documents[d].materials[m];
            string_set_add(&materials, material->name, &added);
            if (!is_utf8(material->name))
                batch_complain(b, &b->documents[d], material->name,
                               "the material's name is not UTF-8, which a manifest requires");
            else if (!added)
                batch_complain(b, &b->documents[d], material->name, "two materials have this name");
            else if (b->request_count > 1 && meets_other(b, material, &files))
                batch_complain(b, &b->documents[d], material->name,
                               "a program of this material and one of another have the same name");
            else if (b->line->emit[EMIT_reflect] && !strcmp(material->name, "manifest"))
                batch_complain(b, &b->documents[d], "manifest",
                               "the manifest has this name; rename the material");
        }
    string_set_free(&materials);
    string_set_free(&files);
}

/* Returns the manifest's path, for messages and for make. */
static void manifest_path(const Batch *b, char path[LONGEST_PATH])
{
    snprintf(path, LONGEST_PATH, "%s/%s", b->line->folder, manifest_name);
}

static void write_manifest(Batch *b)
{
    Bytes json = {0};
    manifest_put(b, &json);
    const char *why = staging_put_index(b->staging, manifest_name, json.at, json.size);
    if (why)
        batch_complain_within(b, NULL, b->line->folder, manifest_name, why);
    bytes_free(&json);
}

/* Writes the depfile into the folder, or to the path of -MF. */
static const char *put_depfile(Batch *b, const char *text)
{
    return b->line->depfile ? outputs_put(&b->folders, b->line->depfile, text, strlen(text))
                            : staging_put(b->staging, depfile_name, text, strlen(text));
}

/* Writes the depfile: the manifest depends on all documents, their included files, and the
 * lists. */
static void write_depfile(Batch *b)
{
    StringSet files = {0};
    char target[LONGEST_PATH];
    manifest_path(b, target);
    batch_inputs(b, &files);
    const char *bad, *made = b->line->target ? b->line->target : target;
    char *text = depfile_text(made, (const char *const *)files.at, files.count, &bad);
    const char *why = text ? put_depfile(b, text) : depfile_why;
    if (why && text && !b->line->depfile)
        batch_complain_within(b, NULL, b->line->folder, depfile_name, why);
    else if (why)
        batch_complain(b, NULL, text ? b->line->depfile : bad, why);
    free(text);
    string_set_free(&files);
}

/* Commits the files, and removes files of the previous batch that are no longer written. */
static void commit(Batch *b)
{
    const char *why = NULL;
    char *old = staging_holds(b->staging, manifest_name)
                    ? staging_read(b->staging, manifest_name, &why)
                    : NULL;
    if (why)
        batch_complain_within(b, NULL, b->line->folder, manifest_name, why);
    if (old) /* NULL: the manifest is unchanged, or no manifest existed */
        manifest_remove_stale(b, old);
    free(old);
    why = b->fault ? NULL : outputs_commit(&b->folders);
    if (why)
        batch_complain(b, NULL, b->line->folder, why);
}

/* Selects where constants are stored: as requested, otherwise as needs fewer programs. */
static void choose_numbers(Batch *b)
{
    static const char *const modes[] = {
        [NUMBERS_baked] = "baked", [NUMBERS_uniform] = "uniform", [NUMBERS_auto] = "auto"};
    const char *asked = b->line->compile.constants;
    b->numbers = NUMBERS_auto;
    for (int i = 0; asked && i <= NUMBERS_auto; i++)
        if (!strcmp(asked, modes[i]))
            b->numbers = (Numbers)i;
    b->options.constants = modes[b->numbers];
}

/* Selects the outputs that are written for each program. */
static void choose_outputs(Batch *b)
{
    b->request_count = b->line->pass_count;
    for (int i = 0; i < b->request_count; i++)
        b->requests[i] = b->line->passes[i];
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        if (b->line->emit[emit] && batch_is_of_program(emit))
            b->outputs |= options_emit_outputs(&b->options, emit);
    b->outputs |= b->outputs ? 0 : MATC_FRAGMENT;
    b->options.compute = b->line->emit[EMIT_compute];
}

static void take_documents(Batch *b)
{
    b->document_count = b->line->input_count;
    b->documents = sets_resize(NULL, (size_t)b->document_count * sizeof *b->documents);
    memset(b->documents, 0, (size_t)b->document_count * sizeof *b->documents);
    for (int i = 0; i < b->document_count; i++) {
        b->documents[i].path = b->line->inputs[i];
        pthread_mutex_init(&b->documents[i].mutex, NULL);
    }
}

/* Opens the output folders. Returns false after reporting a folder that cannot be opened. */
static bool open_folders(Batch *b)
{
    const char *textures = b->line->textures, *why = NULL;
    if (textures)
        b->textures = outputs_open(&b->folders, textures, STAGING_new_folder, &why);
    if (textures && !b->textures)
        batch_complain(b, NULL, textures, why);
    else if (!(b->staging = outputs_open(&b->folders, b->line->folder, STAGING_new_folder, &why)))
        batch_complain(b, NULL, b->line->folder, why);
    return b->staging != NULL;
}

static bool start(Batch *b, const CommandLine *line, const BatchCalls *calls)
{
    *b = (Batch){.line = line, .calls = calls, .options = line->compile};
    pthread_mutex_init(&b->mutex, NULL);
    choose_numbers(b);
    b->options.linked = b->linked = matc_linked_new();
    b->options.pass = NULL; /* each request sets its own pass */
    choose_outputs(b);
    take_documents(b);
    return open_folders(b) && batch_stored_open(b);
}

/* Lists files for --watch: all that determined the outcome, including faults. */
static void list_watched(const Batch *b)
{
    StringSet files = {0};
    for (int d = 0; b->line->watched && d < b->document_count; d++) {
        const BatchDocument *document = &b->documents[d];
        string_set_add(&files, document->path, NULL);
        for (int i = 0; i < document->depend_count; i++)
            string_set_add(&files, document->depends[i], NULL);
    }
    for (int i = 0; i < files.count; i++)
        watch_list_add(b->line->watched, files.at[i]);
    string_set_free(&files);
}

static void finish(Batch *b)
{
    for (int d = 0; d < b->document_count; d++)
        batch_document_free(&b->documents[d], b->request_count);
    for (int i = 0; i < b->program_count; i++) {
        free(b->programs[i].members);
        free(b->programs[i].name);
    }
    free(b->documents);
    free(b->programs);
    key_set_free(&b->seen);
    string_set_free(&b->files);
    string_set_free(&b->within);
    free(b->file_keys);
    bytes_free(&b->general);
    matc_layout_free(b->layout);
    matc_linked_free(b->linked);
    outputs_close(&b->folders);
    pthread_mutex_destroy(&b->mutex);
}

static void count(const Batch *b, BatchResult *result)
{
    *result = (BatchResult){.documents = b->document_count,
                            .programs = b->program_count,
                            .written = staging_written(b->staging)};
    for (int d = 0; d < b->document_count; d++)
        result->materials += b->documents[d].material_count;
    for (int i = 0; i < b->program_count; i++) {
        result->passes[b->programs[i].first->pass]++;
        result->buffered += b->programs[i].members != NULL ||
                            (b->numbers == NUMBERS_uniform && b->programs[i].first->count);
    }
}

bool batch_run(const CommandLine *line, const BatchCalls *calls, BatchResult *result)
{
    Batch b;
    *result = (BatchResult){0};
    bool started = start(&b, line, calls);
    if (started)
        batch_make_layout(&b);
    if (started)
        batch_phase(&b, open_to_compile, work_on_material, close_compiled);
    if (!b.fault)
        need_material(&b);
    if (!b.fault) {
        batch_group(&b);
        check_names(&b);
        drop_files(&b);
    }
    if (!b.fault)
        batch_phase(&b, open_again, work_again, close_again);
    if (!b.fault) {
        batch_write_layout(&b);
        write_manifest(&b);
        batch_spare_inputs(&b);
    }
    if (!b.fault && line->depend)
        write_depfile(&b);
    if (!b.fault)
        commit(&b);
    if (!b.fault)
        count(&b, result);
    batch_report_rest(&b);
    list_watched(&b);
    const char *trouble = b.cache ? cache_trouble(b.cache) : NULL;
    if (trouble)
        b.calls->trouble(b.calls->user, line->cache, trouble);
    cache_close(b.cache);
    bool fine = !b.fault;
    finish(&b);
    return fine;
}
