/* Statements of an OBJ file, before faces are split into triangles. */
#ifndef MATC_VIEW_OBJ_PARSE_H
#define MATC_VIEW_OBJ_PARSE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { OBJ_NONE = -1, OBJ_FLAT = 0, OBJ_SMOOTH = -1 /* smoothing before the first `s` */ };

typedef struct {
    int v, t, n; /* from 0; OBJ_NONE: absent */
} ObjCorner;

typedef struct {
    size_t first; /* corner */
    int count, line;
    int smoothing; /* number of `s`, OBJ_FLAT or OBJ_SMOOTH */
    bool has_coordinates;
} ObjFace;

typedef struct {
    float (*positions)[3], (*colors)[4], (*coordinates)[2], (*normals)[3];
    ObjCorner *corners;
    ObjFace *faces;
    size_t position_count, coordinate_count, normal_count, corner_count, face_count;
    size_t position_capacity, color_capacity, coordinate_capacity, normal_capacity, corner_capacity,
        face_capacity;
    bool has_colors; /* `colors` has a row per position, white where the file has no color */
    int line;        /* of the last statement */
    const char *fault;
} ObjFile;

/* Parses a text that ends in a zero byte. Returns false with the reason in `fault` and its line.
 * Call obj_parse_free in both cases. */
bool obj_parse(const char *text, size_t size, ObjFile *file);
void obj_parse_free(ObjFile *file);
#endif
