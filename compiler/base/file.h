/* Reading whole files. Output files are written by output.h. */
#ifndef MATC_FILE_H
#define MATC_FILE_H
#include <stddef.h>

/* Reads a regular file. Returns its bytes followed by a zero byte, from malloc; or NULL and
 * *why, also if the file is larger than LIMIT_DOCUMENT_MIB. Refuses pipes, devices and folders
 * at once: their content may be endless and may change between reads. */
char *file_read(const char *path, size_t *size, const char **why);
/* Reads a path that the user named, which may also be a terminal or a pipe: <(command),
 * /dev/stdin. */
char *file_read_named(const char *path, size_t *size, const char **why);
/* Reads a document named on a command line: as file_read_named(), and "-" is standard input.
 * file_document_name() returns the name for diagnostics: "<stdin>" for "-", otherwise the path. */
char *file_read_document(const char *path, size_t *size, const char **why);
const char *file_document_name(const char *path);
/* Opens a file for reading without blocking, since the other end of a pipe may never be opened.
 * Returns a descriptor, or -1 and *why. */
int file_open(const char *path, const char **why);
/* Returns NULL if the descriptor is a regular file, otherwise the reason to refuse it. */
const char *file_refuses(int descriptor);
/* Reads an open regular file and closes it. A descriptor of -1 returns NULL and leaves *why
 * unchanged. */
char *file_read_whole(int descriptor, size_t *size, const char **why);
/* Reads a descriptor of any type until its end. */
char *file_read_from(int descriptor, size_t *size, const char **why);
#endif
