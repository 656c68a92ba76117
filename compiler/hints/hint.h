/* Hints for values and names from other tools or languages: each function reports a fault that
 * it recognizes, with the correct form. Returns true if it reported one. Further hints are in
 * common_error.h. */
#ifndef MATC_HINT_H
#define MATC_HINT_H
#include "compiler/graph/resolver.h"
#include "grammar/library_table.h"

/* Reports a literal color or list for a parameter that is a single number, also if reached
 * through `ref:`. A map of colors is accepted and converted. hint_number.c
 *
 *     emission: "#ff8800"     only red would be read: emissionColor is meant
 *     roughness: [0.2, 0.3]   a list */
bool hint_number_list(Resolver *r, const ParamRow *row, const Tree *tree);
bool hint_number_color(Resolver *r, const ParamRow *row, const Tree *tree, const Value *constant);

/* Reports values in the syntax of other languages: rgb(255, 0, 0), 0xff8800, 0,5, true.
 * hint_value.c */
bool hint_value(Resolver *r, const char *what, const Tree *tree, ComponentCount components);
/* Reports a CSS color name such as brown; hint_map_name() a map name of another tool, such as
 * Noise Texture. */
bool hint_color_name(Resolver *r, const Tree *tree, const char *text);
bool hint_map_name(Resolver *r, const Tree *tree);

/* Reports an object without `map:` or `material:` whose other keys identify it. hint_object.c
 *
 *     { r: 1, g: .5, b: 0 }    a color: [1, .5, 0]
 *     { type: Checker }        `map: Checker`
 *     { image: f.png }         { map: ImageMap, image: ... } */
bool hint_object(Resolver *r, const Tree *object, bool material);
/* Reports a top-level key such as `type: Principled` in the place of `material:`. */
bool hint_document(Session *session, const Tree *document);
/* Returns "; it comes with matc: `include: rust.yaml`" for a name that a library file defines
 * but no file of the document; otherwise NULL. hint_library.c */
const char *hint_shipped(Session *session, const char *name);
/* Returns the library's row of a name; NULL: none. */
const LibraryName *hint_library_name(const char *name);
/* Returns a hint for a definition's name in the place of a kind, `map: rust`, if the document or
 * the library defines it. hint_library.c */
const char *hint_definition(Resolver *r, const char *name);
/* Reports `n = fbm(p)`, as a text or as a key, in the place of `n: ...`. hint_assigned.c */
bool hint_assigned(Session *session, const Tree *tree);
/* Returns advice "; ..." for a document without a material, based on keys that belong to a
 * material; otherwise "". hint_assigned.c */
const char *hint_no_material(Session *session, const Tree *document);
/* Reports a Windows path in double quotes, "C:
 * ew\bricks.png", whose
 *  and \b YAML reads as escapes. hint_assigned.c */
bool hint_backslash(Session *session, Span span);
/* Reports a map or a material written as a list item. */
bool hint_listed(Session *session, const Tree *list);
#endif
