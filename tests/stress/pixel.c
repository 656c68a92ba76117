/* Replaces every dFdx and dFdy by its argument times a factor, in place of the driver's
 * difference between two pixels. */
#include "pixel.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Pixel pixel_number(long index)
{
    static const Pixel pixels[] = {{0, 0},          {1e-3, -7e-4}, {0.3, 0.01},  {0, 1e-3},
                                   {1e-30, -1e-25}, {40, -1e-2},   {1e-7, 3e-7}, {1e4, -1e4},
                                   {-1, 1},         {1e-6, 1e-38}};
    return pixels[(unsigned long)index % (sizeof pixels / sizeof *pixels)];
}

void pixel_inputs(Pixel pixel, double inputs[INPUT_COUNT][4])
{
    for (int i = 0; i < change_count; i++) {
        double part = strcmp(change_table[i].by, "dFdx") ? pixel.up : pixel.right;
        for (int component = 0; component < 4; component++)
            inputs[change_table[i].input][component] = part * inputs[change_table[i].of][component];
    }
}

/* Inserts the definitions after the #version line. */
char *pixel_program(Pixel pixel, const char *fragment)
{
    size_t capacity = strlen(fragment) + 128, head = strcspn(fragment, "\n") + 1;
    char *text = malloc(capacity);
    if (!text)
        abort();
    snprintf(text, capacity,
             "%.*s#define dFdx(v) ((v) * (%.9e))\n#define dFdy(v) ((v) * (%.9e))\n%s", (int)head,
             fragment, pixel.right, pixel.up, fragment + head);
    return text;
}
