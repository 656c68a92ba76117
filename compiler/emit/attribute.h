/* Attributes of the mesh that a document names, as programs have them: attribute_wetness in the
 * vertex program, matc_attribute_wetness behind it. */
#ifndef MATC_EMIT_ATTRIBUTE_H
#define MATC_EMIT_ATTRIBUTE_H
#include "compiler/emit/emit.h"
#include "compiler/matc.h"

/* Behind those that all programs have in common; the i-th of a document is so many beyond. */
enum { ATTRIBUTE_FIRST_LOCATION = 11 };
/* Location of its varying in GLSL that has locations, behind all others; and of the attribute of
 * instances. */
int attribute_location(int attribute);
/* "float attribute_wetness" */
const char *attribute_declaration(const Ir *ir, int attribute);
/* The varying's name, or that of its change. */
void attribute_put_name(Text *out, const MeshAttribute *attribute, AttributePart part);
/* Those in use as varyings: `word` is "in" or "out". */
void attribute_put_varyings(Text *out, const Job *job, const Interface *interface,
                            const char *word);
/* The vertex program's statements that hand them on. */
void attribute_hand_on(Text *out, const Interface *interface);
/* How they change over the screen: values of globals, whole declarations in main(), or the
 * globals. */
typedef enum {
    ATTRIBUTE_CHANGES_shared,
    ATTRIBUTE_CHANGES_whole,
    ATTRIBUTE_CHANGES_declared
} AttributeChanges;
void attribute_put_changes(Text *out, const Interface *interface, AttributeChanges form);
/* The rest of its object in the reflection: the document's name of it, and its default. */
void attribute_describe(Text *out, const MeshAttribute *attribute);
/* Those that the IR reads, in the document's order; how many. */
int attribute_list(const Ir *ir, MatcAttribute list[LIMIT_ATTRIBUTES]);
#endif
