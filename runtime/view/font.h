/* Letters for the names on a contact sheet: 5 pixels wide, 7 above the line and 2 below, drawn for
 * this project. */
#ifndef MATC_VIEW_FONT_H
#define MATC_VIEW_FONT_H
#include <stdbool.h>

enum { FONT_ADVANCE = 6, FONT_HEIGHT = 9 };

/* Whether a letter has ink there; x from the left, y from the top. What the font does not have is a
 * question mark. */
bool font_has_ink(char letter, int x, int y);
#endif
