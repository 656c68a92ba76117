/* Groups triangles by material; each part gets the vertices that its triangles use.
 *
 *     runs (material 1: 3 indices) (0: 6) (1: 3)     part 0: the second and the third triangle;
 *                                                    part 1: the first and the fourth */
#include "runtime/mesh_import/model_divide.h"
#include <stdlib.h>
#include <string.h>

static int by_material(const void *a, const void *b)
{
    const int first = ((const ModelPart *)a)->material, second = ((const ModelPart *)b)->material;
    return (first > second) - (first < second);
}

static ModelPart *find(ModelPart *parts, int count, int material)
{
    const ModelPart key = {.material = material};
    return bsearch(&key, parts, (size_t)count, sizeof *parts, by_material);
}

/* Lists the parts by ascending material, each with its index count. Returns the number of parts. */
static int list_parts(const ModelRun *runs, int run_count, ModelPart *parts)
{
    int count = 0;
    for (int i = 0; i < run_count; i++)
        parts[i] = (ModelPart){.material = runs[i].material};
    qsort(parts, (size_t)run_count, sizeof *parts, by_material);
    for (int i = 0; i < run_count; i++)
        if (!count || parts[i].material != parts[count - 1].material)
            parts[count++] = parts[i];
    for (int i = 0; i < run_count; i++)
        find(parts, count, runs[i].material)->shape.index_count += runs[i].index_count;
    return count;
}

/* Copies each part's triangles; their indices still refer to the whole shape. */
static bool take_indices(const Shape *shape, const ModelRun *runs, int run_count, ModelPart *parts,
                         int count)
{
    for (int i = 0; i < count; i++) {
        parts[i].shape.indices =
            malloc((size_t)parts[i].shape.index_count * sizeof *shape->indices + 1);
        if (!parts[i].shape.indices)
            return false;
        parts[i].shape.index_count = 0;
    }
    for (int i = 0, from = 0; i < run_count; from += runs[i++].index_count) {
        Shape *own = &find(parts, count, runs[i].material)->shape;
        memcpy(own->indices + own->index_count, shape->indices + from,
               (size_t)runs[i].index_count * sizeof *own->indices);
        own->index_count += runs[i].index_count;
    }
    return true;
}

/* Copies a part's vertices in the order of first use, and renumbers its indices. `place` maps a
 * vertex to its number + 1; values up to `taken` belong to earlier parts. */
static bool take_vertices(const Shape *shape, uint32_t *place, uint32_t taken, Shape *own)
{
    for (int i = 0; i < own->index_count; i++)
        if (place[own->indices[i]] <= taken)
            place[own->indices[i]] = taken + (uint32_t)++own->vertex_count;
    own->vertices = malloc((size_t)own->vertex_count * sizeof *own->vertices + 1);
    memcpy(own->names, shape->names, sizeof own->names);
    bool allocated = own->vertices != NULL;
    for (int i = 0; allocated && i < SHAPE_EXTRAS; i++)
        if (shape->extra[i]) {
            own->extra[i] = calloc((size_t)own->vertex_count + 1, sizeof *own->extra[i]);
            allocated = own->extra[i] != NULL;
        }
    for (int i = 0; allocated && i < own->index_count; i++) {
        const uint32_t from = own->indices[i];
        own->indices[i] = place[from] - taken - 1;
        own->vertices[own->indices[i]] = shape->vertices[from];
        shape_copy_extras(own, own->indices[i], shape, from);
    }
    return allocated;
}

bool model_divide(const Shape *shape, const ModelRun *runs, int run_count, ModelPart **made,
                  int *count)
{
    ModelPart *parts = calloc((size_t)run_count + 1, sizeof *parts);
    uint32_t *place = calloc((size_t)shape->vertex_count + 1, sizeof *place), taken = 0;
    bool done = parts && place;
    *count = done ? list_parts(runs, run_count, parts) : 0;
    done = done && take_indices(shape, runs, run_count, parts, *count);
    for (int i = 0; done && i < *count; taken += (uint32_t)parts[i++].shape.vertex_count)
        done = take_vertices(shape, place, taken, &parts[i].shape);
    free(place);
    for (int i = 0; !done && i < *count; i++)
        shape_free(&parts[i].shape);
    if (!done) {
        free(parts);
        *count = 0;
        parts = NULL;
    }
    *made = parts;
    return done;
}
