/* Lays out cells from the upper left, row by row. Picture bytes start at the bottom row. */
#include "runtime/viewer/contact_sheet.h"
#include "compiler/base/memory.h"
#include "compiler/base/output.h"
#include "runtime/viewer/font.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct ContactSheetCell {
    char name[SHEET_NAME];
    unsigned char *rgb;
} ContactSheetCell;

enum {
    PAPER = 24,
    INK = 214,
    GAP = 6,
    LARGE = 160 /* min picture width at which letters are doubled */
};

const char contact_sheet_too_large[] =
    "the contact sheet is larger than 16384 pixels; reduce its cells with --size";

/* Uses the lower bound of contact_sheet_columns(): the square root of the count. */
bool contact_sheet_has_capacity(const ContactSheet *sheet)
{
    return ceil(sqrt(sheet->count + 1)) * (sheet->width + GAP) + GAP <= PNG_SIZE_LIMIT;
}

void contact_sheet_add(ContactSheet *sheet, const char *name, const unsigned char *rgb)
{
    const size_t size = (size_t)sheet->width * (size_t)sheet->height * 3;
    if (sheet->count == sheet->capacity) {
        sheet->capacity = sheet->capacity ? 2 * sheet->capacity : 16;
        sheet->cells = realloc(sheet->cells, (size_t)sheet->capacity * sizeof *sheet->cells);
        if (!sheet->cells)
            memory_exhausted();
    }
    ContactSheetCell *cell = &sheet->cells[sheet->count++];
    *cell = (ContactSheetCell){.rgb = malloc(size)};
    if (!cell->rgb)
        memory_exhausted();
    memcpy(cell->rgb, rgb, size);
    strncpy(cell->name, name, SHEET_NAME - 1);
}

/* The column count is at most three times the row count. Example: for 10 pictures, rows of 4
 * leave 2 cells empty and rows of 5 none, so the result is 5. */
int contact_sheet_columns(int count)
{
    int least = (int)ceil(sqrt(count)), most = (int)sqrt(3.0 * count), best = least;
    for (int columns = least; columns <= most; columns++)
        if ((columns - count % columns) % columns < (best - count % best) % best)
            best = columns;
    return best;
}

static void put(const PngPicture *picture, int x, int y, int grey)
{
    if (x < picture->width && y < picture->height)
        memset(picture->bytes +
                   ((size_t)(picture->height - 1 - y) * (size_t)picture->width + (size_t)x) * 3,
               grey, 3);
}

/* Draws a glyph with pixels of scale x scale; (x, y) is the upper left corner. */
static void draw_letter(const PngPicture *picture, char letter, int scale, int x, int y)
{
    for (int row = 0; row < FONT_HEIGHT * scale; row++)
        for (int column = 0; column < FONT_ADVANCE * scale; column++)
            if (font_has_ink(letter, column / scale, row / scale))
                put(picture, x + column, y + row, INK);
}

static int scale_for(int width) { return width < LARGE ? 1 : 2; }

/* Draws a name centered below its picture; a long name is drawn smaller, then truncated. */
static void draw_name(const PngPicture *picture, const char *name, int width, int x, int y)
{
    int size = (int)strlen(name), scale = scale_for(width);
    if (size * FONT_ADVANCE * scale > width)
        scale = 1;
    if (size * FONT_ADVANCE * scale > width)
        size = width / (FONT_ADVANCE * scale);
    x += (width - size * FONT_ADVANCE * scale + scale) / 2;
    for (int i = 0; i < size; i++)
        draw_letter(picture, name[i], scale, x + i * FONT_ADVANCE * scale, y);
}

static void draw_cell(const PngPicture *picture, const ContactSheet *sheet,
                      const ContactSheetCell *cell, int x, int y)
{
    const size_t row = (size_t)sheet->width * 3;
    for (int i = 0; i < sheet->height; i++)
        memcpy(picture->bytes +
                   ((size_t)(picture->height - 1 - y - i) * (size_t)picture->width + (size_t)x) * 3,
               cell->rgb + (size_t)(sheet->height - 1 - i) * row, row);
    draw_name(picture, cell->name, sheet->width, x, y + sheet->height + GAP / 2);
}

const char *contact_sheet_draw(const ContactSheet *sheet, PngPicture *picture)
{
    if (!sheet->count)
        return "the contact sheet has no image";
    const int columns = contact_sheet_columns(sheet->count),
              rows = (sheet->count + columns - 1) / columns;
    const long across = sheet->width + GAP,
               down = sheet->height + GAP + FONT_HEIGHT * scale_for(sheet->width) + GAP / 2;
    if (columns * across + GAP > PNG_SIZE_LIMIT || rows * down + GAP > PNG_SIZE_LIMIT)
        return contact_sheet_too_large;
    *picture = (PngPicture){(int)(columns * across + GAP), (int)(rows * down + GAP), 3, NULL};
    const size_t size = (size_t)picture->width * (size_t)picture->height * 3;
    picture->bytes = malloc(size);
    if (!picture->bytes)
        memory_exhausted();
    memset(picture->bytes, PAPER, size);
    for (int i = 0; i < sheet->count; i++)
        draw_cell(picture, sheet, &sheet->cells[i], GAP + i % columns * (int)across,
                  GAP + i / columns * (int)down);
    return NULL;
}

const char *contact_sheet_write(const ContactSheet *sheet, const char *path)
{
    PngPicture picture = {0};
    size_t size;
    const char *why = contact_sheet_draw(sheet, &picture);
    uint8_t *file = why ? NULL : png_write(&picture, &size, &why);
    if (file)
        why = output_write(path, file, size);
    free(file);
    free(picture.bytes);
    return why;
}

void contact_sheet_free(ContactSheet *sheet)
{
    for (int i = 0; i < sheet->count; i++)
        free(sheet->cells[i].rgb);
    free(sheet->cells);
    *sheet = (ContactSheet){.width = sheet->width, .height = sheet->height};
}
