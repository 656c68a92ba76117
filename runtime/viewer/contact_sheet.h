/* Contact sheet: a grid of equally sized pictures, each with its name below. */
#ifndef MATC_VIEWER_CONTACT_SHEET_H
#define MATC_VIEWER_CONTACT_SHEET_H
#include "runtime/gl/png_write.h"
#include <stdbool.h>

enum { SHEET_NAME = 128 };

/* Pictures in order of insertion; initialize to {width, height}. */
typedef struct {
    int width, height; /* size of every picture, in pixels */
    int count, capacity;
    struct ContactSheetCell *cells;
} ContactSheet;

/* Returns false if the sheet with one more picture exceeds the size limit of a file, however
 * many follow. True does not guarantee that the sheet fits. */
bool contact_sheet_has_capacity(const ContactSheet *sheet);
extern const char contact_sheet_too_large[];
/* Adds a picture: RGB bytes, bottom row first. Copies the pixels and the name; a long name is
 * truncated. */
void contact_sheet_add(ContactSheet *sheet, const char *name, const unsigned char *rgb);
/* Returns the number of columns for `count` pictures: the sheet is wider than high and has as
 * few empty cells as possible. */
int contact_sheet_columns(int count);
/* Draws the sheet; picture->bytes is from malloc. Returns NULL, or an error message if the sheet
 * is empty or too large for a file. */
const char *contact_sheet_draw(const ContactSheet *sheet, PngPicture *picture);
/* Writes the sheet as a PNG file. Returns NULL, or an error message. */
const char *contact_sheet_write(const ContactSheet *sheet, const char *path);
/* Removes all pictures; the cell size stays. */
void contact_sheet_free(ContactSheet *sheet);
#endif
