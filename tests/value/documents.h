/* The example documents, read twice: through the library's interface for its shaders, and as a
 * Graph for the oracle. */
#ifndef MATC_VALUE_DOCUMENTS_H
#define MATC_VALUE_DOCUMENTS_H
#include "compiler/graph/graph.h"
#include "compiler/matc.h"
#include "compiler/pipeline.h"

typedef struct {
    char **paths; /* sorted; each begins with the folder */
    int count;
} DocumentList;

/* Every .yaml and .json below `folder`/examples. */
DocumentList documents_list(const char *folder);
/* The examples, and the documents of tests/value, which cover features without an example; these
 * have no goldens because compact cannot store all of their slots. */
DocumentList documents_tried(const char *folder);
/* Every .yaml in the folder itself. */
DocumentList documents_in(const char *folder);
void documents_free(DocumentList *list);

typedef struct {
    const char *path;
    MatcOptions options; /* with pictures decoded */
    MatcDocument *document;
    Arena arena; /* owns the members below */
    Session session;
    Tree *tree;
    Graph *graph; /* material i is the document's material i */
} Document;

/* Returns false if the document has errors: see document_fault. Close it in any case. */
bool document_open(Document *d, const char *path);
/* Opens YAML text, which must outlive the document. */
bool document_open_text(Document *d, const char *text);
/* True if its only error is that it has no material, because other documents include it. */
bool document_is_library(const Document *d);
const char *document_fault(Document *d);
/* File name of the document's path. */
const char *document_name(const Document *d);
void document_close(Document *d);

/* Changes a uniform's value in the graph, for both the drawing and the oracle. */
void document_set_uniform(Document *d, int uniform, const double value[4]);
#endif
