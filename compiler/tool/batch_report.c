/* Messages of a batch: diagnostics in the order of the documents, independent of threads. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/diag.h"
#include <stdio.h>
#include <string.h>

/* Prints the diagnostics of completed documents up to the first incomplete one. The caller holds
 * the mutex. */
void batch_report_complete(Batch *b)
{
    for (; b->reported < b->document_count && b->documents[b->reported].closed; b->reported++) {
        Bytes *reported = &b->documents[b->reported].reported;
        bytes_add(reported, "", 1);
        if (reported->size > 1)
            b->calls->say(b->calls->user, reported->at);
        bytes_free(reported);
    }
}

/* Appends text, if not empty, to the document's diagnostics. */
void batch_report(Batch *b, BatchDocument *document, const char *text)
{
    if (!*text)
        return;
    pthread_mutex_lock(&b->mutex);
    bytes_add(document ? &document->reported : &b->general, text, strlen(text));
    pthread_mutex_unlock(&b->mutex);
}

void batch_report_of(Batch *b, BatchDocument *document, int material, const char *text)
{
    if (!*text)
        return;
    pthread_mutex_lock(&b->mutex);
    bytes_add(&document->materials[material].reported, text, strlen(text));
    pthread_mutex_unlock(&b->mutex);
}

/* Appends the diagnostics of a document's materials to the document's own. No thread may work on
 * the document. */
void batch_join_reports(BatchDocument *document)
{
    for (int i = 0; i < document->material_count; i++) {
        Bytes *reported = &document->materials[i].reported;
        bytes_add(&document->reported, reported->at, reported->size);
        bytes_free(reported);
    }
}

void batch_fault(Batch *b) { b->fault = true; }

static void report_of_file(Batch *b, BatchDocument *document, Severity severity, const char *what,
                           const char *why)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    diag_complain(&text, b->line->diagnostics, severity, what, why);
    batch_report(b, document, text.at);
    arena_free(&arena);
}

void batch_complain(Batch *b, BatchDocument *document, const char *what, const char *why)
{
    report_of_file(b, document, SEVERITY_error, what, why);
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
    report_of_file(b, NULL, SEVERITY_warning, what, why);
}

/* Prints diagnostics found after all documents were read. */
void batch_report_rest(Batch *b)
{
    for (int d = 0; d <= b->document_count; d++) {
        if (d < b->document_count)
            batch_join_reports(&b->documents[d]);
        Bytes *reported = d < b->document_count ? &b->documents[d].reported : &b->general;
        bytes_add(reported, "", 1);
        if (reported->size > 1)
            b->calls->say(b->calls->user, reported->at);
    }
}
