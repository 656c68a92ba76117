/* A table with one row per function that a public header declares; a function without a row
 * fails the test.
 *
 *   static const ApiRow rows[] = {{"matc_read", wrong_read}, ...};
 *   api_rows_run("compiler/matc.h", rows, sizeof rows / sizeof *rows); */
#ifndef API_ROWS_H
#define API_ROWS_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *name;
    void (*ask)(void); /* Calls the function with every kind of wrong argument. */
} ApiRow;

enum { API_NAME = 64 };

/* Reads a whole file; from malloc. */
static char *api_text(const char *path)
{
    enum { MOST = 1 << 18 };
    char *text = calloc(MOST, 1);
    FILE *file = fopen(path, "r");
    assert_true(text && file);
    assert_in_range(fread(text, 1, MOST - 1, file), 1, MOST - 2);
    fclose(file);
    return text;
}

/* Finds the next function that is declared with MATC_API. Returns the text after its name, or
 * NULL. */
static const char *api_next(const char *text, char name[API_NAME])
{
    const char *at = strstr(text, "\nMATC_API ");
    const char *end = at ? strchr(at, '(') : NULL;
    if (!end)
        return NULL;
    const char *begin = end;
    while (begin[-1] == '_' || (begin[-1] >= 'a' && begin[-1] <= 'z') ||
           (begin[-1] >= '0' && begin[-1] <= '9'))
        begin--;
    assert_true(end - begin > 0 && end - begin < API_NAME);
    memcpy(name, begin, (size_t)(end - begin));
    name[end - begin] = 0;
    return end;
}

/* Checks that each function of the header has a row and each row a function, then calls all
 * rows. */
static void api_rows_run(const char *header, const ApiRow *rows, size_t count)
{
    char path[4096], name[API_NAME];
    size_t declared = 0;
    snprintf(path, sizeof path, "%s/%s", SOURCE_FOLDER, header);
    char *text = api_text(path);
    for (const char *at = text; (at = api_next(at, name)); declared++) {
        size_t row = 0;
        while (row < count && strcmp(rows[row].name, name) != 0)
            row++;
        if (row == count)
            fail_msg("%s: no row calls %s with wrong arguments", header, name);
    }
    assert_true(declared > 10);
    assert_int_equal(declared, count);
    free(text);
    for (size_t i = 0; i < count; i++)
        rows[i].ask();
}
#endif
