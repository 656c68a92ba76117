/* Bytes of a mesh file, and numbers in its text. */
#ifndef MATC_VIEW_MODEL_TEXT_H
#define MATC_VIEW_MODEL_TEXT_H
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Reads a file of at most MODEL_FILE_MIB. Returns its bytes followed by a zero byte, from malloc;
 * NULL with the reason in *error. */
char *model_text_read(const ModelSource *source, size_t *size, char *error, size_t capacity);

/* Parses a decimal number such as -.5, 12. or 1e-3, whatever the locale, and moves *at behind it.
 * A number ends at white space, at the end of the text or before one of the characters `\#`. The
 * text must end in a zero byte. */
bool model_text_number(const char **at, double *value);
/* Parses a decimal integer with an optional sign; values beyond 2^31 are clamped. */
bool model_text_integer(const char **at, int64_t *value);

/* Returns the array with capacity for one element more than `count`: doubles *capacity. */
void *model_text_grow(void *array, size_t count, size_t *capacity, size_t size);
#endif
