/* The example documents, read twice: through the library's interface for its shaders, and as a
 * Graph for the oracle. */
#ifndef MATC_VALUE_DOCUMENTS_H
#define MATC_VALUE_DOCUMENTS_H
#include "compiler/graph/graph.h"
#include "compiler/matc.h"
#include "compiler/pipeline.h"

typedef struct {
    char **paths; /* sorted; relative to nothing but the program's folder */
    int count;
} DocumentList;

/* Every .yaml and .json below `folder`/examples. */
DocumentList documents_list(const char *folder);
/* These and tests/value's, which have what no example has: compact has no place for all of it, so
 * there are no goldens. */
DocumentList documents_tried(const char *folder);
/* Every .yaml in the folder itself. */
DocumentList documents_in(const char *folder);
void documents_free(DocumentList *list);

typedef struct {
    const char *path;
    MatcOptions options; /* pictures are decoded */
    MatcDocument *document;
    Arena arena; /* of what follows */
    Session session;
    Tree *tree;
    Graph *graph; /* material i is the document's material i */
} Document;

/* False: the document has faults; see document_fault. Close it in any case. */
bool document_open(Document *d, const char *path);
/* Opens YAML of the test, which must live longer. */
bool document_open_text(Document *d, const char *text);
/* Its only fault is that it has no material: others include it. */
bool document_is_library(const Document *d);
const char *document_fault(Document *d);
/* Folders of the path left out. */
const char *document_name(const Document *d);
void document_close(Document *d);

/* Changes what a uniform of the graph is set to: all who ask for its value, draws and oracle, get
 * this one. */
void document_set_uniform(Document *d, int uniform, const double value[4]);
#endif
