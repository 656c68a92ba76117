/* Words that are reserved by GLSL, its targets or matc. */
#ifndef MATC_RESERVED_H
#define MATC_RESERVED_H
#include <stdbool.h>

/* Returns true if no identifier of a program can have this name: keywords, types, built-in
 * functions, and matc's declarations except its functions. */
bool reserved_is_word(const char *name);
/* Returns true if no uniform can have this name; this includes functions of the library. */
bool reserved_has(const char *name);
#endif
