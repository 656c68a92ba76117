/* Source texts, and positions in them. Offsets are bytes; lines and columns are computed only
 * for printing. */
#ifndef MATC_SOURCE_H
#define MATC_SOURCE_H
#include <stddef.h>
#include <stdint.h>

/* Bytes start to end-1 of the source with index `file`. */
typedef struct {
    uint32_t start, end;
    uint32_t file;
} Span;

typedef struct {
    const char *name; /* name as the user wrote it */
    const char *text; /* text, zero-terminated */
    size_t size;
    const char *binary; /* binary chunk of a container (.glb); NULL: absent */
    size_t binary_size;
} Source;

typedef struct {
    int line, column; /* numbers from 1; the column counts bytes, as in gcc */
    const char *line_start;
    int line_length; /* length in bytes, without the line break */
} SourcePosition;
SourcePosition source_position(const Source *source, uint32_t offset);
#endif
