#include "runtime/mesh_import/model_join.h"
#include "compiler/base/hash.h"
#include <stdlib.h>
#include <string.h>

bool model_join_open(ModelJoin *join, Shape *shape, unsigned corners)
{
    *join = (ModelJoin){.shape = shape,
                        .first = shape->vertex_count,
                        .joined = malloc(((size_t)corners + 1) * sizeof *join->joined)};
    return join->joined != NULL;
}

void model_join_close(ModelJoin *join)
{
    hash_index_free(&join->index);
    free(join->joined);
}

static uint32_t hash_of(const Shape *shape, int vertex)
{
    Key key = key_of_bytes(&shape->vertices[vertex], sizeof *shape->vertices);
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (shape->extra[i]) {
            const Key parts[] = {key,
                                 key_of_bytes(shape->extra[i][vertex], sizeof *shape->extra[i])};
            key = key_of_bytes(parts, sizeof parts);
        }
    return (uint32_t)key.low;
}

static bool equal(const Shape *shape, int a, int b)
{
    bool same = !memcmp(&shape->vertices[a], &shape->vertices[b], sizeof *shape->vertices);
    for (int i = 0; same && i < SHAPE_EXTRAS; i++)
        same = !shape->extra[i] ||
               !memcmp(shape->extra[i][a], shape->extra[i][b], sizeof *shape->extra[i]);
    return same;
}

bool model_join_add(ModelJoin *join, unsigned corner)
{
    Shape *shape = join->shape;
    const int added = shape->vertex_count;
    const uint32_t hash = hash_of(shape, added);
    HashProbe probe = hash_probe(&join->index, hash);
    while (hash_probe_next(&probe))
        if (equal(shape, join->first + (int)probe.number, added)) {
            join->joined[corner] = (uint32_t)join->first + probe.number;
            return true;
        }
    if (added >= MODEL_VERTICES)
        return false;
    hash_index_add(NULL, &join->index, hash, (uint32_t)(added - join->first));
    join->joined[corner] = (uint32_t)added;
    shape->vertex_count++;
    return true;
}
