/* The readers: Text -> Tree. Each gets a text that is UTF-8, from b->start on; NULL: see the
 * diagnostics. */
#ifndef MATC_READ_H
#define MATC_READ_H
#include "compiler/read/tree_build.h"

Tree *read_yaml(TreeBuilder *b);
/* Strict JSON, RFC 8259. */
Tree *read_json(TreeBuilder *b);
/* The materials of a glTF file, as a document. */
Tree *read_gltf(TreeBuilder *b);
/* The JSON of a source, whatever its name: what was read as something else. */
Tree *read_json_of(Session *session, uint32_t file);
#endif
