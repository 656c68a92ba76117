/* Header of a PLY file. */
#ifndef MATC_VIEW_PLY_HEADER_H
#define MATC_VIEW_PLY_HEADER_H
#include <stdbool.h>
#include <stddef.h>

enum { PLY_ELEMENTS = 32, PLY_PROPERTIES = 64, PLY_NO_ROLE = -1, PLY_INDICES = 12 };

typedef enum {
    PLY_none,
    PLY_char,
    PLY_uchar,
    PLY_short,
    PLY_ushort,
    PLY_int,
    PLY_uint,
    PLY_float,
    PLY_double
} PlyType;
typedef enum { PLY_ascii, PLY_little, PLY_big } PlyFormat;

typedef struct {
    PlyType count; /* type of a list's count; PLY_none: a scalar */
    PlyType type;
    /* 0 to 11: x y z, nx ny nz, u v, red green blue alpha of a vertex; PLY_INDICES */
    int role;
} PlyProperty;

typedef struct {
    double count;
    bool is_vertex, is_strip;
    PlyProperty properties[PLY_PROPERTIES];
    int property_count;
} PlyElement;

typedef struct {
    PlyFormat format;
    PlyElement elements[PLY_ELEMENTS];
    int element_count;
    size_t size;       /* bytes of the header */
    int line;          /* last line read, from 1 */
    const char *fault; /* NULL: none */
} PlyHeader;

/* Parses the header of a text that ends in a zero byte. Returns false with `fault` and `line`. */
bool ply_header_read(const char *text, size_t size, PlyHeader *header);
/* Bytes of a value in a binary file. */
size_t ply_header_size(PlyType type);
#endif
