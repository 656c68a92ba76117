/* Files that matc writes: whole or not at all. */
#ifndef MATC_OUTPUT_H
#define MATC_OUTPUT_H
#include "matc.h"

/* Writes to a temporary name beside `path` and renames it; "-" is standard output. NULL, or why not. */
const char *output_write(const char *path, const void *bytes, size_t size);
/* A texture as a KTX 1 file (row 0 is v = 0), from malloc. */
char *output_ktx(const MatcTexture *texture, size_t *size);
#endif
