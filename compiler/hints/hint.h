/* Hints for values and names that authors bring from elsewhere: each function reports a fault that
 * it recognizes, and says what to write instead. True: it is reported. mistake.h has older ones. */
#ifndef MATC_HINT_H
#define MATC_HINT_H
#include "compiler/graph/resolver.h"
#include "grammar/library_table.h"

/* A literal colour or list where one number is read. A map of a colour is none of these: it is
 * converted. Constants that are reached through `ref:` count, too. hint_number.c
 *
 *     emission: "#ff8800"     red alone would count: emissionColor is meant
 *     roughness: [0.2, 0.3]   a list */
bool hint_number_list(Resolver *r, const ParamRow *row, const Tree *tree);
bool hint_number_color(Resolver *r, const ParamRow *row, const Tree *tree, const Value *constant);

/* A form of a value that other languages have: rgb(255, 0, 0), 0xff8800, 0,5, true. hint_value.c */
bool hint_value(Resolver *r, const char *what, const Tree *tree, LaneCount lanes);
/* A colour's name of CSS: brown; a map's of other tools: Noise Texture. */
bool hint_color_name(Resolver *r, const Tree *tree, const char *text);
bool hint_map_name(Resolver *r, const Tree *tree);

/* An object without `map:` or `material:` whose other keys tell what it is. hint_object.c
 *
 *     { r: 1, g: .5, b: 0 }    a colour: [1, .5, 0]
 *     { type: Checker }        `map: Checker`
 *     { image: f.png }         { map: ImageMap, image: ... } */
bool hint_object(Resolver *r, const Tree *object, bool material);
/* A hint for a whole document: `type: Principled`. */
bool hint_document(Session *session, const Tree *document);
/* "; it comes with matc: `include: rust.yaml`": of a name that a file of the library defines, and
 * no file of the document; NULL: none does. hint_library.c */
const char *hint_shipped(Session *session, const char *name);
/* The row of a name; NULL: the library has none. */
const LibraryName *hint_library_name(const char *name);
/* A hint for a definition in the place of a kind, `map: rust`, also of one that the document has.
 * hint_library.c */
const char *hint_definition(Resolver *r, const char *name);
/* Reports `n = fbm(p)`, as a text or as a key, where `n: ...` is wanted. hint_assigned.c */
bool hint_assigned(Session *session, const Tree *tree);
/* "; ...": advice for a document without a material, from those of its keys that belong to one; or
 * "". hint_assigned.c */
const char *hint_no_material(Session *session, const Tree *document);
/* Reports a Windows path in double quotes, "C:\new\bricks.png", where YAML reads \n and \b as
 * escapes. hint_assigned.c */
bool hint_backslash(Session *session, Span span);
/* A map or a material as an item of a list. */
bool hint_listed(Session *session, const Tree *list);
#endif
