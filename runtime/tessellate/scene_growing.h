/* Growing arrays from malloc. */
#ifndef MATC_SCENE_GROWING_H
#define MATC_SCENE_GROWING_H
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Ensures capacity for `count` elements in an array with capacity *capacity; `array` is the
 * address of the pointer to the array. False: out of memory, and the array is unchanged. */
static inline bool scene_growing(void *array, size_t count, size_t *capacity, size_t size)
{
    const size_t least = 1024;
    size_t next = *capacity ? *capacity : least;
    void *at;
    while (next < count)
        next *= 2;
    if (next == *capacity)
        return true;
    memcpy(&at, array, sizeof at);
    at = realloc(at, next * size);
    if (!at)
        return false;
    memcpy(array, &at, sizeof at);
    *capacity = next;
    return true;
}
#endif
