/* --aa=auto: which maps are averaged over the pixel. Those whose means are closed forms, as long as the program costs at most a tenth
 * more than without any, by the costs of grammar/. It is measured on IR that is always simplified, so that
 * all levels of -O average the same maps; what is measured and fits is the program, which is not lowered again but for -O0.
 *
 *     wood with a sine: 109 operations without a mean, 174 with that of the sine. A GPU takes as long for the one as for the other, and
 *     for a constant (docs/accuracy-gpu.md), since there is other work to a pixel: FREE_COST counts at least, and 174 <= 1.1 * 200
 *     a checker beside much noise: 1124 without, 1183 with it, and 1183 <= 1.1 * 1124
 *
 * Tried are all means; points, unless the means are free or none; and, where not all fit, those that come first in the document, as many as
 * are found by halving. Most programs are lowered once.
 *
 * Every pass by its own program, so that another slot's noise pays for nothing. The shadow pass averages none: it compares with a threshold,
 * and of a mean that loses what is finer than a texel. A leaf of holes, half of it transparent by 0.7 and half by 0.1:
 *     at points: half of the texels are held, and the light's filter over the map makes a half shadow of that
 *     of means:  0.4 everywhere, and all are held
 *
 * A plane reaches the horizon, where every map is finer than a pixel: its pass may cost twice as much. */
#include "compiler/lower/lower.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>

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

/* A lowering in memory of its own, with diagnostics of its own, which goes without a trace unless it is taken. It stays where it is. */
typedef struct {
    Arena arena;
    Session session;
    Ir *ir;       /* NULL: it failed, or went */
    MapList seen; /* the maps that may be averaged */
    int below;    /* which index they are */
    int cost;
} Trial;

static DiagList copy_of_diags(Arena *arena, const DiagList *diags)
{
    DiagList copy = {.at = ARENA_ARRAY(arena, Diag, diags->count),
                     .count = diags->count,
                     .room = diags->count,
                     .errors = diags->errors};
    if (copy.count)
        memcpy(copy.at, diags->at, copy.count * sizeof *copy.at);
    return copy;
}

static void try_below(Trial *trial, const LowerRequest *what, int below)
{
    int nodes;
    *trial = (Trial){.session = *what->session, .below = below};
    trial->session.arena = &trial->arena;
    trial->session.optimize = 1;
    trial->session.diags = copy_of_diags(&trial->arena, &what->session->diags);
    LowerRequest own = *what;
    own.session = &trial->session;
    trial->ir = lower_averaging(&own, below, &trial->seen);
    if (trial->ir)
        ir_measure(trial->ir, &nodes, &trial->cost);
}

static void drop(Trial *trial)
{
    if (trial->ir)
        ir_done(trial->ir);
    trial->ir = NULL;
    arena_free(&trial->arena);
}

/* The program of a trial, which moves into the session. */
static Ir *take(Trial *trial, Session *session)
{
    Ir *ir = trial->ir;
    trial->ir = NULL;
    session->diags = trial->session.diags;
    arena_adopt(session->arena, &trial->arena);
    ir->session = session;
    ir->arena = session->arena;
    return ir;
}

static bool fits(const Trial *trial, double most) { return trial->ir && trial->cost <= most; }

static void swap(Trial **a, Trial **b)
{
    Trial *c = *a;
    *a = *b;
    *b = c;
}

/* The one with as many means as fit, of those before the last, beside one that has none. The others are dropped. */
static Trial *halve(const LowerRequest *what, Trial *plain, Trial *spare, double most)
{
    int count;
    const int *ends = ends_of(what->session->arena, &plain->seen, &count);
    Trial *best = plain, *next = spare;
    int fit = 0, beyond = count; /* so many fit, so many do not */
    while (fit + 1 < beyond) {
        const int middle = fit + (beyond - fit) / 2;
        try_below(next, what, ends[middle - 1]);
        if (fits(next, most)) {
            swap(&best, &next);
            fit = middle;
        } else {
            beyond = middle;
        }
        drop(next);
    }
    return best;
}

/* The one to take, of two that are made here; the other one is dropped. */
static Trial *affordable(const LowerRequest *what, Trial trials[2])
{
    const double growth = what->job->pass == PASS_plane ? most_growth_of_plane : most_growth;
    Trial *all = &trials[0], *plain = &trials[1];
    try_below(all, what, INT_MAX);
    if (all->ir && (!all->seen.count || fits(all, growth * FREE_COST)))
        return all;
    try_below(plain, what, 0);
    const double most = growth * (plain->cost > FREE_COST ? plain->cost : FREE_COST);
    if (plain->ir && fits(all, most)) {
        drop(plain);
        return all;
    }
    drop(all);
    return plain->ir ? halve(what, plain, all, most) : plain;
}

static bool may_average(const Job *job) { return job->choice[AXIS_aa] == CHOICE_aa_auto && job->pass != PASS_shadow; }

Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job, Simplify *simplify)
{
    const LowerRequest what = {session, graph, material, job, simplify};
    if (!may_average(job))
        return lower_averaging(&what, 0, NULL);
    Trial trials[2] = {0};
    Trial *best = affordable(&what, trials);
    if (best->ir && session->optimize > 0)
        return take(best, session);
    const int below = best->ir ? best->below : 0;
    drop(best);
    return lower_averaging(&what, below, NULL);
}
