/* Vertex attributes that a document names: attribute_wetness in the vertex program, the varying
 * matc_attribute_wetness in later stages. */
#ifndef MATC_EMIT_ATTRIBUTE_H
#define MATC_EMIT_ATTRIBUTE_H
#include "compiler/emit/emit.h"
#include "compiler/matc.h"

/* First location after the attributes of all programs; the i-th attribute of a document is i
 * locations later. */
enum { ATTRIBUTE_FIRST_LOCATION = 11 };
/* Returns the location of the attribute's varying, after all others; emit_object_location() has
 * that of instances. */
int attribute_location(int attribute);
/* Returns "float attribute_wetness". */
const char *attribute_declaration(const Ir *ir, int attribute);
/* Writes the name of the varying, or of its screen-space derivative. */
void attribute_put_name(Text *out, const MeshAttribute *attribute, AttributePart part);
/* Declares the varyings in use; `word` is "in" or "out". */
void attribute_put_varyings(Text *out, const Job *job, const Interface *interface,
                            const char *word);
/* Writes the vertex program's assignments to the varyings. */
void attribute_hand_on(Text *out, const Interface *interface);
/* Screen-space derivatives of attributes: assignments to globals, declarations with values in
 * main(), or declarations of the globals. */
typedef enum {
    ATTRIBUTE_CHANGES_shared,
    ATTRIBUTE_CHANGES_whole,
    ATTRIBUTE_CHANGES_declared
} AttributeChanges;
void attribute_put_changes(Text *out, const Interface *interface, AttributeChanges form);
/* Writes the rest of an attribute's object in the reflection: the document's name and the
 * default. */
void attribute_describe(Text *out, const MeshAttribute *attribute);
/* Lists the attributes that the IR reads, in the document's order. Returns their number. */
int attribute_list(const Ir *ir, MatcAttribute list[LIMIT_ATTRIBUTES]);
#endif
