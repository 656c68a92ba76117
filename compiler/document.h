/* The library's document handle. Private to the library and to runtime/scene, which reads more
 * of a document than its materials. */
#ifndef MATC_DOCUMENT_H
#define MATC_DOCUMENT_H
#include "compiler/graph/graph.h"
#include "compiler/read/tree.h"

struct MatcDocument {
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree;
    Graph *graph; /* graph of the document; NULL: the document has faults */
};

/* Parses a text to a Tree, without a graph. */
MatcDocument *document_read(const char *name, const char *text, size_t size,
                            const MatcOptions *options);
/* Tree -> Graph; the tree is the document's own, or its materials alone. May be NULL. */
void document_resolve(MatcDocument *document, Tree *tree);
/* Lets a session report diagnostics at positions in the document. */
void document_lend(const MatcDocument *document, Session *session);
#endif
