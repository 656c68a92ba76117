/* Layouts that C and GLSL share: rows of a *.layout.def file become an enum for C and declarations for GLSL, so that
 * both count the same words.
 *
 *     LAYOUT("POOL_", "pool_", "uint")     prefixes of both, the type for GLSL
 *     WORDS(width, 1, "pixels of a row")
 *     WORDS(nodes, 2, "")
 *     WORDS(head, 0, "")                   enum { POOL_WIDTH = 0, POOL_NODES = 1, POOL_HEAD = 3 }, in GLSL
 *                                          uint pool_width; uint pool_nodes[2];
 *
 * With the type "const uint" GLSL gets constants, `const uint POOL_NODES = 1u;`, as C does. VALUE(name, number, doc)
 * takes no words. Numbers are sums of products of numbers and of names above. */
#ifndef MATC_GEN_LAYOUT_TEXT_H
#define MATC_GEN_LAYOUT_TEXT_H
#include <stdio.h>

/* "a/pool.layout.def" is the name of one. */
int layout_text_is(const char *path);
/* Write what a file's text declares, `name` being the file's; 0, and a message: a row is wrong. */
int layout_text_c(FILE *out, const char *name, const char *text);
int layout_text_glsl(FILE *out, const char *name, const char *text);
#endif
