/* Mistakes that many make, each said in words of its own: true: the text is one, and it is said. */
#ifndef MATC_MISTAKE_H
#define MATC_MISTAKE_H
#include "compiler/front/resolve.h"

/* A scalar that is no number where one is wanted: in quotes, or with a unit. */
bool mistake_number(Resolver *r, const Tree *tree);
/* A scalar that is no constant where a map is wanted: the name of a map or of a definition. */
bool mistake_map(Resolver *r, const Tree *tree);
/* A text that is hexadecimal digits without the '#'. */
bool mistake_hex(Resolver *r, const Tree *tree, const char *text);
/* The key that is written in another case; NULL if there is none. */
const Member *mistake_case(const Tree *object, const char *key);
#endif
