/* tests/functions.def as a table. */
#include "cases.h"
#include <string.h>

#define PLACE(size, far)                                                                                               \
    {                                                                                                                  \
        FORM_place, size, far                                                                                          \
    }
#define RANGE(low, high)                                                                                               \
    {                                                                                                                  \
        FORM_range, low, high                                                                                          \
    }
#define WIDTH(least, most)                                                                                             \
    {                                                                                                                  \
        FORM_width, least, most                                                                                        \
    }
#define WIDE(least, most)                                                                                              \
    {                                                                                                                  \
        FORM_wide, least, most                                                                                         \
    }
#define WHOLE(low, high)                                                                                               \
    {                                                                                                                  \
        FORM_whole, low, high                                                                                          \
    }
#define RATIO                                                                                                          \
    {                                                                                                                  \
        FORM_ratio, 0, 0                                                                                               \
    }
#define UNIT                                                                                                           \
    {                                                                                                                  \
        FORM_unit, 0, 0                                                                                                \
    }
#define REST                                                                                                           \
    {                                                                                                                  \
        FORM_rest, 0, 0                                                                                                \
    }
#define PICTURE                                                                                                        \
    {                                                                                                                  \
        FORM_texture, 0, 0                                                                                             \
    }
#define RELIEF                                                                                                         \
    {                                                                                                                  \
        FORM_texture, 1, 0                                                                                             \
    }
#define SIZE                                                                                                           \
    {                                                                                                                  \
        FORM_size, 0, 0                                                                                                \
    }
#define AFFINE                                                                                                         \
    {                                                                                                                  \
        FORM_affine, 0, 0                                                                                              \
    }
#define SKY                                                                                                            \
    {                                                                                                                  \
        FORM_sky, 0, 0                                                                                                 \
    }
const FunctionCase function_cases[] = {
#define CASE(function, bound, unit, reach, ...) {#function, bound, UNIT_##unit, reach, {__VA_ARGS__}},
#include "tests/functions.def"
};
const int case_count = sizeof function_cases / sizeof *function_cases;

int function_find(const char *name)
{
    for (int i = 0; i < FUNCTION_COUNT; i++)
        if (function_row(i)->name && !strcmp(function_row(i)->name, name))
            return i;
    return FN_none;
}
