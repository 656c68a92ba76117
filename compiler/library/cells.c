/* Cellular noise: each unit square or cube has one random point. Finds the nearest two points
 * and their cells by visiting rings of cells. compiler/library/cells.h proves that three rings
 * suffice. */
#include "compiler/library/cells.h"
#include <stdint.h>
#include <stdlib.h>

enum { PRIME = 761, PRIME_STEP = 17, PERIOD = 65536 }; /* constants of the float hash */
static const double TURN = 33554432;                   /* integer hash: period of 2^25 cells */

static bool of_floats(ReferenceNoise noise)
{
    return noise == REFERENCE_LATTICE_FLOAT || noise == REFERENCE_SIMPLEX_FLOAT ||
           noise == REFERENCE_GROIMP_FLOAT;
}

static uint32_t mixed(uint32_t h)
{
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    h = (h ^ (h >> 15)) * 0x846CA68Bu;
    return h ^ (h >> 16);
}

/* Returns the cell coordinate modulo the period; 0 for infinity and NaN. */
static uint32_t keyword_of(double cell)
{
    const double near = cell - TURN * floor(cell / TURN);
    return near >= 0 && near < TURN ? (uint32_t)near : 0;
}

static uint32_t cube(uint32_t x) { return x * x % PRIME * x % PRIME; }

/* Returns the hash of a coordinate in [0, 761); blocks of 761 cells differ. */
static uint32_t residue_of(double cell)
{
    const double near = cell - PERIOD * floor(cell / PERIOD);
    const uint32_t c = near >= 0 && near < PERIOD ? (uint32_t)near : 0, block = c / PRIME,
                   rest = c % PRIME;
    return cube((block * (rest + 3) + rest) % PRIME);
}

/* Random values of a cell: a point in [0, 1]^3 and a number in [0, 1). */
typedef struct {
    double place[3], number;
} Chance;

static Chance chance_of_words(const double cell[3], int dimensions)
{
    const uint32_t x = keyword_of(cell[0]) * 0x9E3779B1u, y = keyword_of(cell[1]) * 0x85EBCA77u;
    const uint32_t z =
        dimensions == 3 ? keyword_of(cell[2]) * 0xC2B2AE3Du + 0x165667B1u : 0x27D4EB2Fu;
    const uint32_t h = mixed(x ^ y ^ z), next = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    const double number = ldexp((next ^ (next >> 16)) >> 8, -24);
    if (dimensions == 2)
        return (Chance){{((h >> 16) + .5) / 65536, ((h & 65535) + .5) / 65536, .5}, number};
    return (Chance){
        {((h >> 21) + .5) / 2048, ((h >> 10 & 2047) + .5) / 2048, ((h & 1023) + .5) / 1024},
        number};
}

static Chance chance_of_floats(const double cell[3], int dimensions)
{
    const uint32_t line = cube(cube(residue_of(cell[0]) + PRIME_STEP) + residue_of(cell[1]));
    const uint32_t h = dimensions == 3 ? cube(line + residue_of(cell[2])) : line;
    return (Chance){{((h * 209 + 97) % PRIME + .5) / PRIME, ((h * 304 + 211) % PRIME + .5) / PRIME,
                     dimensions == 3 ? ((h * 373 + 523) % PRIME + .5) / PRIME : .5},
                    (cube(h + PRIME_STEP) + .5) / PRIME};
}

static double distance(const double a[3], CellsDistance how)
{
    if (how == CELLS_MANHATTAN)
        return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
    if (how == CELLS_CHEBYSHEV)
        return fmax(fmax(fabs(a[0]), fabs(a[1])), fabs(a[2]));
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* Gradient of the distance to a point by the sample position; it points away from the point. */
static void rise_of(const CellsPoint *point, CellsDistance how, double rise[3])
{
    for (int i = 0; i < 3; i++) {
        const double a = point->away[i], side = (a > 0) - (a < 0);
        if (how == CELLS_MANHATTAN)
            rise[i] = -side;
        else if (how == CELLS_CHEBYSHEV)
            rise[i] = fabs(a) == point->distance ? -side : 0;
        else
            rise[i] = point->distance > 0 ? -a / point->distance : 0;
    }
}

/* Orders points by distance; ties by cell, with x as the fastest axis, so that the visiting
 * order does not matter. */
static bool is_nearer(const CellsPoint *a, const CellsPoint *b)
{
    if (a->distance != b->distance)
        return a->distance < b->distance;
    for (int i = 2; i > 0; i--)
        if (a->cell[i] != b->cell[i])
            return a->cell[i] < b->cell[i];
    return a->cell[0] < b->cell[0];
}

static void meet(CellsPair *pair, const CellsPoint *point)
{
    if (is_nearer(point, &pair->first)) {
        pair->second = pair->first;
        pair->first = *point;
    } else if (is_nearer(point, &pair->second)) {
        pair->second = *point;
    }
}

static CellsPoint point_of(ReferenceNoise noise, const CellsQuestion *q, const int offset[3])
{
    double cell[3] = {0};
    for (int i = 0; i < q->dimensions; i++)
        cell[i] = floor(q->p[i]) + offset[i];
    const Chance chance = of_floats(noise) ? chance_of_floats(cell, q->dimensions)
                                           : chance_of_words(cell, q->dimensions);
    CellsPoint point = {.number = chance.number, .cell = {offset[0], offset[1], offset[2]}};
    for (int i = 0; i < q->dimensions; i++)
        point.away[i] =
            offset[i] - (q->p[i] - floor(q->p[i])) + .5 + q->jitter * (chance.place[i] - .5);
    point.distance = distance(point.away, q->how);
    return point;
}

/* Visits the cells at Chebyshev distance `ring` from the cell of p. */
static void meet_ring(ReferenceNoise noise, const CellsQuestion *q, int ring, CellsPair *pair)
{
    const int depth = q->dimensions == 3 ? ring : 0;
    for (int z = -depth; z <= depth; z++)
        for (int y = -ring; y <= ring; y++) {
            const bool whole = abs(z) == ring || abs(y) == ring;
            for (int x = -ring; x <= ring; x += whole ? 1 : 2 * ring) {
                const CellsPoint point = point_of(noise, q, (int[3]){x, y, z});
                meet(pair, &point);
            }
        }
}

/* A point of ring k is at least k - 1 away: the search ends once the second nearest point is
 * nearer. With p in the middle of a cell and both neighbors' points .9 away, only rings 0 and 1
 * are visited, 27 cells of 343. */
CellsPair cells_nearest(ReferenceNoise noise, const CellsQuestion *q)
{
    const CellsPoint none = {.distance = INFINITY};
    CellsPair pair = {.first = none, .second = none};
    for (int ring = 0; ring <= CELLS_REACH && ring - 1 <= pair.second.distance; ring++)
        meet_ring(noise, q, ring, &pair);
    return pair;
}

/* Arguments: p, a rest that is added to p, jitter (clamped to [0, 1]), metric. */
static CellsQuestion question(int dimensions, const double *args)
{
    CellsQuestion q = {.dimensions = dimensions};
    for (int i = 0; i < dimensions; i++)
        q.p[i] = args[i] + args[dimensions + i];
    q.jitter = fmin(fmax(args[2 * dimensions], 0), 1);
    q.how =
        (CellsDistance)whole_between(args[2 * dimensions + 1], CELLS_EUCLIDEAN, CELLS_CHEBYSHEV);
    return q;
}

static CellsPair answer(const void *context, int dimensions, const double *args)
{
    const CellsQuestion q = question(dimensions, args);
    return cells_nearest(((const ReferenceContext *)context)->noise, &q);
}

static double measure_of(const CellsPair *pair, double measure)
{
    return measure <= CELLS_FIRST    ? pair->first.distance
           : measure < CELLS_BETWEEN ? pair->second.distance
                                     : pair->second.distance - pair->first.distance;
}

/* Computes the gradient by p (0 to 2) and the value (3). */
static void rise(const void *context, int dimensions, const double *args, double result[4])
{
    const CellsPair pair = answer(context, dimensions, args);
    const CellsQuestion q = question(dimensions, args);
    const double measure = args[2 * dimensions + 2];
    double first[3], second[3];
    rise_of(&pair.first, q.how, first);
    rise_of(&pair.second, q.how, second);
    for (int i = 0; i < 3; i++)
        result[i] = measure <= CELLS_FIRST    ? first[i]
                    : measure < CELLS_BETWEEN ? second[i]
                                              : second[i] - first[i];
    result[3] = measure_of(&pair, measure);
}

REFERENCE(cells2)
{
    const CellsPair pair = answer(context, 2, args);
    result[0] = measure_of(&pair, args[6]);
}

REFERENCE(cells3)
{
    const CellsPair pair = answer(context, 3, args);
    result[0] = measure_of(&pair, args[8]);
}

REFERENCE(cells2Gradient) { rise(context, 2, args, result); }
REFERENCE(cells3Gradient) { rise(context, 3, args, result); }
REFERENCE(cellRandom)
{
    const double cell[3] = {floor(args[0]), floor(args[1]), floor(args[2])};
    const bool floats = of_floats(((const ReferenceContext *)context)->noise);
    result[0] = (floats ? chance_of_floats(cell, 3) : chance_of_words(cell, 3)).number;
}

REFERENCE(cells2Random) { result[0] = answer(context, 2, args).first.number; }
REFERENCE(cells3Random) { result[0] = answer(context, 3, args).first.number; }

static void centre(const void *context, int dimensions, const double *args, double *result)
{
    const CellsPair pair = answer(context, dimensions, args);
    const CellsQuestion q = question(dimensions, args);
    for (int i = 0; i < dimensions; i++)
        result[i] = q.p[i] + pair.first.away[i];
}

REFERENCE(cells2Centre) { centre(context, 2, args, result); }
REFERENCE(cells3Centre) { centre(context, 3, args, result); }

REFERENCE(cellsLoss)
{
    (void)context;
    const double bend = fmax(args[0] * (args[1] + args[2] * args[0]), 0);
    result[0] = isinf(bend) ? 1 : fmin(1.43 * bend / (1 + bend), 1);
}
