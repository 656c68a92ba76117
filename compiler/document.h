/* A document as the library's surface holds it. Private to document.c, evaluate.c, program.c, layout_api.c. */
#ifndef MATC_DOCUMENT_H
#define MATC_DOCUMENT_H
#include "compiler/pipeline.h"

struct MatcDocument {
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph; /* NULL: faults */
};

/* Diagnostics of the session are about positions in the document. */
void document_lend(const MatcDocument *document, Session *session);
#endif
