/* GLSL around the programs of opaque surfaces, where shadows are exact: beside the G-buffer they write which triangle a pixel sees (exact_number.glsl). */
#ifndef MATC_RENDER_EXACT_NUMBER_H
#define MATC_RENDER_EXACT_NUMBER_H
#include "runtime/render/set.h"
#include "runtime/render/store.h"

enum {
    EXACT_NUMBER_FIRSTS = 5, /* binding point of the storage buffer of objects' first numbers */
    EXACT_NUMBER_TEXT = 96
};

typedef struct {
    const char *head;
    char defined[EXACT_NUMBER_TEXT];
    bool instances;
} ExactNumberText;

void exact_number_text(const GlContext *gl, const Set *set, ExactNumberText *made);
/* Puts a material's programs, each of one piece, between; the text is there until they are compiled. */
void exact_number_wrap(const ExactNumberText *text, ProgramText *program);
#endif
