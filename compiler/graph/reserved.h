/* Words that GLSL, its targets or matc have for themselves. */
#ifndef MATC_RESERVED_H
#define MATC_RESERVED_H
#include <stdbool.h>

/* Nothing in a program can be called so: keywords, types, built-in functions, and what matc
 * declares but for its functions. */
bool reserved_is_word(const char *name);
/* A uniform cannot be called so: the library's functions, too. */
bool reserved_has(const char *name);
#endif
