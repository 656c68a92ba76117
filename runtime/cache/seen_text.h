/* GLSL around the programs of opaque surfaces: beside the G-buffer they write a word about the
 * triangle that a pixel sees, to the target `seen`. */
#ifndef MATC_CACHE_SEEN_TEXT_H
#define MATC_CACHE_SEEN_TEXT_H
#include "runtime/cache/set.h"
#include "runtime/draw/store.h"

enum { SEEN_TEXT_DEFINED = 96 };

/* Text that writes the data. */
typedef struct {
    const char *fragment; /* writes at the location SEEN_TARGET; its main() calls surfaceMain() */
    bool places;          /* it reads seen_place, the number of the object's place: an input if
                           * SEEN_INSTANCES          is defined, else a uniform */
} SeenText;

/* Texts for the programs of a set; `text` is NULL if nothing is written. */
typedef struct {
    const SeenText *text;
    const char *head;
    char defined[SEEN_TEXT_DEFINED];
    bool instances;
} SeenTextAround;

void seen_text_make(const GlContext *gl, const Set *set, const SeenText *text,
                    SeenTextAround *made);
/* Puts a material's programs, each of one piece, between; *around stays until they are compiled. */
void seen_text_wrap(const SeenTextAround *around, ProgramText *program);
#endif
