/* Along the unit vectors of tangents and normal. */
#include "tests/value/move.h"
#include "tests/value/documents.h"
#include <math.h>
#include <string.h>

static void move(const Surface *surface, const OracleDisplacement *d, double position[3])
{
    static const Group groups[] = {GROUP_DU, GROUP_DV, GROUP_N};
    memcpy(position, &surface->root[channel_id(GROUP_P, 0)], 3 * sizeof *position);
    for (int k = 0; k < 3; k++) {
        const double *along = &surface->root[channel_id(groups[k], 0)];
        const double size = fmax(sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]), 1e-30);
        for (int lane = 0; lane < 3; lane++)
            position[lane] += d->by[k] * along[lane] / size;
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
        move(&points->at[i], &by, position[i]);
    }
    oracle_close(oracle);
    document_close(&d);
    return fine;
}
