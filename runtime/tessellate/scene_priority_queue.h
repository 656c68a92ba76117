/* Priority queue of triangles by error: a binary heap, the largest first. */
#ifndef MATC_SCENE_PRIORITY_QUEUE_H
#define MATC_SCENE_PRIORITY_QUEUE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    double error;
    uint32_t triangle, stamp; /* valid as long as the triangle has that stamp */
} ScenePriority;

typedef struct {
    ScenePriority *ranks;
    size_t count, capacity;
} ScenePriorityQueue;

/* Inserts a triangle with its error. False: out of memory. */
bool scene_priority_queue_put(ScenePriorityQueue *ranks, ScenePriority rank);
/* Removes the largest; the queue must not be empty. */
ScenePriority scene_priority_queue_take(ScenePriorityQueue *ranks);
void scene_priority_queue_end(ScenePriorityQueue *ranks);
#endif
