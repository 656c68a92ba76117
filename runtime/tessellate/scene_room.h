/* Growing arrays from malloc. */
#ifndef MATC_SCENE_ROOM_H
#define MATC_SCENE_ROOM_H
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Ensures capacity for `count` elements in an array with capacity *room; `array` is the address
 * of the pointer to the array. False: out of memory, and the array is unchanged. */
static inline bool scene_room(void *array, size_t count, size_t *room, size_t size)
{
    const size_t least = 1024;
    size_t next = *room ? *room : least;
    void *at;
    while (next < count)
        next *= 2;
    if (next == *room)
        return true;
    memcpy(&at, array, sizeof at);
    at = realloc(at, next * size);
    if (!at)
        return false;
    memcpy(array, &at, sizeof at);
    *room = next;
    return true;
}
#endif
