/* Two hash tables with 128-bit hashes of contents as keys; each entry counts its users. */
#include "runtime/gpu_material/store.h"
#include "compiler/base/hash.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    BUCKETS = 1024,
    LONGEST_LIST = 32 /* max names of attributes, of outputs, or of captured variables */
};

typedef struct {
    struct Entry *bucket[BUCKETS];
    int count;
} Table;

typedef struct Entry {
    StoreItem item; /* first member, so that a user's pointer is also a pointer to the entry */
    Key key;
    int users;
    Table *table; /* table that contains the entry */
    struct Entry *next;
} Entry;

struct Store {
    GlContext *gl;
    Table programs, textures;
};

Store *store_new(GlContext *gl)
{
    Store *store = calloc(1, sizeof *store);
    if (!store) {
        gl_fail(gl, "out of memory");
        return NULL;
    }
    store->gl = gl;
    return store;
}

GlContext *store_context(const Store *store) { return store->gl; }

int store_program_count(const Store *store) { return store->programs.count; }

int store_texture_count(const Store *store) { return store->textures.count; }

static Entry **bucket_of(Table *table, Key key) { return &table->bucket[key.low % BUCKETS]; }

/* Adds a user to an entry; NULL if missing. */
static const StoreItem *share(Table *table, Key key)
{
    for (Entry *entry = *bucket_of(table, key); entry; entry = entry->next)
        if (key_equal(entry->key, key)) {
            entry->users++;
            return &entry->item;
        }
    return NULL;
}

/* Adds an entry with one user; NULL if memory runs out. */
static const StoreItem *add(Store *store, Table *table, Key key, const StoreItem *item)
{
    Entry *entry = calloc(1, sizeof *entry), **link = bucket_of(table, key);
    if (!entry) {
        gl_fail(store->gl, "out of memory");
        return NULL;
    }
    *entry = (Entry){.item = *item, .key = key, .users = 1, .table = table, .next = *link};
    *link = entry;
    table->count++;
    return &entry->item;
}

static void delete_item(const Store *store, const Table *table, StoreItem *item)
{
    if (table == &store->programs)
        store->gl->DeleteProgram(item->name);
    else
        store->gl->DeleteTextures(1, &item->name);
    uniforms_free(&item->uniforms);
    free(item->held);
}

void store_drop(Store *store, const StoreItem *item)
{
    /* valid because the item is the entry's first member */
    Entry *entry = (Entry *)(uintptr_t)item;
    if (!item || --entry->users > 0)
        return;
    Entry **link = bucket_of(entry->table, entry->key);
    while (*link != entry)
        link = &(*link)->next;
    *link = entry->next;
    entry->table->count--;
    delete_item(store, entry->table, &entry->item);
    free(entry);
}

static void drop_all(Store *store, Table *table)
{
    for (int i = 0; i < BUCKETS; i++)
        while (table->bucket[i]) {
            table->bucket[i]->users = 1;
            store_drop(store, &table->bucket[i]->item);
        }
}

void store_free(Store *store)
{
    if (!store)
        return;
    drop_all(store, &store->programs);
    drop_all(store, &store->textures);
    free(store);
}

static Key key_of_text(const char *text)
{
    return text ? key_of_bytes(text, strlen(text)) : (Key){0, 0};
}

/* Returns the hash of a program: a hash of the hashes of all parts, so that parts are not
 * confused. */
static Key key_of_program(const ProgramText *text)
{
    const char *const *const stages[] = {text->vertex,  text->fragment,   text->compute,
                                         text->control, text->evaluation, text->geometry};
    enum { STAGES = sizeof stages / sizeof *stages, LISTS = STAGES * PROGRAM_PIECES };
    const struct {
        const char *const *names;
        int count;
    } lists[] = {{text->attributes, text->attribute_count},
                 {text->outputs, text->output_count},
                 {text->captured, text->captured_count}};
    enum { LIST_COUNT = sizeof lists / sizeof *lists };
    Key parts[LISTS + LIST_COUNT * LONGEST_LIST] = {{0}};
    for (int stage = 0; stage < STAGES; stage++)
        for (int i = 0; i < PROGRAM_PIECES && stages[stage][i]; i++)
            parts[stage * PROGRAM_PIECES + i] = key_of_text(stages[stage][i]);
    for (int list = 0; list < LIST_COUNT; list++)
        for (int i = 0; i < lists[list].count; i++)
            parts[LISTS + list * LONGEST_LIST + i] = key_of_text(lists[list].names[i]);
    return key_of_bytes(parts, sizeof parts);
}

static bool make_held(const Store *store, StoreItem *program)
{
    program->held = calloc((size_t)program->uniforms.count + 1, sizeof *program->held);
    return program->held || gl_fail(store->gl, "out of memory");
}

const StoreItem *store_program(Store *store, const ProgramText *text)
{
    if (text->attribute_count > LONGEST_LIST || text->output_count > LONGEST_LIST ||
        text->captured_count > LONGEST_LIST) {
        gl_fail(store->gl, "a program of more than %d attributes or outputs", LONGEST_LIST);
        return NULL;
    }
    Key key = key_of_program(text);
    const StoreItem *item = share(&store->programs, key);
    StoreItem made = {0};
    if (item)
        return item;
    made.name = program_make(store->gl, text);
    if (made.name && uniforms_read(store->gl, made.name, &made.uniforms) && make_held(store, &made))
        item = add(store, &store->programs, key, &made);
    if (!item)
        delete_item(store, &store->programs, &made); /* GL ignores the name 0 */
    return item;
}

static Key key_of_texture(const TextureSpec *spec)
{
    const size_t components = (size_t)spec->width * (size_t)spec->height * (size_t)spec->components;
    const int numbers[] = {
        spec->width,  spec->height, spec->components, spec->bytes != NULL, spec->words != NULL,
        spec->linear, spec->wrap,   spec->mipmaps,    spec->format,        spec->anisotropy};
    const Key parts[] = {key_of_bytes(numbers, sizeof numbers),
                         spec->bytes ? key_of_bytes(spec->bytes, components)
                         : spec->words
                             ? key_of_bytes(spec->words, components * sizeof *spec->words)
                             : key_of_bytes(spec->floats, components * sizeof *spec->floats)};
    return key_of_bytes(parts, sizeof parts);
}

const StoreItem *store_texture(Store *store, const TextureSpec *spec)
{
    if (!texture_check(store->gl, spec))
        return NULL;
    Key key = key_of_texture(spec);
    const StoreItem *item = share(&store->textures, key);
    if (item)
        return item;
    StoreItem made = {.name = texture_make(store->gl, spec)};
    item = made.name ? add(store, &store->textures, key, &made) : NULL;
    if (!item)
        delete_item(store, &store->textures, &made);
    return item;
}
