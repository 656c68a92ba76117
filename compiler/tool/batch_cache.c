/* Cache entries of a batch. A document's entry lists its included files with their content
 * hashes, its materials, and their programs. Its key is a hash of the text, the options and the
 * compiler itself, so an entry is never used for other input. A program's entry holds its files
 * under the hash of their bytes, so equal programs of any documents are stored once. */
#include "compiler/tool/batch_state.h"
#include "compiler/tool/build_id.h"
#include "compiler/choice.h"
#include "compiler/base/root.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEFAULT_LIMIT_MIB = 1024, ENTRY_VERSION = 3 };

/* Records a file's content hash at its first read. A file that changes during the batch is
 * reported, since materials of two versions would not be one set. */
static void note_file(Batch *b, const char *path, Key key)
{
    bool added;
    pthread_mutex_lock(&b->mutex);
    int number = string_set_add(&b->files, path, &added);
    if (added) {
        b->file_keys = sets_resize(b->file_keys, (size_t)b->files.capacity * sizeof *b->file_keys);
        b->file_keys[number] = key;
    }
    bool same = key_equal(b->file_keys[number], key);
    pthread_mutex_unlock(&b->mutex);
    if (!same)
        batch_complain(b, NULL, path, "the file changed while it was compiled");
}

static bool known_file(Batch *b, const char *path, Key *key)
{
    pthread_mutex_lock(&b->mutex);
    int number = string_set_find(&b->files, path);
    if (number >= 0)
        *key = b->file_keys[number];
    pthread_mutex_unlock(&b->mutex);
    return number >= 0;
}

/* MatcReadFile callback: reads an included file and records its hash. */
static char *read_noted(void *user, const char *path, size_t *size, const char **why)
{
    char *text = root_read(((const Batch *)user)->options.root, path, size, why);
    if (text)
        note_file(user, path, key_of_bytes(text, *size));
    return text;
}

/* Returns false if the file cannot be read. */
static bool file_key(Batch *b, const char *path, Key *key)
{
    size_t size;
    const char *why;
    if (known_file(b, path, key))
        return true;
    char *text = read_noted(b, path, &size, &why);
    free(text);
    return text && known_file(b, path, key);
}

bool batch_stored_open(Batch *b)
{
    const char *why = NULL;
    const CommandLine *line = b->line;
    b->options.read_file = read_noted;
    b->options.user = b;
    if (!line->cache || b->textures || line->max_error || line->emit[EMIT_tree])
        return true; /* outputs of these options are not cached */
    b->cache = cache_open(
        line->cache, (uint64_t)(line->cache_limit ? line->cache_limit : DEFAULT_LIMIT_MIB) << 20,
        &why);
    if (!b->cache)
        batch_complain(b, NULL, line->cache, why);
    return b->cache != NULL;
}

static void put_settings(Bytes *to, const Batch *b)
{
    Key build = build_id_key();
    bytes_number(to, ENTRY_VERSION);
    bytes_add(to, &build, sizeof build);
    choice_store_options(to, &b->options);
    bytes_number(to, (uint32_t)b->line->diagnostics);
    for (int i = 0; i < b->request_count; i++)
        bytes_text(to, b->requests[i]);
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        bytes_number(to, b->line->emit[emit]);
    for (int i = 0; i < b->options.include_count; i++)
        bytes_text(to, b->options.include[i]);
    bytes_number(to, (uint32_t)b->options.include_count);
    bytes_text(to, b->line->material ? b->line->material : "");
    bytes_text(to, b->options.custom ? matc_layout_text((MatcLayout *)b->options.custom) : "");
}

void batch_stored_key(const Batch *b, BatchDocument *document)
{
    Bytes bytes = {0};
    if (!b->cache) { /* stores the hash, so that a later read detects a change */
        document->key = key_of_bytes(document->text, document->size);
        return;
    }
    put_settings(&bytes, b);
    bytes_text(&bytes, document->path);
    bytes_block(&bytes, document->text, document->size);
    document->key = key_of_bytes(bytes.at, bytes.size);
    bytes_free(&bytes);
}

/* Returns true if all files are unchanged. */
static bool same_files(Batch *b, BytesReader *from, int count)
{
    for (int i = 1; i < count; i++) {
        const char *path = bytes_take_text(from);
        const void *then = bytes_take(from, sizeof(Key));
        Key now;
        if (from->broken || !file_key(b, path, &now) || memcmp(&now, then, sizeof now) != 0)
            return false;
    }
    return true;
}

/* Appends the files on which a document depends, with their hashes. Returns false if a file was
 * not recorded, so a change of it would go undetected. */
static bool put_files(Batch *b, char *const *depends, int count, Bytes *to)
{
    bytes_number(to, (uint32_t)count);
    for (int i = 1; i < count; i++) {
        Key key;
        if (!known_file(b, depends[i], &key))
            return false;
        bytes_text(to, depends[i]);
        bytes_add(to, &key, sizeof key);
    }
    return true;
}

bool batch_stored_ranges(Batch *b, BatchDocument *document)
{
    size_t size;
    char *entry = b->cache ? cache_get(b->cache, document->key, &size) : NULL;
    if (!entry)
        return false;
    BytesReader from = {entry, entry + size, false};
    bool same = same_files(b, &from, (int)bytes_take_number(&from));
    const void *ranges = same ? bytes_take(&from, sizeof *document->ranges) : NULL;
    if (ranges)
        memcpy(document->ranges, ranges, sizeof *document->ranges);
    free(entry);
    return ranges != NULL;
}

void batch_store_ranges(Batch *b, const BatchDocument *document)
{
    Bytes to = {0};
    if (!b->cache || !document->parsed || b->fault)
        return;
    int count = matc_depend_count(document->parsed);
    char **depends = sets_resize(NULL, (size_t)count * sizeof *depends);
    for (int i = 0; i < count; i++)
        depends[i] = (char *)matc_depend(document->parsed, i);
    if (put_files(b, depends, count, &to)) {
        bytes_add(&to, document->ranges, sizeof *document->ranges);
        cache_put(b->cache, document->key, to.at, to.size);
    }
    free(depends);
    bytes_free(&to);
}

/* Returns the library's own string for an opacity, which need not be freed. */
static const char *opacity_named(const char *name)
{
    return !strcmp(name, "opaque")        ? "opaque"
           : !strcmp(name, "transparent") ? "transparent"
                                          : "varying";
}

static bool load_document(Batch *b, BatchDocument *document, BytesReader *from)
{
    BytesReader depends = *from;
    int depend_count = (int)bytes_take_number(from);
    if (!same_files(b, from, depend_count))
        return false;
    int count = (int)bytes_take_number(from);
    document->offset = (int)bytes_take_number(from);
    if (from->broken || depend_count < 1)
        return false;
    batch_document_make_capacity(document, count, b->request_count, depend_count);
    bytes_take_number(&depends);
    document->depends[0] = sets_copy(document->path);
    for (int i = 1; i < depend_count; i++) {
        document->depends[i] = sets_copy(bytes_take_text(&depends));
        bytes_take(&depends, sizeof(Key));
    }
    for (int m = 0; m < count; m++) {
        BatchMaterial *material = &document->materials[m];
        material->name = sets_copy(bytes_take_text(from));
        material->opacity = opacity_named(bytes_take_text(from));
        for (int t = 0; t < b->request_count; t++)
            if (!unit_load(from, &material->units[t]))
                return false;
    }
    return true;
}

bool batch_stored_document(Batch *b, BatchDocument *document)
{
    size_t size;
    char *entry = b->cache ? cache_get(b->cache, document->key, &size) : NULL;
    if (!entry)
        return false;
    BytesReader from = {entry, entry + size, false};
    document->stored = load_document(b, document, &from);
    free(entry);
    /* the entry is corrupted in a way that checksums do not detect */
    if (!document->stored && document->materials) {
        int requests = b->request_count;
        Key key = document->key;
        BatchDocument fresh = {
            .path = document->path, .text = document->text, .size = document->size, .key = key};
        pthread_mutex_init(&fresh.mutex, NULL);
        document->text = NULL;
        batch_document_free(document, requests);
        *document = fresh;
    }
    return document->stored;
}

/* Returns true if program files were added that the document's entry does not list. */
static bool has_changed(const BatchDocument *document, int requests)
{
    for (int i = 0; i < document->material_count * requests; i++)
        if (document->units[i].changed)
            return true;
    return false;
}

void batch_store_document(Batch *b, BatchDocument *document)
{
    Bytes to = {0};
    document->spoke |= document->reported.size > 0;
    if (!b->cache || document->spoke || b->fault ||
        (document->stored && !has_changed(document, b->request_count)))
        return;
    if (!put_files(b, document->depends, document->depend_count, &to)) {
        bytes_free(&to);
        return;
    }
    bytes_number(&to, (uint32_t)document->material_count);
    bytes_number(&to, (uint32_t)document->offset);
    for (int m = 0; m < document->material_count; m++) {
        bytes_text(&to, document->materials[m].name);
        bytes_text(&to, document->materials[m].opacity);
        for (int t = 0; t < b->request_count; t++) {
            unit_store(&to, &document->materials[m].units[t]);
            document->materials[m].units[t].changed = false;
        }
    }
    cache_put(b->cache, document->key, to.at, to.size);
    document->stored = true;
    bytes_free(&to);
}

/* Key of the assignment of places to members; zero if no number is in a uniform block. */
static Key members_key(const Unit *unit, const int *members)
{
    return members ? key_of_bytes(members, (size_t)unit->count * sizeof *members) : (Key){0};
}

bool batch_stored_program(Batch *b, BatchDocument *document, const BatchEdition *edition)
{
    Unit *unit = edition->unit;
    size_t size;
    const Key *key = b->cache ? unit_find_files(unit, members_key(unit, edition->members)) : NULL;
    char *entry = key ? cache_get(b->cache, *key, &size) : NULL;
    if (!entry)
        return false;
    BytesReader from = {entry, entry + size, false};
    Written *written = written_load(&from);
    for (int emit = 0; emit < EMIT_COUNT && written; emit++) {
        if (!b->line->emit[emit] || !batch_is_of_program(emit))
            continue;
        const char *text = bytes_take_block(&from, &size);
        if (text)
            batch_put_file(b, document,
                           (BatchFile){edition->base, options_emit_suffix(&b->options, emit)}, text,
                           size);
    }
    free(entry);
    if (from.broken) {
        written_free(written);
        return false;
    }
    written_free(unit->written);
    unit->written = written;
    return written != NULL;
}

void batch_store_program(Batch *b, const BatchEdition *edition, MatcProgram *program)
{
    Unit *unit = edition->unit;
    Bytes to = {0};
    if (!b->cache || b->fault)
        return;
    written_store(&to, unit->written);
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        size_t size;
        if (!b->line->emit[emit] || !batch_is_of_program(emit))
            continue;
        const char *text = options_emit_text(&b->options, emit, program, &size);
        bytes_block(&to, text, size);
    }
    Key key = key_of_bytes(to.at, to.size);
    cache_keep(b->cache, key, to.at, to.size);
    unit_add_files(unit, members_key(unit, edition->members), key);
    bytes_free(&to);
}
