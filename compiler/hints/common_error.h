/* Hints for common errors, each with its own message. The functions return true after reporting
 * an error. */
#ifndef MATC_COMMON_ERROR_H
#define MATC_COMMON_ERROR_H
#include "compiler/graph/resolver.h"
#include "grammar/foreign_table.h"

/* Reports a scalar that should be a number: in quotes, or with a unit. */
bool common_error_number(Resolver *r, const Tree *tree);
/* Reports a scalar that should be a map: the bare name of a map or of a definition. */
bool common_error_map(Resolver *r, const Tree *tree);
/* Reports a key without its colon, "map Checker", or without the space after it, "map:Checker",
 * where a value or a key is alone. */
bool common_error_key(Session *session, Span span, const char *text);
/* Applies common_error_key() to the keys of an object. */
bool common_error_keys(Session *session, const Tree *object);
/* Reports hexadecimal digits without the '#'. */
bool common_error_hex(Resolver *r, const Tree *tree, const char *text);
/* Reports a sequence of numbers without the brackets of a list. common_error_text.c */
bool common_error_list(Resolver *r, const Tree *tree);
/* Reports a formula without its '=', or an image's file name. */
bool common_error_formula(Resolver *r, const Tree *tree);
/* Reports the bare name of a param, or of a parameter of the definition. */
bool common_error_param(Resolver *r, const Tree *tree);
/* Returns the member whose key equals `key` except for the case of letters; NULL: none. */
const Member *common_error_case(const Tree *object, const char *key);
/* Returns "; here it is ImageMap" for a name that other tools use for a map, a material or a
 * parameter of `kind` (foreign.def). NULL: unknown. */
const char *common_error_foreign(Session *session, ForeignGroup group, Kind kind, const char *name);
#endif
