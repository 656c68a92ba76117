/* Library API: layouts from files, and from the ranges of a set of materials. */
#include "compiler/describe/describe.h"
#include "compiler/base/memory.h"
#include "compiler/layout/auto_layout.h"
#include "compiler/layout/layout_read.h"
#include "compiler/choice.h"
#include "compiler/layout/custom.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include <stdlib.h>
#include <string.h>

/* Generates the text and the report of a layout with a valid row. */
static void finish(MatcLayout *layout)
{
    Text text = text_new(&layout->arena), page = text_new(&layout->arena);
    layout_write(&text, layout->row);
    describe_layout(&page, layout->row);
    layout->text = text.at;
    layout->report = page.at;
}

MatcLayout *matc_layout_read(const char *name, const char *text, size_t size,
                             const MatcOptions *options)
{
    MatcLayout *layout = calloc(1, sizeof *layout);
    if (!layout)
        memory_exhausted();
    layout->options = choice_whole_options(options);
    Session *session = &layout->session;
    *session = (Session){.options = &layout->options, .arena = &layout->arena};
    size = text ? size : 0;
    name = name ? name : "";
    const Source source = {.name = arena_string(session->arena, name, strlen(name)),
                           .text = arena_string(session->arena, text ? text : "", size),
                           .size = size};
    ARENA_PUSH(session->arena, session->sources, session->source_count, session->source_capacity,
               source);
    if (!text)
        diag_add(session, NO_SPAN, DIAG_null_argument, "text");
    const Tree *tree = text && choice_check(session) ? read_document(session, 0) : NULL;
    const LayoutRow *row = tree ? layout_read(session, tree) : NULL;
    layout->row = session->diags.errors ? NULL : row;
    if (layout->row)
        finish(layout);
    return layout;
}

MatcLayout *matc_layout_for(const MatcRanges *ranges, double error, const MatcOptions *options)
{
    MatcLayout *layout = calloc(1, sizeof *layout);
    if (!layout)
        memory_exhausted();
    layout->options = choice_whole_options(options);
    layout->session = (Session){.options = &layout->options, .arena = &layout->arena};
    const bool possible = error >= 0 && error <= 1;
    if (choice_check(&layout->session) && !possible)
        diag_add(&layout->session, NO_SPAN, DIAG_layout_error, error);
    if (!layout->session.diags.errors && ranges && ranges->materials) {
        Text report = text_new(&layout->arena);
        layout->row = auto_layout(&layout->arena, ranges, error, &report);
        finish(layout);
        text_put(&report, layout->report);
        layout->report = report.at;
    } else if (!layout->session.diags.errors) {
        diag_add(&layout->session, NO_SPAN, DIAG_layout_of_none);
    }
    return layout;
}

bool matc_ranges_add(MatcRanges *ranges, const MatcDocument *document, int material,
                     const MatcOptions *options, char **fault)
{
    Job job;
    Arena arena = {0};
    MatcRanges one;
    MatcOptions own = choice_whole_options(options);
    own.layout = own.pass = own.constants = NULL;
    own.member_count = 0;
    own.custom = NULL;
    own.optimize = 2;
    Session session = session_open(&own, &arena);
    const Graph *graph = document ? document->graph : NULL;
    if (document)
        document_lend(document, &session);
    const char *wrong = choice_fault(&arena, &own);
    if (wrong)
        diag_add(&session, NO_SPAN, DIAG_unknown_option, wrong);
    if (!ranges || !document)
        diag_add(&session, NO_SPAN, DIAG_null_argument, ranges ? "document" : "ranges");
    bool fine = !wrong && ranges && !choice_job(&own, &job) && graph && material >= 0 &&
                material < graph->material_count;
    job.pass = PASS_value;
    job.all_slots = true;
    matc_ranges_init(&one);
    const Ir *ir = fine ? compile_ir(&session, graph, graph->materials[material].node, &job) : NULL;
    fine = ir;
    if (fine)
        auto_ranges(ir, &one);
    if (fault)
        *fault = NULL;
    if (fine)
        matc_ranges_join(ranges, &one);
    else if (fault)
        *fault = memory_checked(
            strdup(session.diags.count ? diag_all(&session, MATC_TEXT) : "no such material"));
    arena_free(&arena);
    return fine;
}

void matc_layout_free(MatcLayout *layout)
{
    if (!layout)
        return;
    arena_free(&layout->arena);
    free(layout);
}

bool matc_layout_ok(const MatcLayout *layout) { return layout && layout->row; }
const char *matc_layout_diagnostics(MatcLayout *layout, MatcForm form)
{
    return layout ? diag_all(&layout->session, form) : "";
}
const char *matc_layout_name(const MatcLayout *layout)
{
    return layout && layout->row ? layout->row->name : NULL;
}
int matc_layout_bytes(const MatcLayout *layout)
{
    return layout && layout->row ? layout_bytes(layout->row) : 0;
}
const char *matc_layout_text(const MatcLayout *layout) { return layout ? layout->text : NULL; }
const char *matc_layout_report(const MatcLayout *layout) { return layout ? layout->report : NULL; }
