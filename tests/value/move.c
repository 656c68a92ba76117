/* Displaces along the unit tangents and normal. */
#include "tests/value/move.h"
#include "tests/value/documents.h"
#include <math.h>
#include <string.h>

/* Displaces a point; for a volume, to its highest point. */
static void move(const Surface *surface, bool volume, const OracleDisplacement *d,
                 double position[3])
{
    static const Group groups[] = {GROUP_DU, GROUP_DV, GROUP_N};
    const bool first = d->by[0] < d->by[1], second = d->by[2] < d->by[3];
    const double top = fmax(first ? d->by[1] : -INFINITY, second ? d->by[3] : -INFINITY);
    const double by[3] = {volume ? 0 : d->by[0], volume ? 0 : d->by[1],
                          !volume           ? d->by[2]
                          : first || second ? top
                                            : 0};
    memcpy(position, &surface->root[channel_id(GROUP_P, 0)], 3 * sizeof *position);
    for (int k = 0; k < 3; k++) {
        const double *along = &surface->root[channel_id(groups[k], 0)];
        const double size =
            fmax(sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]), 1e-30);
        for (int component = 0; component < 3; component++)
            position[component] += by[k] * along[component] / size;
    }
}

bool move_points(const char *path, int material, const MovePoints *points, double (*position)[3])
{
    Document d;
    const ReferenceContext context = {.noise = REFERENCE_LATTICE};
    bool fine = document_open(&d, path);
    Oracle *oracle = fine ? oracle_open(d.graph, &context) : NULL;
    for (int i = 0; fine && i < points->count; i++) {
        OracleDisplacement by;
        fine = oracle_displacement(oracle, d.graph->materials[material].node, &points->at[i], &by);
        move(&points->at[i], matc_has_volume(d.document, material), &by, position[i]);
    }
    oracle_close(oracle);
    document_close(&d);
    return fine;
}

bool move_normals(const char *path, int material, const MovePoints *points, double (*normal)[3])
{
    Document d;
    const ReferenceContext context = {.noise = REFERENCE_LATTICE};
    bool fine = document_open(&d, path);
    Oracle *oracle = fine ? oracle_open(d.graph, &context) : NULL;
    for (int i = 0; fine && i < points->count; i++) {
        SlotValues values;
        fine = oracle_material(oracle, d.graph->materials[material].node, &points->at[i], &values);
        memcpy(normal[i], values.component[SLOT_normal], 3 * sizeof **normal);
    }
    oracle_close(oracle);
    document_close(&d);
    return fine;
}
