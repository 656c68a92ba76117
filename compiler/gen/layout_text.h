/* Buffer layouts shared by C and GLSL. The rows of a *.layout.def file become an enum for C and
 * declarations for GLSL, so that both use the same offsets: in words of 4 bytes, or, with the
 * type "vec4", in elements of 16 bytes.
 *
 *     LAYOUT("POOL_", "pool_", "uint")     prefix for C, prefix for GLSL, type for GLSL
 *     WORDS(width, 1, "pixels of a row")   name, size, comment
 *     WORDS(nodes, 2, "")
 *     WORDS(head, 0, "")
 *     C:     enum { POOL_WIDTH = 0, POOL_NODES = 1, POOL_HEAD = 3 }
 *     GLSL:  uint pool_width; uint pool_nodes[2];
 *
 * With the type "const uint" GLSL gets the offsets as constants, `const uint POOL_NODES = 1u;`,
 * like C. WORDS of size 0 names an offset. VALUE(name, number, comment) is a constant that takes
 * no words. A size or number is a sum of products of numbers and of names defined above. */
#ifndef MATC_GEN_LAYOUT_TEXT_H
#define MATC_GEN_LAYOUT_TEXT_H
#include <stdio.h>

/* Returns true if the path names a layout, such as "a/pool.layout.def". */
int layout_text_is(const char *path);
/* Write the declarations of a layout file's text. `name` is the file's name without ".def".
 * Return 0 after reporting a wrong row. */
int layout_text_c(FILE *out, const char *name, const char *text);
int layout_text_glsl(FILE *out, const char *name, const char *text);
#endif
