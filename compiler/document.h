/* A document as the library's surface holds it. Private to it, and to runtime/scene, which reads
 * more of a document than its materials. */
#ifndef MATC_DOCUMENT_H
#define MATC_DOCUMENT_H
#include "compiler/graph/graph.h"
#include "compiler/read/tree.h"

struct MatcDocument {
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph; /* NULL: faults */
};

/* Text -> Tree; no graph yet. */
MatcDocument *document_read(const char *name, const char *text, size_t size,
                            const MatcOptions *options);
/* Tree -> Graph; the tree is the document's own, or its materials alone. NULL: there is none. */
void document_resolve(MatcDocument *document, Tree *tree);
/* Diagnostics of the session are about positions in the document. */
void document_lend(const MatcDocument *document, Session *session);
#endif
