/* Reading whole files. output.h writes them. */
#ifndef MATC_FILE_H
#define MATC_FILE_H
#include <stddef.h>

/* The bytes of a file with a zero byte behind them, in memory from malloc. NULL: *why; that it is
 * larger than LIMIT_DOCUMENT_MIB, too. Pipes, devices and folders are refused at once: they may
 * have no end, and another each time. */
char *file_read(const char *path, size_t *size, const char **why);
/* Reads a path that the user named: it can be a pipe such as <(command) or /dev/stdin, or a
 * terminal. */
char *file_read_named(const char *path, size_t *size, const char **why);
/* A document of a command line: the same, and "-" is standard input; diagnostics call that
 * <stdin>. */
char *file_read_document(const char *path, size_t *size, const char **why);
const char *file_document_name(const char *path);
/* Opens for reading without waiting: a pipe's other end may never be opened. -1: *why. */
int file_open(const char *path, const char **why);
/* NULL, or the reason why a descriptor is no regular file. */
const char *file_refuses(int descriptor);
/* The bytes of a regular file that is open, which it closes; of -1 nothing, and *why stays. */
char *file_read_whole(int descriptor, size_t *size, const char **why);
/* All that comes from a descriptor, whatever it is. */
char *file_read_from(int descriptor, size_t *size, const char **why);
#endif
