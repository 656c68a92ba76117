/* tests/functions.def and the POINTS lines of grammar/maps.def as a table. */
#include "cases.h"
#include "compiler/library/java_random.h"
#include <math.h>

#define POSITION(size, far)                                                                        \
    {                                                                                              \
        FORM_position, size, far                                                                   \
    }
#define RANGE(low, high)                                                                           \
    {                                                                                              \
        FORM_range, low, high                                                                      \
    }
#define WIDTH(least, most)                                                                         \
    {                                                                                              \
        FORM_width, least, most                                                                    \
    }
#define WIDE(least, most)                                                                          \
    {                                                                                              \
        FORM_wide, least, most                                                                     \
    }
#define WHOLE(low, high)                                                                           \
    {                                                                                              \
        FORM_whole, low, high                                                                      \
    }
#define RATIO                                                                                      \
    {                                                                                              \
        FORM_ratio, 0, 0                                                                           \
    }
#define UNIT                                                                                       \
    {                                                                                              \
        FORM_unit, 0, 0                                                                            \
    }
#define REST                                                                                       \
    {                                                                                              \
        FORM_rest, 0, 0                                                                            \
    }
#define PICTURE                                                                                    \
    {                                                                                              \
        FORM_texture, 0, 0                                                                         \
    }
#define RELIEF                                                                                     \
    {                                                                                              \
        FORM_texture, 1, 0                                                                         \
    }
#define SIZE                                                                                       \
    {                                                                                              \
        FORM_size, 0, 0                                                                            \
    }
#define AFFINE                                                                                     \
    {                                                                                              \
        FORM_affine, 0, 0                                                                          \
    }
#define SKY                                                                                        \
    {                                                                                              \
        FORM_sky, 0, 0                                                                             \
    }
const FunctionCase function_cases[] = {
#define CASE(function, bound, unit, reach, ...)                                                    \
    {FN_##function, bound, UNIT_##unit, reach, {__VA_ARGS__}},
#include "tests/functions.def"
#define POINTS(map, bound, unit, reach, ...)                                                       \
    {FN_FIRST_MAP + KIND_##map, bound, UNIT_##unit, reach, {__VA_ARGS__}},
#include "grammar/maps.def"
};
const int case_count = sizeof function_cases / sizeof *function_cases;

/* The arguments of a parameter; one without a range is drawn from numbers of moderate size. */
static Argument argument_of(const ParamRow *row)
{
    const double most = 16;
    bool bounded = row->low > -INFINITY && row->high < INFINITY;
    return (Argument){row->type == PARAM_Int ? FORM_whole : FORM_range, bounded ? row->low : -most,
                      bounded ? row->high : most};
}

FunctionCase case_of_ranges(Kind kind)
{
    enum { FIRST_OWN = 4 }; /* number of parameters in VOLUME_PARAMS */
    const KindRow *row = &kind_table[kind];
    FunctionCase all = {FN_FIRST_MAP + (int)kind, 1e-5, UNIT_MIXED, 4, {POSITION(4, 1e4)}};
    for (int i = FIRST_OWN; i < row->count; i++)
        all.arguments[1 + i - FIRST_OWN] = argument_of(&param_table[row->first + i]);
    return all;
}

uint64_t case_random(const FunctionCase *row, int seed)
{
    uint64_t number = (uint64_t)seed;
    for (const char *letter = function_row(row->function)->name; *letter; letter++)
        number = number * 131 + (unsigned char)*letter;
    return java_random((int64_t)number);
}
