/* Messages of a batch: diagnostics in the order of the documents, independent of threads. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/diag.h"
#include <stdio.h>
#include <string.h>

/* Prints the diagnostics of completed documents up to the first incomplete one. The caller holds
 * the mutex. */
void batch_say_complete(Batch *b)
{
    for (; b->said < b->document_count && b->documents[b->said].closed; b->said++) {
        Bytes *said = &b->documents[b->said].said;
        bytes_add(said, "", 1);
        if (said->size > 1)
            b->calls->say(b->calls->user, said->at);
        bytes_free(said);
    }
}

/* Appends text, if not empty, to the document's diagnostics. */
void batch_say(Batch *b, BatchDocument *document, const char *text)
{
    if (!*text)
        return;
    pthread_mutex_lock(&b->mutex);
    bytes_add(document ? &document->said : &b->general, text, strlen(text));
    pthread_mutex_unlock(&b->mutex);
}

void batch_say_of(Batch *b, BatchDocument *document, int material, const char *text)
{
    if (!*text)
        return;
    pthread_mutex_lock(&b->mutex);
    bytes_add(&document->materials[material].said, text, strlen(text));
    pthread_mutex_unlock(&b->mutex);
}

/* Appends the diagnostics of a document's materials to the document's own. No thread may work on
 * the document. */
void batch_join_said(BatchDocument *document)
{
    for (int i = 0; i < document->material_count; i++) {
        Bytes *said = &document->materials[i].said;
        bytes_add(&document->said, said->at, said->size);
        bytes_free(said);
    }
}

void batch_fault(Batch *b) { b->fault = true; }

static void say_of_file(Batch *b, BatchDocument *document, Severity severity, const char *what,
                        const char *why)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    diag_complain(&text, b->line->diagnostics, severity, what, why);
    batch_say(b, document, text.at);
    arena_free(&arena);
}

void batch_complain(Batch *b, BatchDocument *document, const char *what, const char *why)
{
    say_of_file(b, document, SEVERITY_error, what, why);
    batch_fault(b);
}

void batch_complain_within(Batch *b, BatchDocument *document, const char *folder, const char *name,
                           const char *why)
{
    const char *slash = *folder && folder[strlen(folder) - 1] == '/' ? "" : "/";
    char path[LONGEST_PATH];
    snprintf(path, sizeof path, "%s%s%s", folder, slash, name);
    batch_complain(b, document, path, why);
}

void batch_warn(Batch *b, const char *what, const char *why)
{
    say_of_file(b, NULL, SEVERITY_warning, what, why);
}

/* Prints diagnostics found after all documents were read. */
void batch_say_rest(Batch *b)
{
    for (int d = 0; d <= b->document_count; d++) {
        if (d < b->document_count)
            batch_join_said(&b->documents[d]);
        Bytes *said = d < b->document_count ? &b->documents[d].said : &b->general;
        bytes_add(said, "", 1);
        if (said->size > 1)
            b->calls->say(b->calls->user, said->at);
    }
}
