/* A document as the library's surface holds it. Private to matc.c, program.c, layout_api.c, auto_*.c. */
#ifndef MATC_DOCUMENT_H
#define MATC_DOCUMENT_H
#include "compiler/pipeline.h"
#include <locale.h>

struct MatcDocument {
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph; /* NULL: faults */
};

/* Numbers are read and written the same in every locale; the caller's is put back. */
typedef struct {
    locale_t ours, before;
} Locale;
/* Diagnostics of `c` are about places in the document. */
void document_lend(const MatcDocument *document, Session *session);
Locale locale_enter(void);
void locale_leave(Locale locale);
/* A compilation by these options, which outlive it. */
Session compile_with(const MatcOptions *options, Arena *arena);
#endif
