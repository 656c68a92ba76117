/* Lowers each map that may be averaged by itself, in document order, in two IRs: with the means
 * of all maps up to it, and without means. The difference in cost is the price.
 *
 *     625 checkers of one turbulence, in a program of 13,774 operations. The mean of the first
 *     needs the turbulence's slopes: it costs 1,832 more than its point, and a tenth of the
 *     program is 1,377. So no map is averaged, which is known after two lowerings of 40 nodes
 *     instead of 9,000 */
#include "compiler/lower/price.h"
#include "compiler/base/stack.h"
#include <math.h>
#include <stdlib.h>

/* State of one of the two compared lowerings. */
typedef struct {
    Arena arena;
    Session session;
    LowerRequest what;
    Lower lower;
    Env env;
    uint8_t *counted; /* per Ref: the sum includes the node's cost */
    size_t capacity;
    Ref *to_count; /* stack of the nodes to visit */
    size_t to_count_count, to_count_capacity;
    int nodes;
    double cost; /* cost of the counted nodes */
} Side;

static void open_side(Side *side, const LowerRequest *what, int below)
{
    *side = (Side){.session = *what->session, .what = *what};
    side->session.arena = &side->arena;
    side->session.diags = (DiagList){0};
    side->what.session = &side->session;
    side->lower = lower_start(&side->what, 1);
    side->lower.averaged_below = below;
    side->env = lower_pass_env(&side->lower);
}

static void close_side(Side *side)
{
    ir_done(side->lower.ir);
    arena_free(&side->arena);
}

static void want_counted(Side *side, Ref ref)
{
    side->counted =
        arena_reach(&side->arena, side->counted, ref, &side->capacity, sizeof *side->counted);
    if (!side->counted[ref])
        ARENA_PUSH(&side->arena, side->to_count, side->to_count_count, side->to_count_capacity,
                   ref);
    side->counted[ref] = 1;
}

/* Adds the cost of a value's nodes that are not counted yet. A function counts as a single run. */
static void count(Side *side, Ref value)
{
    const Ir *ir = side->lower.ir;
    want_counted(side, value);
    while (side->to_count_count) {
        const Ref ref = side->to_count[--side->to_count_count];
        side->nodes++;
        side->cost += ir_cost(ir, ref);
        for (int i = 0; i < ir_at(ir, ref)->count; i++)
            want_counted(side, ir_arg(ir, ref, i));
        if (ir_applies(ir, ref))
            want_counted(side, ir->functions[ir_at(ir, ref)->payload].result);
    }
}

static void add_map(Side *side, const MetMap *met)
{
    if (met->outside)
        count(side, lower_query(&side->lower, met->map, met->group, &side->env));
}

/* Returns true if both lowerings are equal: a mean has additional nodes. */
static bool are_alike(const Side *a, const Side *b)
{
    return a->nodes == b->nodes && a->cost == b->cost;
}

typedef struct {
    const LowerRequest *what;
    const MapList *maps;
    double most;
    Prices prices;
} Pricing;

static void price(void *user)
{
    Pricing *p = user;
    Prices *prices = &p->prices;
    Side points, means;
    bool alike = true;
    open_side(&points, p->what, 0);
    open_side(&means, p->what, p->prices.count ? prices->ends[prices->count - 1] : 0);
    for (size_t at = 0; prices->known < prices->count && prices->upto[prices->known] <= p->most;) {
        for (; at < p->maps->count && p->maps->at[at].map->index < prices->ends[prices->known];
             at++) {
            alike &= p->maps->at[at].outside;
            add_map(&points, &p->maps->at[at]);
            add_map(&means, &p->maps->at[at]);
        }
        prices->upto[prices->known + 1] =
            fmax(prices->upto[prices->known], means.cost - points.cost);
        prices->known++;
        alike &= are_alike(&points, &means);
        prices->alike += alike;
    }
    close_side(&points);
    close_side(&means);
}

static int by_index(const void *a, const void *b)
{
    const int x = ((const MetMap *)a)->map->index, y = ((const MetMap *)b)->map->index;
    const int g = (int)((const MetMap *)a)->group, h = (int)((const MetMap *)b)->group;
    return x != y ? (x > y) - (x < y) : (g > h) - (g < h);
}

Prices price_means(const LowerRequest *what, const MapList *maps, double most)
{
    Arena *arena = what->session->arena;
    Pricing p = {.what = what, .maps = maps, .most = most};
    p.prices.ends = ARENA_ARRAY(arena, int, maps->count);
    p.prices.upto = ARENA_ARRAY(arena, double, maps->count + 1);
    qsort(maps->at, maps->count, sizeof *maps->at, by_index);
    for (size_t i = 0; i < maps->count; i++)
        if (!i || maps->at[i].map != maps->at[i - 1].map)
            p.prices.ends[p.prices.count++] = maps->at[i].map->index + 1;
    stack_run(what->material ? what->material->depth : 0, price, &p);
    return p.prices;
}
