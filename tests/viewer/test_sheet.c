/* The contact sheet: its size, the places of its pictures, and the legibility of its names. */
/* ctest: quick */
#include "tests/test.h"
#include "runtime/viewer/font.h"
#include "runtime/viewer/contact_sheet.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Few cells are empty, and a sheet is slightly wider than high. */
static void columns_fill_rows(void **state)
{
    (void)state;
    static const int cases[][2] = {{1, 1}, {2, 2},  {3, 3},  {4, 2},
                                   {6, 3}, {10, 5}, {12, 4}, {24, 6}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(contact_sheet_columns(cases[i][0]), cases[i][1]);
    for (int count = 1; count < 500; count++) {
        int columns = contact_sheet_columns(count), rows = (count + columns - 1) / columns;
        assert_true(columns >= rows && columns <= 3 * rows);
        assert_true(columns * rows - count < columns / 2 + 1);
    }
}

static const unsigned char *pixel(const PngPicture *picture, int x, int y)
{
    return picture->bytes + ((picture->height - 1 - y) * picture->width + x) * 3;
}

/* A picture of one color but for its lowest row, which is blue: that is next to the name. */
static void add(ContactSheet *sheet, const char *name, int red, int green)
{
    unsigned char *rgb = malloc((size_t)(sheet->width * sheet->height * 3));
    assert_non_null(rgb);
    for (int i = 0; i < sheet->width * sheet->height; i++) {
        const int bottom = i < sheet->width;
        rgb[3 * i] = (unsigned char)(bottom ? 0 : red);
        rgb[3 * i + 1] = (unsigned char)(bottom ? 0 : green);
        rgb[3 * i + 2] = bottom ? 255 : 0;
    }
    contact_sheet_add(sheet, name, rgb);
    free(rgb);
}

/* Counts the places where a picture of that color begins: pixels of the color without one to the
 * left and above. */
static int count_cells(const PngPicture *p, int red, int green, int *left, int *top)
{
    int count = 0;
    for (int y = 1; y < p->height; y++)
        for (int x = 1; x < p->width; x++) {
            const unsigned char wanted[3] = {(unsigned char)red, (unsigned char)green, 0};
            if (memcmp(pixel(p, x, y), wanted, 3) != 0 || !memcmp(pixel(p, x - 1, y), wanted, 3) ||
                !memcmp(pixel(p, x, y - 1), wanted, 3))
                continue;
            *left = x;
            *top = y;
            count++;
        }
    return count;
}

static int count_ink(const PngPicture *p, int left, int top, int width, int height)
{
    int ink = 0;
    for (int y = top; y < top + height; y++)
        for (int x = left; x < left + width; x++)
            ink += pixel(p, x, y)[0] > 128;
    return ink;
}

static void pictures_lie_in_order(void **state)
{
    (void)state;
    enum { EDGE = 48, COUNT = 5 };
    ContactSheet sheet = {.width = EDGE, .height = EDGE};
    PngPicture picture;
    char name[32];
    for (int i = 0; i < COUNT; i++) {
        snprintf(name, sizeof name, i == 4 ? "a name that is far too long" : "n%d", i);
        add(&sheet, i == 3 ? "" : name, 255, 10 * i);
    }
    assert_null(contact_sheet_draw(&sheet, &picture));
    const int columns = contact_sheet_columns(COUNT), rows = (COUNT + columns - 1) / columns;
    assert_true(picture.width >= columns * EDGE && picture.width < columns * (EDGE + 12) + 12);
    assert_true(picture.height >= rows * (EDGE + FONT_HEIGHT) &&
                picture.height < rows * (EDGE + FONT_HEIGHT + 16) + 16);
    for (int i = 0, first_left = 0, first_top = 0; i < COUNT; i++) {
        int left = 0, top = 0;
        assert_int_equal(count_cells(&picture, 255, 10 * i, &left, &top), 1);
        if (!i)
            first_left = left, first_top = top;
        assert_int_equal((left - first_left) / EDGE, i % columns);
        assert_int_equal((top - first_top) / EDGE, i / columns);
        assert_int_equal(pixel(&picture, left, top + EDGE - 1)[2], 255);
        int ink = count_ink(&picture, left, top + EDGE, EDGE, FONT_HEIGHT + 4);
        assert_true(i == 3 ? !ink : ink > 15); /* no ink where there is no name */
    }
    free(picture.bytes);
    contact_sheet_free(&sheet);
    assert_int_equal(sheet.count, 0);
}

static void what_cannot_be_is_reported(void **state)
{
    (void)state;
    ContactSheet sheet = {.width = 6000, .height = 6000};
    PngPicture picture;
    assert_non_null(strstr(contact_sheet_draw(&sheet, &picture), "no image"));
    for (int i = 0; i < 3; i++)
        add(&sheet, "large", 0, 0);
    assert_non_null(strstr(contact_sheet_draw(&sheet, &picture), "larger than 16384"));
    contact_sheet_free(&sheet);
}

/* A sheet that is too large is detected before it is drawn: whatever follows, an edge is at least
 * the root of the number of pictures. */
static void capacity_is_known_before(void **state)
{
    (void)state;
    static const struct {
        int edge, most;
    } cases[] = {{16384, 0}, {16372, 1}, {6000, 4}, {4000, 16}, {192, 82 * 82}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ContactSheet sheet = {.width = cases[i].edge, .height = 1};
        unsigned char *rgb = calloc((size_t)cases[i].edge, 3);
        assert_non_null(rgb);
        for (; contact_sheet_has_capacity(&sheet); contact_sheet_add(&sheet, "one", rgb))
            assert_true(sheet.count < cases[i].most);
        assert_int_equal(sheet.count, cases[i].most);
        free(rgb);
        contact_sheet_free(&sheet);
    }
}

/* Every letter that a name can have is there, and no two look alike; what is not there is a
 * question mark. */
static void letters_differ(void **state)
{
    (void)state;
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.-_?";
    for (size_t i = 0; letters[i]; i++)
        for (size_t k = 0; letters[k]; k++) {
            int apart = 0, ink = 0;
            for (int at = 0; at < FONT_ADVANCE * FONT_HEIGHT; at++) {
                const int x = at % FONT_ADVANCE, y = at / FONT_ADVANCE;
                apart += font_has_ink(letters[i], x, y) != font_has_ink(letters[k], x, y);
                ink += font_has_ink(letters[i], x, y);
                /* the gap to the next one */
                assert_false(x == FONT_ADVANCE - 1 && font_has_ink(letters[i], x, y));
            }
            assert_true(ink > 3 && (apart > 0) == (i != k));
        }
    for (int at = 0; at < FONT_ADVANCE * FONT_HEIGHT; at++) {
        const int x = at % FONT_ADVANCE, y = at / FONT_ADVANCE;
        assert_int_equal(font_has_ink('\x80', x, y), font_has_ink('?', x, y));
        assert_false(font_has_ink(' ', x, y));
    }
    assert_false(font_has_ink('A', -1, 0) || font_has_ink('A', 0, FONT_HEIGHT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_fill_rows),
        cmocka_unit_test(pictures_lie_in_order),
        cmocka_unit_test(what_cannot_be_is_reported),
        cmocka_unit_test(capacity_is_known_before),
        cmocka_unit_test(letters_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
