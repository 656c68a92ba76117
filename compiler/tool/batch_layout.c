/* The layout of a batch: with --layout=auto the smallest layout for its materials; and its
 * files. */
#include "compiler/tool/batch_state.h"
#include "compiler/choice.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include "compiler/tool/layout_option.h"
#include "compiler/layout/layout_read.h"
#include <stdlib.h>
#include <string.h>

static int open_to_measure(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (!batch_open(b, document))
        return 0;
    batch_stored_key(b, document);
    document->ranges = sets_resize(NULL, sizeof *document->ranges);
    matc_ranges_init(document->ranges);
    if (batch_stored_ranges(b, document))
        return 0;
    /* ignores the document's faults, which its compilation reports */
    int count = matc_material_count(batch_document_parsed(b, document));
    return count;
}

static void measure_material(void *user, int number, int material)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    MatcRanges own;
    char *fault = NULL;
    const MatcDocument *parsed = batch_document_parsed(b, document);
    if (b->line->material && strcmp(b->line->material, matc_material_name(parsed, material)) != 0)
        return;
    matc_ranges_init(&own);
    bool fine = matc_ranges_add(&own, parsed, material, &b->options, &fault);
    free(fault); /* the fault is reported when the material is compiled */
    pthread_mutex_lock(&document->mutex);
    if (fine)
        matc_ranges_join(document->ranges, &own);
    pthread_mutex_unlock(&document->mutex);
}

static void close_measured(void *user, int number)
{
    Batch *b = user;
    BatchDocument *document = &b->documents[number];
    if (document->ranges) {
        batch_store_ranges(b, document);
        pthread_mutex_lock(&b->mutex);
        matc_ranges_join(&b->ranges, document->ranges);
        pthread_mutex_unlock(&b->mutex);
    }
    free(document->ranges);
    document->ranges = NULL;
    batch_close(document);
}

void batch_make_layout(Batch *b)
{
    if (!b->options.layout || strcmp(b->options.layout, "auto") != 0)
        return;
    matc_ranges_init(&b->ranges);
    batch_phase(b, open_to_measure, measure_material, close_measured);
    b->layout = matc_layout_for(&b->ranges, b->line->layout_error, &b->options);
    if (matc_layout_ok(b->layout)) {
        b->options.custom = b->layout;
        if (b->line->stats)
            batch_report(b, NULL, matc_layout_report(b->layout));
    } else { /* the documents have no materials, as their messages say */
        b->options.layout = NULL;
    }
}

unsigned batch_cases(const Batch *b)
{
    unsigned cases = 0;
    if (b->line->cases && !strcmp(b->line->cases, OPTIONS_CASES_ALL))
        return 0;
    for (int i = 0; i < b->program_count; i++)
        for (const Unit *unit = b->programs[i].first; unit; unit = unit->next)
            cases |= unit->layout_case < 0 ? 0 : 1u << unit->layout_case;
    return cases;
}

/* Writes the layout's files once for all programs, which share the layout. */
void batch_write_layout(Batch *b)
{
    for (int i = 0;
         (b->line->emit[EMIT_unpack] || b->line->emit[EMIT_layout]) && i < b->program_count; i++) {
        const BatchProgram *program = &b->programs[i];
        BatchDocument *document = &b->documents[program->first->document];
        if (program->first->pass != PASS_gbuffer && program->first->pass != PASS_plane)
            continue;
        Arena arena = {0};
        Session session = session_open(&b->options, &arena);
        Job job;
        choice_job(&b->options, &job);
        job.cases = batch_cases(b);
        const char *unpack = emit_unpack(&session, &job);
        Text layout = text_new(&arena);
        layout_write(&layout, job.layout);
        if (b->line->emit[EMIT_unpack])
            batch_put_file(b, document,
                           (BatchFile){job.layout->name, emit_table[EMIT_unpack].suffix}, unpack,
                           strlen(unpack));
        if (b->line->emit[EMIT_layout])
            batch_put_file(b, document,
                           (BatchFile){job.layout->name, emit_table[EMIT_layout].suffix}, layout.at,
                           layout.size);
        arena_free(&arena);
        return;
    }
}
