/* Subdivision of patch edges by the view, and patches ordered by their number of parts, for
 * methods that draw patches of equal number together. */
#include "runtime/displace/displaced_method.h"
#include <stdlib.h>
#include <string.h>

/* Fills the buffer of drawn patches, ordered by the parts of their interiors: first[n] is the
 * first patch of n parts, and the last element is the end. Patches of 0 parts come first, and
 * are not drawn. */
static bool write_drawn(Displaced *d, int first[SCENE_PATCH_PARTS + 2])
{
    const int count = d->patches->count;
    uint32_t(*drawn)[2] = calloc((size_t)count + 1, sizeof *drawn);
    int next[SCENE_PATCH_PARTS + 2] = {0};
    if (!drawn)
        return gl_fail(displaced_context(d), "out of memory");
    for (int t = 0; t < count; t++)
        next[scene_patch_parts(d->parts[t]) + 1]++;
    for (int n = 1; n < SCENE_PATCH_PARTS + 2; n++)
        next[n] += next[n - 1];
    memcpy(first, next, sizeof next);
    for (int t = 0; t < count; t++) {
        const uint8_t *parts = d->parts[t];
        const int inside = scene_patch_parts(parts);
        uint32_t *row = drawn[next[inside]++];
        row[0] = (uint32_t)t;
        row[1] =
            parts[0] | (uint32_t)parts[1] << 8 | (uint32_t)parts[2] << 16 | (uint32_t)inside << 24;
    }
    const bool fine =
        displaced_fill(displaced_context(d), d->buffers[2], drawn, (size_t)count * sizeof *drawn);
    free(drawn);
    return fine;
}

/* Returns true if the written triangles contain the whole view with the required subdivision;
 * triangles outside the view may exist as well. */
static bool stands(const Displaced *d, uint8_t (*parts)[3])
{
    bool same = d->written;
    for (int t = 0; same && t < d->patches->count; t++)
        same = !parts[t][0] || !memcmp(parts[t], d->parts[t], sizeof parts[t]);
    return same;
}

bool displaced_parts(Displaced *d, const DisplacedView *view, int first[SCENE_PATCH_PARTS + 2])
{
    const size_t bytes = (size_t)d->patches->count * sizeof *d->parts;
    uint8_t(*parts)[3] = malloc(bytes + 1);
    if (!parts)
        return gl_fail(displaced_context(d), "out of memory");
    scene_patches_levels(d->patches, &view->scene->camera, view->size,
                         view->sight.count ? &view->sight : NULL, parts);
    d->anew = !stands(d, parts);
    if (d->anew)
        memcpy(d->parts, parts, bytes);
    free(parts);
    return !d->anew || write_drawn(d, first);
}

bool displaced_by_parts(Displaced *d, const int first[SCENE_PATCH_PARTS + 2],
                        const DisplacedByParts *by, Mesh *mesh)
{
    size_t triangles = 0, at = 0;
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++)
        triangles += (size_t)(first[n + 1] - first[n]) * by->triangles(d, n);
    displaced_reserve(d, mesh, 0, 3 * triangles * sizeof(MeshCaptured));
    displaced_begin(d);
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++)
        at = by->draw(d, &first[n], n, mesh, at);
    return displaced_end(d) && displaced_unshared(d, mesh, (int)triangles);
}
