/* Arrays from malloc that grow. */
#ifndef MATC_SCENE_ROOM_H
#define MATC_SCENE_ROOM_H
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Room for `count` elements in an array that has it for *room; `array` is where the pointer to it
 * lies. False: memory ran out, and all is as before. */
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
