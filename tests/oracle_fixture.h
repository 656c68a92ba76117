/* Helpers of the oracle's tests: points, and comparison of a map's channel at a point with a
 * number. */
#ifndef MATC_ORACLE_FIXTURE_H
#define MATC_ORACLE_FIXTURE_H
#include "tests/graph_builder.h"
#include "compiler/oracle/oracle.h"
#include "tests/test.h"

/* Channel ids, named as in semantics.md. */
enum {
    PX = 0,
    NX = 4,
    NY,
    NZ,
    DPXDU = 8,
    DPYDU,
    DPZDU,
    DPXDV = 12,
    DPYDV,
    DPZDV,
    U = 16,
    V,
    W,
    X = 20,
    Y,
    Z,
    R = 24,
    G,
    B,
    A,
    IOR = 28
};

static const ReferenceContext groimp = {.noise = REFERENCE_GROIMP};

static inline void close_to(double got, double want, double tolerance)
{
    if (fabs(got - want) <= tolerance)
        return;
    fail_msg("got %.12g, want %.12g", got, want);
}

static inline double value_at(const Builder *b, const Node *map, int channel,
                              const Surface *surface)
{
    Oracle *oracle = oracle_open(&b->graph, &groimp);
    double value = oracle_channel(oracle, map, channel, surface);
    oracle_close(oracle);
    return value;
}

static inline void expect(const Builder *b, const Node *map, int channel, const Surface *surface,
                          double want)
{
    close_to(value_at(b, map, channel, surface), want, 1e-12 * fmax(1, fabs(want)));
}

static inline Surface at_uv(double u, double v)
{
    Surface s;
    oracle_surface_default(&s);
    s.root[U] = u;
    s.root[V] = v;
    return s;
}

static inline Surface at_xyz(double x, double y, double z)
{
    Surface s = at_uv(0, 0);
    s.root[X] = x;
    s.root[Y] = y;
    s.root[Z] = z;
    return s;
}

/* A surface point whose channels all differ. */
static inline Surface distinct(void)
{
    Surface s = {.front = true};
    for (int i = 0; i < CHANNEL_ID_COUNT; i++)
        s.root[i] = 100 + 7 * i;
    return s;
}
#endif
