/* The parsers: Text -> Tree. The text is valid UTF-8 and begins at b->start. They return NULL
 * after reporting faults as diagnostics. */
#ifndef MATC_READ_H
#define MATC_READ_H
#include "compiler/read/tree_build.h"

Tree *read_yaml(TreeBuilder *b);
/* Parses strict JSON, RFC 8259. */
Tree *read_json(TreeBuilder *b);
/* Parses a glTF file and returns its materials as a document. */
Tree *read_gltf(TreeBuilder *b);
/* Parses a source as JSON, whatever its file name. */
Tree *read_json_of(Session *session, uint32_t file);
#endif
