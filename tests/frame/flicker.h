/* Counts flickering pixels while a light moves by small steps. A shadow boundary that passes a
 * pixel turns it once, from lit to dark or back, perhaps a step early or late; a pixel that
 * wrongly turns and turns back flickers.
 *
 *   drawn lit, dark, lit, dark; true lit, lit, dark, dark: three turns instead of one, one
 *   flicker */
#ifndef MATC_FLICKER_H
#define MATC_FLICKER_H
#include <stdbool.h>

typedef struct {
    int pixels;
    signed char *lit; /* -1: it was not seen yet */
    int *turns;
} Flicker;

/* False: memory ran out; *made is empty then. */
bool flicker_open(int pixels, Flicker *made);
/* A step: of each pixel, the share of the light that arrives, of which half is lit; below 0:
 * nothing could arrive there. */
void flicker_add(Flicker *flicker, const float *shares);
/* Adds pictures of four floats a pixel: the first with shadows over the first without. */
void flicker_add_pictures(Flicker *flicker, const float *with, const float *without);
/* How often its pixels flickered. */
long flicker_count(const Flicker *flicker, const Flicker *truth);
/* Turns of all pixels. */
long flicker_turns(const Flicker *flicker);
/* Safe on an empty one. */
void flicker_close(Flicker *flicker);
#endif
