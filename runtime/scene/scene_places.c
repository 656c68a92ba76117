/* Groups vertices by position, and computes their common displacement attributes. */
#include "runtime/scene/scene_places.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include <stdlib.h>
#include <string.h>

int *scene_places(const Shape *shape)
{
    int *first = calloc((size_t)shape->vertex_count + 1, sizeof *first);
    HashIndex index = {0};
    for (int i = 0; first && i < shape->vertex_count; i++) {
        float place[3];
        for (int component = 0; component < 3; component++)
            place[component] = shape->vertices[i].position[component] + 0.f; /* -0 becomes 0 */
        const uint32_t hash = (uint32_t)key_of_bytes(place, sizeof place).low;
        HashProbe probe = hash_probe(&index, hash);
        first[i] = i;
        while (first[i] == i && hash_probe_next(&probe)) {
            const float *other = shape->vertices[probe.number].position;
            if (other[0] == place[0] && other[1] == place[1] && other[2] == place[2])
                first[i] = (int)probe.number;
        }
        if (first[i] == i)
            hash_index_add(NULL, &index, hash, (uint32_t)i);
    }
    hash_index_free(&index);
    return first;
}

void scene_places_join(const Shape *shape, const int *first, ShapeVertex *joined)
{
    for (int i = 0; i < shape->vertex_count; i++) {
        const float *n = shape->vertices[i].normal;
        if (first[i] == i)
            joined[i] = shape->vertices[i];
        else if (memcmp(n, shape->vertices[first[i]].normal, sizeof shape->vertices[i].normal) != 0)
            for (int component = 0; component < 3; component++)
                joined[first[i]].normal[component] += n[component];
    }
}
