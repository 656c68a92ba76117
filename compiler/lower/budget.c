/* --aa=auto: selects the maps that are averaged over the pixel. Candidates have closed-form
 * means; they are taken as long as the program costs at most a tenth more than without any, by
 * the costs of grammar/. Costs are measured on IR that is always simplified, so that all levels
 * of -O average the same maps. A measured program that fits is the result, and is lowered again
 * only for -O0.
 *
 *     wood with a sine: 109 operations without a mean, 174 with that of the sine. A GPU takes as
 *     long for either, and for a constant (docs/results/accuracy-gpu.md), since a pixel has
 *     other work too: at least FREE_COST counts, and 174 <= 1.1 * 200
 *     a checker next to much noise: 1124 without, 1183 with its mean, and 1183 <= 1.1 * 1124
 *
 * If the tables of grammar/ estimate that all means may fit, a program with all of them is made
 * first. It is taken if its means are free, or cost at most a tenth more than points. The cost
 * of points is measured on a fork of its IR, in which only values that contain a mean are
 * lowered again. Otherwise the program of points is made first. The additional cost of each
 * map's mean is known without a program of it (price.h), and only what should fit is tried: all
 * means, or those that come first in the document. Most programs are lowered once, also if no
 * mean fits; if some fit, about twice.
 *
 * Every pass is decided by its own program, so that noise in another slot does not raise the
 * budget. The shadow pass averages no map: it compares with a threshold, and a mean would lose
 * detail finer than a texel. A leaf with holes, half of it transparent by 0.7 and half by 0.1:
 *     at points: half of the texels are kept, and the light's filter over the map makes a half
 *     shadow of them
 *     means: 0.4 everywhere, and all texels are kept
 *
 * A plane reaches the horizon, where every map is finer than a pixel: its pass may cost twice as
 * much. */
#include "compiler/lower/price.h"
#include <limits.h>
#include <math.h>
#include <string.h>

enum {
    /* operations that are hidden behind a pixel's other work: 234 took no measurable time */
    FREE_COST = 200,
    MEAN_COST = 30,         /* estimated operations that a mean adds; a Checker's mean adds 32 */
    LARGEST_GUESSED = 1000, /* only cheaper programs, by estimate, are tried with all means first */
    MAX_SLOW = 2            /* max consecutive guesses that leave more than half of the range */
};
/* A mean whose price exceeds the remaining budget by this factor does not fit. */
static const double SURELY = 1.1, SURELY_MINGLED = 3;
static const double most_growth = 1.1, most_growth_of_plane = 2;

/* A tentative lowering with its own memory and diagnostics, which are discarded unless the
 * result is taken. A Trial must not be moved. */
typedef struct {
    Arena arena;
    Session session;
    Lower lower;
    Ir *ir;       /* IR of the trial; NULL: lowering failed, or the IR was dropped */
    MapList seen; /* the maps that may be averaged over the pixel */
    int below;    /* index below which maps are averaged */
    int cost;     /* cost of the program in operations, if `seen` has any map */
} Trial;

static DiagList copy_of_diags(Arena *arena, const DiagList *diags)
{
    DiagList copy = {.at = ARENA_ARRAY(arena, Diag, diags->count),
                     .count = diags->count,
                     .capacity = diags->count,
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
    trial->ir = lower_averaging(&trial->lower, &own, below);
    trial->seen = trial->lower.averageable;
    if (trial->ir && trial->seen.count)
        ir_measure(trial->ir, &nodes, &trial->cost);
}

static void drop(Trial *trial)
{
    if (trial->ir)
        ir_done(trial->ir);
    trial->ir = NULL;
    arena_free(&trial->arena);
}

/* Moves a trial's program into the session. */
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

/* Bounds of the number of means that fit: `fit` means fit, `beyond` do not; and the cost of
 * programs with as many. */
typedef struct {
    int fit, beyond;
    double cost_fit, cost_beyond;
    /* indexed by number of means n: approximate additional cost of the first n */
    const double *upto;
    double surely; /* factor on the remaining budget */
} Bracket;

/* Returns the number of means to try next: interpolates by their prices, scaled to the measured
 * costs at both ends of the bracket. After MAX_SLOW guesses that left more than half of the range,
 * bisects.
 *
 *     without means 200, with all 100 means 2,200, each costs as much, and 220 may be spent: 1
 *     is tried, and fits; 2 cost 240, which is then known
 *
 * Returns `fit` if the next mean alone surely costs more than the remaining budget. */
static int guess(const Bracket *b, double most, bool halve)
{
    const int between = b->beyond - b->fit;
    const double rise = b->cost_beyond - b->cost_fit, about = b->upto[b->beyond] - b->upto[b->fit];
    const double next = b->upto[b->fit + 1] - b->upto[b->fit];
    if (next > b->surely * (most - b->cost_fit))
        return b->fit;
    if (halve || !(rise > 0) || !(about > 0))
        return b->fit + (between / 2 > 1 ? between / 2 : 1);
    const double left = (most - b->cost_fit) * about / rise;
    int step = 1;
    while (step + 1 < between && b->upto[b->fit + step + 1] - b->upto[b->fit] <= left)
        step++;
    return b->fit + step;
}

/* Returns the trial with the most means that fit, within the bracket; trials[1] has b.fit means.
 * The other trials are dropped. */
static Trial *most_that_fit(const LowerRequest *what, Trial trials[2], double most, Bracket b,
                            const int *ends)
{
    Trial *next = &trials[0], *best = &trials[1];
    int slow = 0; /* consecutive guesses that left more than half of the range */
    while (b.fit + 1 < b.beyond) {
        const int before = b.beyond - b.fit, tried = guess(&b, most, slow == MAX_SLOW);
        if (tried == b.fit)
            break;
        try_below(next, what, ends[tried - 1]);
        const double cost = next->ir ? next->cost : 0; /* the cost of a failed trial is unknown */
        if (fits(next, most)) {
            swap(&best, &next);
            b.fit = tried, b.cost_fit = cost;
        } else {
            b.beyond = tried, b.cost_beyond = cost;
        }
        slow = 2 * (b.beyond - b.fit) > before && slow < MAX_SLOW ? slow + 1 : 0;
        drop(next);
    }
    return best;
}

/* Returns the maximum cost of a program with means if it costs `plain` without them. */
static double most_beside(const LowerRequest *what, int plain)
{
    const double growth = what->job->pass == PASS_plane ? most_growth_of_plane : most_growth;
    return growth * (plain > FREE_COST ? plain : FREE_COST);
}

/* Estimate from the cost tables: the means of all maps are free, fit into a tenth of the rest,
 * or are too many. */
typedef enum { GUESS_many, GUESS_free, GUESS_fit } Guess;

static Guess guess_by_tables(const Node *material)
{
    const MapCosts costs = lower_map_costs(material, LARGEST_GUESSED);
    const double left = (most_growth - 1) * costs.points;
    const bool whole = costs.points < LARGEST_GUESSED;
    if (costs.points < FREE_COST)
        return GUESS_free;
    return whole && costs.averageable * MEAN_COST <= left ? GUESS_fit : GUESS_many;
}

/* Returns true if the program with all means is within the budget. False: the program without
 * means decides. */
static bool surely_fits(const LowerRequest *what, const Trial *all, Guess guess)
{
    if (!all->ir || !all->seen.count || fits(all, most_beside(what, 0)))
        return all->ir != NULL;
    /* the program without means computes slopes, too */
    const bool own_slopes = all->seen.mingled || lower_displaced(what->material);
    if (guess != GUESS_fit || own_slopes)
        return false;
    const int plain = lower_cost_of_points(&all->lower, what->material);
    return plain >= 0 && fits(all, most_beside(what, plain));
}

/* Chooses between the program of points in trials[1] and programs with means; `cost_of_all` is
 * the cost with all means, NAN if that was not tried. */
static Trial *beside_points(const LowerRequest *what, Trial trials[2], double cost_of_all)
{
    Trial *all = &trials[0], *plain = &trials[1];
    const double most = most_beside(what, plain->cost);
    const bool mingled = plain->seen.mingled || plain->lower.detached;
    const double surely = mingled ? SURELY_MINGLED : SURELY;
    const double enough = isnan(cost_of_all) ? surely * (most - plain->cost) : INFINITY;
    const Prices prices = price_means(what, &plain->seen, enough);
    const bool within = prices.known == prices.count && prices.upto[prices.count] <= enough;
    if (prices.alike == prices.count)
        return plain;
    if (within && isnan(cost_of_all)) {
        try_below(all, what, INT_MAX);
        if (fits(all, most)) {
            drop(plain);
            return all;
        }
        cost_of_all = all->ir ? all->cost : NAN;
        drop(all);
    }
    const double about = plain->cost + prices.upto[prices.known];
    const Bracket b = {
        .fit = prices.alike,
        .beyond = prices.known,
        .cost_fit = plain->cost,
        .cost_beyond = prices.known == prices.count && !isnan(cost_of_all) ? cost_of_all : about,
        .upto = prices.upto,
        .surely = surely};
    return most_that_fit(what, trials, most, b, prices.ends);
}

/* Chooses between the program without means and one that averages the first of two maps, which do
 * not fit together. Lowering that program costs less than finding the price of a mean. */
static Trial *first_of_two(const LowerRequest *what, Trial trials[2])
{
    Trial *one = &trials[0], *plain = &trials[1];
    const int a = plain->seen.at[0].map->index, b = plain->seen.at[1].map->index;
    try_below(one, what, (a < b ? a : b) + 1);
    const bool fit = fits(one, most_beside(what, plain->cost));
    drop(fit ? plain : one);
    return fit ? one : plain;
}

/* Makes the two trials, returns the better one and drops the other. */
static Trial *affordable(const LowerRequest *what, Trial trials[2])
{
    Trial *all = &trials[0], *plain = &trials[1];
    double cost_of_all = NAN;
    const Guess guess = guess_by_tables(what->material);
    const bool first = guess != GUESS_many;
    if (first) {
        try_below(all, what, INT_MAX);
        if (surely_fits(what, all, guess))
            return all;
        cost_of_all = all->ir ? all->cost : NAN;
    }
    try_below(plain, what, 0);
    if (plain->ir && first && fits(all, most_beside(what, plain->cost))) {
        drop(plain);
        return all;
    }
    drop(all);
    /* there is no map to average, or a single map whose mean costs too much */
    const bool known = plain->seen.count <= (size_t)first;
    if (!plain->ir || known)
        return plain;
    return first && plain->seen.count == 2 ? first_of_two(what, trials)
                                           : beside_points(what, trials, cost_of_all);
}

static bool may_average(const Job *job)
{
    return job->choice[AXIS_aa] == CHOICE_aa_auto && job->pass != PASS_shadow;
}

Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job,
          Simplify *simplify)
{
    const LowerRequest what = {session, graph, material, job, simplify};
    if (!may_average(job))
        return lower_averaging(&(Lower){0}, &what, 0);
    Trial trials[2] = {0};
    Trial *best = affordable(&what, trials);
    if (best->ir && session->optimize > 0)
        return take(best, session);
    const int below = best->ir ? best->below : 0;
    drop(best);
    return lower_averaging(&(Lower){0}, &what, below);
}
