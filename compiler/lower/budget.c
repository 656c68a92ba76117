/* --aa=auto: which maps are averaged over the pixel. Those whose means are closed forms, as long as the program costs at most a tenth
 * more than without any, by the costs of grammar/. It is measured on IR that is always simplified, so that
 * all levels of -O average the same maps; what is measured and fits is the program, which is not lowered again but for -O0.
 *
 *     wood with a sine: 109 operations without a mean, 174 with that of the sine. A GPU takes as long for the one as for the other, and
 *     for a constant (docs/accuracy-gpu.md), since there is other work to a pixel: FREE_COST counts at least, and 174 <= 1.1 * 200
 *     a checker beside much noise: 1124 without, 1183 with it, and 1183 <= 1.1 * 1124
 *
 * Tried are all means; points, unless the means are free or none; and, where not all fit, those that come first in the document, as many as
 * are found by what the programs with none and with all say of each map. Most programs are lowered once; where not all fit, four times or so.
 *
 * Every pass by its own program, so that another slot's noise pays for nothing. The shadow pass averages none: it compares with a threshold,
 * and of a mean that loses what is finer than a texel. A leaf of holes, half of it transparent by 0.7 and half by 0.1:
 *     at points: half of the texels are held, and the light's filter over the map makes a half shadow of that
 *     of means:  0.4 everywhere, and all are held
 *
 * A plane reaches the horizon, where every map is finer than a pixel: its pass may cost twice as much. */
#include "compiler/lower/lower.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    FREE_COST = 200, /* operations that a pixel has the time for anyway: 234 were measured to take none */
    MOST_SLOW = 2,   /* guesses after each other that may leave more than half */
    SURELY = 3       /* times what is left, by the first guess of a mean's cost: it does not fit */
};
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

/* Between how many means the last one that fits lies, and what programs with so many cost. */
typedef struct {
    int fit, beyond;
    double cost_fit, cost_beyond;
    const double *upto; /* by how many means: what the first so many add, about */
} Bracket;

/* What live nodes cost that were made for a map, by its index. */
static void add_costs(const Ir *ir, double sign, double *costs, int count)
{
    Arena scratch = {0};
    const uint8_t *live = ir_live(ir, &scratch);
    for (Ref ref = 1; ref < ir->count; ref++) {
        const Node *map = live[ref] ? ir_origin_map(ir, ir_at(ir, ref)->origin) : NULL;
        if (map && map->index < count)
            costs[map->index] += sign * ir_cost(ir, ref);
    }
    arena_free(&scratch);
}

/* Means cost as much as both programs say of their maps, in proportion to what programs at both ends of the bracket were found to cost: of 62 checkers
 * behind one noise the first pays for the slope of that. Where two guesses have left more than half, the middle is next.
 *
 *     none of 100 costs 200, all cost 2,200, each as much, and 220 may be spent: 1 is tried, and fits; 2 cost 240, and that is known
 *
 * So many as fit already: the next one alone costs SURELY times what is left, and is not tried. */
static int guess(const Bracket *b, double most, bool halve)
{
    const int between = b->beyond - b->fit;
    const double rise = b->cost_beyond - b->cost_fit, about = b->upto[b->beyond] - b->upto[b->fit];
    if (halve || !(rise > 0) || !(about > 0))
        return b->fit + (between / 2 > 1 ? between / 2 : 1);
    const double left = (most - b->cost_fit) * about / rise;
    if (b->upto[b->fit + 1] - b->upto[b->fit] > SURELY * fmax(left, most - b->cost_fit))
        return b->fit;
    int step = 1;
    while (step + 1 < between && b->upto[b->fit + step + 1] - b->upto[b->fit] <= left)
        step++;
    return b->fit + step;
}

/* Of a program that is gone. */
typedef struct {
    double cost;
    double *of_map; /* by index */
    int count;
} Cost;

static Cost cost_of(Trial *trial, Arena *arena)
{
    Cost cost = {.cost = trial->ir ? trial->cost : 0};
    for (size_t i = 0; i < trial->seen.count; i++)
        cost.count = trial->seen.at[i]->index >= cost.count ? trial->seen.at[i]->index + 1 : cost.count;
    cost.of_map = ARENA_ARRAY(arena, double, cost.count);
    if (trial->ir)
        add_costs(trial->ir, 1, cost.of_map, cost.count);
    return cost;
}

/* The one with as many means as fit, of those before the last, beside one that has none; all of them cost so much. The others are
 * dropped. */
static Trial *most_that_fit(const LowerRequest *what, Trial trials[2], double most, const Cost *all)
{
    Trial *next = &trials[0], *best = &trials[1];
    Bracket b = {.cost_fit = best->cost, .cost_beyond = all->cost};
    const int *ends = ends_of(what->session->arena, &best->seen, &b.beyond);
    double *upto = ARENA_ARRAY(what->session->arena, double, b.beyond + 1);
    add_costs(best->ir, -1, all->of_map, all->count);
    for (int i = 0, map = 0; i < b.beyond; i++) /* with what below it has slopes for it, which was resolved before it */
        for (upto[i + 1] = upto[i]; map < ends[i]; map++)
            upto[i + 1] += fmax(all->of_map[map], 0);
    b.upto = upto;
    int slow = 0; /* guesses that left more than half */
    while (b.fit + 1 < b.beyond) {
        const int before = b.beyond - b.fit, tried = guess(&b, most, slow == MOST_SLOW);
        if (tried == b.fit)
            break;
        try_below(next, what, ends[tried - 1]);
        const double cost = next->ir ? next->cost : 0; /* of one that failed nothing is known */
        if (fits(next, most)) {
            swap(&best, &next);
            b.fit = tried, b.cost_fit = cost;
        } else {
            b.beyond = tried, b.cost_beyond = cost;
        }
        slow = 2 * (b.beyond - b.fit) > before && slow < MOST_SLOW ? slow + 1 : 0;
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
    const Cost cost = cost_of(all, what->session->arena);
    drop(all);
    return plain->ir ? most_that_fit(what, trials, most, &cost) : plain;
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
