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
    signed char *lit; /* -1: no state yet */
    int *turns;
} Flicker;

/* Returns false if memory ran out; *made is empty then. */
bool flicker_open(int pixels, Flicker *made);
/* Adds a step: for each pixel the share of the light that arrives, lit if at least half; below
 * 0: no light could arrive. */
void flicker_add(Flicker *flicker, const float *shares);
/* Adds a step from two pictures of four floats per pixel: the shares are `with` over `without`. */
void flicker_add_pictures(Flicker *flicker, const float *with, const float *without);
/* Number of flickers of all pixels, compared with the truth. */
long flicker_count(const Flicker *flicker, const Flicker *truth);
/* Total number of turns of all pixels. */
long flicker_turns(const Flicker *flicker);
/* Safe on an empty Flicker. */
void flicker_close(Flicker *flicker);
#endif
