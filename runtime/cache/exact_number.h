/* GLSL around the programs of opaque surfaces: beside the G-buffer they write which triangle a
 * pixel sees, where shadows are exact (exact_number.glsl), or how steep it is, where silhouettes
 * find them (facet_slopes.glsl). */
#ifndef MATC_CACHE_EXACT_NUMBER_H
#define MATC_CACHE_EXACT_NUMBER_H
#include "runtime/cache/set.h"
#include "runtime/draw/store.h"

enum {
    EXACT_NUMBER_FIRSTS = 5, /* binding point of the storage buffer of objects' first numbers */
    EXACT_NUMBER_TEXT = 96
};

typedef enum { EXACT_NUMBER_none, EXACT_NUMBER_numbers, EXACT_NUMBER_facets } ExactNumberWhat;

typedef struct {
    const char *head;
    char defined[EXACT_NUMBER_TEXT];
    bool instances;
    ExactNumberWhat what;
} ExactNumberText;

void exact_number_text(const GlContext *gl, const Set *set, ExactNumberWhat what,
                       ExactNumberText *made);
/* Puts a material's programs, each of one piece, between; the text is there until they are
 * compiled. */
void exact_number_wrap(const ExactNumberText *text, ProgramText *program);
#endif
