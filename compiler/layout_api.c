/* The library's surface: layouts from files. auto_layout.c makes them from ranges. */
#include "compiler/describe/describe.h"
#include "compiler/layout/layout_read.h"
#include "compiler/choice.h"
#include "compiler/layout/custom.h"
#include "compiler/document.h"
#include <stdlib.h>
#include <string.h>

MatcLayout *matc_layout_read(const char *name, const char *text, size_t size, const MatcOptions *options)
{
    MatcLayout *layout = calloc(1, sizeof *layout);
    if (!layout)
        abort();
    Locale locale = locale_enter();
    layout->options = choice_whole_options(options);
    Session *session = &layout->session;
    *session = (Session){.options = &layout->options, .arena = &layout->arena};
    Source source = {arena_string(session->arena, name, strlen(name)), arena_string(session->arena, text, size), size};
    ARENA_PUSH(session->arena, session->sources, session->source_count, session->source_room, source);
    const Tree *tree = read_document(session, 0);
    const LayoutRow *row = tree ? layout_read(session, tree) : NULL;
    layout->row = session->diags.errors ? NULL : row;
    if (layout->row)
        layout_describe(layout);
    locale_leave(locale);
    return layout;
}

void layout_describe(MatcLayout *layout)
{
    Text text = text_new(&layout->arena), page = text_new(&layout->arena);
    layout_write(&text, layout->row);
    describe_layout(&page, layout->row);
    layout->text = text.at;
    layout->report = page.at;
}

void matc_layout_free(MatcLayout *layout)
{
    if (!layout)
        return;
    arena_free(&layout->arena);
    free(layout);
}

bool matc_layout_ok(const MatcLayout *layout) { return layout->row != NULL; }
const char *matc_layout_diagnostics(MatcLayout *layout, MatcForm form) { return diag_all(&layout->session, form); }
const char *matc_layout_name(const MatcLayout *layout) { return layout->row ? layout->row->name : NULL; }
int matc_layout_bytes(const MatcLayout *layout) { return layout->row ? layout_bytes(layout->row) : 0; }
const char *matc_layout_text(const MatcLayout *layout) { return layout->text; }
const char *matc_layout_report(const MatcLayout *layout) { return layout->report; }
