#include "runtime/tessellate/scene_priority_queue.h"
#include "runtime/tessellate/scene_growing.h"
#include <stdlib.h>

bool scene_priority_queue_put(ScenePriorityQueue *ranks, ScenePriority rank)
{
    if (!scene_growing(&ranks->ranks, ranks->count + 1, &ranks->capacity, sizeof *ranks->ranks))
        return false;
    size_t at = ranks->count++;
    for (; at && ranks->ranks[(at - 1) / 2].error < rank.error; at = (at - 1) / 2)
        ranks->ranks[at] = ranks->ranks[(at - 1) / 2];
    ranks->ranks[at] = rank;
    return true;
}

ScenePriority scene_priority_queue_take(ScenePriorityQueue *ranks)
{
    const ScenePriority top = ranks->ranks[0], last = ranks->ranks[--ranks->count];
    size_t at = 0;
    for (size_t next = 1; next < ranks->count; next = 2 * at + 1) {
        if (next + 1 < ranks->count && ranks->ranks[next + 1].error > ranks->ranks[next].error)
            next++;
        if (ranks->ranks[next].error <= last.error)
            break;
        ranks->ranks[at] = ranks->ranks[next];
        at = next;
    }
    ranks->ranks[at] = last;
    return top;
}

void scene_priority_queue_end(ScenePriorityQueue *ranks)
{
    free(ranks->ranks);
    *ranks = (ScenePriorityQueue){0};
}
