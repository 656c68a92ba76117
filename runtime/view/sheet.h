/* A contact sheet: pictures of one size side by side, each with its name below. */
#ifndef MATC_VIEW_SHEET_H
#define MATC_VIEW_SHEET_H
#include "runtime/gl/png_write.h"
#include <stdbool.h>

enum { SHEET_NAME = 128 };

/* Pictures as they come; {width, height} at first. */
typedef struct {
    int width, height; /* of every picture, in pixels */
    int count, room;
    struct SheetCell *cells;
} Sheet;

/* False: with one more it is too large, and stays so whatever comes behind. It may be too large all
 * the same. */
bool sheet_has_room(const Sheet *sheet);
extern const char sheet_too_large[];
/* Adds a picture: its pixels of RGB, row 0 is the bottom row. Both are copied; a long name is
 * cut. */
void sheet_add(Sheet *sheet, const char *name, const unsigned char *rgb);
/* How many of so many pictures stand side by side: the sheet is wider than high, with as few empty
 * cells as can be. */
int sheet_columns(int count);
/* Draws it; picture->bytes is from malloc. NULL, or why not: there is no picture, or the sheet
 * would be too large for a file. */
const char *sheet_draw(const Sheet *sheet, PngPicture *picture);
/* Writes it as a PNG. NULL, or why not. */
const char *sheet_write(const Sheet *sheet, const char *path);
/* Back to {width, height}. */
void sheet_free(Sheet *sheet);
#endif
