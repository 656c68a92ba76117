/* Functions shared by all parts of a batch: units, names, files, threads. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/queue.h"
#include <stdio.h>

Unit *batch_unit(const Batch *b, int document, int material, int request)
{
    return &b->documents[document].materials[material].units[request];
}

void batch_name(const Batch *b, const Unit *unit, char name[LONGEST_NAME])
{
    const char *material = b->documents[unit->document].materials[unit->material].name;
    bool plain = b->request_count == 1 || unit->pass == PASS_gbuffer;
    snprintf(name, LONGEST_NAME, "%s%s%s", material, plain ? "" : ".",
             plain ? "" : pass_table[unit->pass].name);
}

bool batch_is_of_program(int emit)
{
    return emit != EMIT_unpack && emit != EMIT_layout && emit != EMIT_tree;
}

void batch_put_file(Batch *b, BatchDocument *document, BatchFile file, const char *bytes,
                    size_t size)
{
    char name[LONGEST_NAME + 16];
    snprintf(name, sizeof name, "%s%s", file.base, file.suffix);
    const char *why = staging_put(b->staging, name, bytes, size);
    if (why)
        batch_complain_within(b, document, b->line->folder, name, why);
}

void batch_phase(Batch *b, int (*open)(void *, int), void (*work)(void *, int, int),
                 void (*close)(void *, int))
{
    int threads = b->line->max_error ? 1 : b->line->threads ? b->line->threads : queue_processors();
    const Queue queue = {b->document_count, threads, open, work, close, b};
    queue_run(&queue);
}
