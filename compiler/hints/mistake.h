/* Mistakes that many make, each said in words of its own: true: the text is one, and it is said. */
#ifndef MATC_MISTAKE_H
#define MATC_MISTAKE_H
#include "compiler/graph/resolver.h"
#include "grammar/foreign_table.h"

/* A scalar that is no number where one is wanted: in quotes, or with a unit. */
bool mistake_number(Resolver *r, const Tree *tree);
/* A scalar that is no constant where a map is wanted: the name of a map or of a definition. */
bool mistake_map(Resolver *r, const Tree *tree);
/* "map Checker", "map:Checker": a key without its colon, or without the space behind it, where a
 * value or a key stands alone. */
bool mistake_key(Session *session, Span span, const char *text);
/* Checks any key of an object. */
bool mistake_keys(Session *session, const Tree *object);
/* A text that is hexadecimal digits without the '#'. */
bool mistake_hex(Resolver *r, const Tree *tree, const char *text);
/* Numbers beside each other, without the brackets of a list. mistake_text.c */
bool mistake_list(Resolver *r, const Tree *tree);
/* A formula without its '=', or a picture's name. */
bool mistake_formula(Resolver *r, const Tree *tree);
/* The bare name of a param, or of the definition's parameter. */
bool mistake_param(Resolver *r, const Tree *tree);
/* The key that is written in another case; NULL if there is none. */
const Member *mistake_case(const Tree *object, const char *key);
/* "; here it is ImageMap": of a name that other tools have for a map, a material or a parameter of
 * `kind` (foreign.def). NULL: of none. */
const char *mistake_foreign(Session *session, ForeignGroup group, Kind kind, const char *name);
#endif
