/* Reading whole files. output.h writes them. */
#ifndef MATC_FILE_H
#define MATC_FILE_H
#include <stddef.h>

/* The bytes of a file, or of a stream to its end, with a zero byte behind them, in memory from malloc. NULL: *why; that it is
 * larger than LIMIT_DOCUMENT_MIB, too. */
char *file_read(const char *path, size_t *size, const char **why);
char *file_read_from(int descriptor, size_t *size, const char **why);
#endif
