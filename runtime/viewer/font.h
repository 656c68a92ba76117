/* Bitmap font for the labels of a contact sheet: glyphs 5 pixels wide, 7 above the baseline and
 * 2 below, drawn for this project. */
#ifndef MATC_VIEWER_FONT_H
#define MATC_VIEWER_FONT_H
#include <stdbool.h>

enum { FONT_ADVANCE = 6, FONT_HEIGHT = 9 };

/* Returns whether a glyph covers pixel (x, y), with x from the left and y from the top.
 * Characters missing from the font are drawn as question marks. */
bool font_has_ink(char letter, int x, int y);
#endif
