/* --aa=auto: which maps are averaged over the pixel. Those whose means are closed forms, as long as the program costs at most a tenth
 * more than without any, by the costs of grammar/. It is measured on IR that is lowered for that alone and always simplified, so that
 * all levels of -O average the same maps.
 *
 *     wood with a sine: 109 operations without a mean, 174 with that of the sine. A GPU takes as long for the one as for the other, and
 *     for a constant (docs/accuracy-gpu.md), since there is other work to a pixel: FREE_COST counts at least, and 174 <= 1.1 * 200
 *     a checker beside much noise: 1124 without, 1183 with it, and 1183 <= 1.1 * 1124
 *
 * Where not all fit, those do that come first in the document: as many as are found by halving.
 *
 * Every pass by its own program, so that another slot's noise pays for nothing. The shadow pass averages none: it compares with a threshold,
 * and of a mean that loses what is finer than a texel. A leaf of holes, half of it transparent by 0.7 and half by 0.1:
 *     at points: half of the texels are held, and the light's filter over the map makes a half shadow of that
 *     of means:  0.4 everywhere, and all are held
 *
 * A plane reaches the horizon, where every map is finer than a pixel: its pass may cost twice as much. */
#include "compiler/lower/lower.h"
#include <stdlib.h>

enum { FREE_COST = 200 }; /* operations that a pixel has the time for anyway: 234 were measured to take none */
static const double most_growth = 1.1, most_growth_of_plane = 2;

static int by_index(const void *a, const void *b)
{
    const Node *const *x = a, *const *y = b;
    return ((*x)->index > (*y)->index) - ((*x)->index < (*y)->index);
}

/* One more than the index of each, ascending, equal ones once. */
static int *ends_of(Arena *arena, const MapList *maps, int *count)
{
    int *ends = ARENA_ARRAY(arena, int, maps->count);
    *count = 0;
    qsort(maps->at, maps->count, sizeof(const Node *), by_index);
    for (size_t i = 0; i < maps->count; i++)
        if (!i || maps->at[i] != maps->at[i - 1])
            ends[(*count)++] = maps->at[i]->index + 1;
    return ends;
}

/* Diagnostics and memory of a trial are dropped. Negative: it failed. */
static int trial_cost(const LowerRequest *what, int below, MapList *seen)
{
    int nodes, cost = -1;
    Ir *ir = lower_averaging(what, below, seen);
    if (!ir)
        return cost;
    ir_measure(ir, &nodes, &cost);
    ir_done(ir);
    return cost;
}

/* Below which index maps are averaged. */
static int affordable(const LowerRequest *what)
{
    MapList maps;
    int count, plain = trial_cost(what, 0, &maps);
    if (plain < 0 || !maps.count)
        return 0;
    const int *ends = ends_of(what->session->arena, &maps, &count);
    const double growth = what->job->pass == PASS_plane ? most_growth_of_plane : most_growth;
    const double most = growth * (plain > FREE_COST ? plain : FREE_COST);
    int fits = 0, beyond = count + 1; /* so many fit, so many do not */
    for (int next = count; fits + 1 < beyond; next = fits + (beyond - fits) / 2) {
        int cost = trial_cost(what, ends[next - 1], NULL);
        if (cost >= 0 && cost <= most)
            fits = next;
        else
            beyond = next;
    }
    return fits ? ends[fits - 1] : 0;
}

static bool may_average(const Job *job) { return job->choice[AXIS_aa] == CHOICE_aa_auto && job->pass != PASS_shadow; }

Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job, Simplify *simplify)
{
    const LowerRequest what = {session, graph, material, job, simplify};
    if (!may_average(job))
        return lower_averaging(&what, 0, NULL);
    Arena arena = {0};
    Session trial = *session;
    trial.arena = &arena;
    trial.optimize = 1;
    const int below = affordable(&(LowerRequest){&trial, graph, material, job, simplify});
    arena_free(&arena);
    return lower_averaging(&what, below, NULL);
}
