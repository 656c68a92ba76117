#include "runtime/mesh_import/model_text.h"
#include "compiler/base/memory.h"
#include "compiler/base/root.h"
#include "compiler/base/text.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    DIGITS = 18 /* significant digits that are read */,
    MAX_EXPONENT = 9999,
    FIRST_CAPACITY = 64
};

static char *read_descriptor(int descriptor, size_t *size)
{
    struct stat info;
    if (fstat(descriptor, &info) || info.st_size > (off_t)MODEL_FILE_MIB << 20)
        return NULL;
    const size_t wanted = (size_t)info.st_size;
    char *bytes = memory_checked(malloc(wanted + 1));
    ssize_t got = 1;
    for (*size = 0; *size < wanted && got > 0; *size += got > 0 ? (size_t)got : 0)
        got = read(descriptor, bytes + *size, wanted - *size);
    bytes[*size] = 0;
    return bytes;
}

char *model_text_read(const ModelSource *source, size_t *size, char *error, size_t capacity)
{
    const char *why = "the file cannot be read";
    const int descriptor = root_open(source->root, source->path, &why);
    char *bytes = descriptor < 0 ? NULL : read_descriptor(descriptor, size);
    if (descriptor >= 0)
        close(descriptor);
    if (!bytes)
        message_fail(error, capacity, "%s", why);
    return bytes;
}

static bool is_delimiter(char c) { return !c || strchr(" \t\r\n\v\f\\#", c); }

/* Reads digits into a mantissa; those beyond DIGITS only move the exponent. Returns their count. */
static int read_digits(const char **at, uint64_t *mantissa, int *used, int64_t *exponent)
{
    int count = 0;
    for (; text_is_digit(**at); ++*at, count++)
        if (*used < DIGITS) {
            *mantissa = *mantissa * 10 + (uint64_t)(**at - '0');
            *used += *mantissa > 0;
        } else
            ++*exponent;
    return count;
}

/* Multiplies by a power of ten; exact for the numbers that programs write. */
static double scale(double mantissa, int64_t exponent)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    enum { EXACT = sizeof powers / sizeof *powers };
    if (exponent > -EXACT && exponent < EXACT)
        return exponent < 0 ? mantissa / powers[-exponent] : mantissa * powers[exponent];
    return mantissa > 0 ? mantissa * pow(10, (double)exponent) : 0;
}

bool model_text_number(const char **at, double *value)
{
    const char *next = *at;
    const bool negative = *next == '-';
    next += *next == '-' || *next == '+';
    uint64_t mantissa = 0;
    int64_t exponent = 0, beyond = 0;
    int used = 0, count = read_digits(&next, &mantissa, &used, &exponent);
    if (*next == '.') {
        next++;
        const int places = read_digits(&next, &mantissa, &used, &beyond);
        exponent += beyond - places;
        count += places;
    }
    if (count && (*next == 'e' || *next == 'E')) {
        int64_t power;
        next++;
        if (!model_text_integer(&next, &power))
            return false;
        exponent += power < -MAX_EXPONENT  ? -MAX_EXPONENT
                    : power > MAX_EXPONENT ? MAX_EXPONENT
                                           : power;
    }
    if (!count || !is_delimiter(*next))
        return false;
    *value = scale((double)mantissa, exponent) * (negative ? -1 : 1);
    *at = next;
    return isfinite((float)*value);
}

bool model_text_integer(const char **at, int64_t *value)
{
    const char *next = *at;
    const bool negative = *next == '-';
    next += *next == '-' || *next == '+';
    if (!text_is_digit(*next))
        return false;
    for (*value = 0; text_is_digit(*next); next++)
        if (*value <= INT32_MAX)
            *value = *value * 10 + (*next - '0');
    *value = *value > INT32_MAX ? INT32_MAX : *value;
    *value = negative ? -*value : *value;
    *at = next;
    return true;
}

void *model_text_grow(void *array, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity)
        return array;
    *capacity = *capacity ? *capacity * 2 : FIRST_CAPACITY;
    return memory_checked(realloc(array, *capacity * size));
}
