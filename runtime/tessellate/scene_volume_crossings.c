/* Finds surface crossings. Along a column the ends of the solid intervals are known. Along an
 * edge they are found by ITP (Oliveira and Takahashi 2020), which evaluates about three columns
 * where f is smooth, and one more than bisection where f jumps. A column evaluated for one level
 * is used for all levels that cross the edge: those of a cliff are found together.
 *
 *     f = 1 - (4 t)^2 from 1 to -15, with a zero at 1/4: the secant gives 1/16, moved by a fifth
 *     of the square of the remaining width, 0.2, to 0.2625, where f is -0.1025; the secant to
 *     there gives 0.238, moved to 0.252, f = -0.016. Between 0 and 0.252 the secant gives
 *     0.24799, where f is 0.016: the remaining width is then below 1/512. */
#include "runtime/tessellate/scene_volume_crossings.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HALVINGS = 10, BATCH = 4096 };
static const double truncation = .2; /* parameter of ITP */
/* Share of f's difference between the ends of an edge; a greater difference over 1/1024 of the edge
 * is a cliff. */
static const double jump = 1. / 16;

/* Search for a node along an edge: between low and high, only one of which is solid. */
typedef struct {
    uint32_t node;
    int asked;
    bool done;
    unsigned pairs; /* pairs that either end has */
    /* f at both ends, and their initial difference */
    double low, high, f_low, f_high, first;
} Search;

typedef struct {
    size_t first, end; /* the searches on its edge */
    double t;
} Asked;

typedef struct {
    const SceneVolume *volume;
    const SceneLayers *layers;
    SceneSpot *spots;
    Search *searches; /* grouped by edge */
    size_t count, capacity;
    SceneColumn *columns; /* columns evaluated at a time, and their requests */
    Asked *asked;
} Looking;

ShapeVertex scene_volume_mixed(const ShapeVertex *a, const ShapeVertex *b, double t)
{
    enum { COMPONENTS = sizeof(ShapeVertex) / sizeof(float) };
    float from[COMPONENTS], to[COMPONENTS];
    ShapeVertex made;
    memcpy(from, a, sizeof from);
    memcpy(to, b, sizeof to);
    for (int i = 0; i < COMPONENTS; i++)
        from[i] = (float)((double)from[i] * (1 - t) + (double)to[i] * t);
    memcpy(&made, from, sizeof made);
    return made;
}

unsigned scene_volume_pairs(const SceneColumn *columns, int count)
{
    unsigned pairs = 0;
    for (int i = 0; i < count; i++)
        for (unsigned pair = 0; pair < 2; pair++)
            pairs |= (unsigned)(columns[i].heights[2 * pair] < columns[i].heights[2 * pair + 1])
                     << pair;
    return pairs;
}

/* Returns a field that is positive between both heights, and nowhere if they are in reverse
 * order. */
static double between(double from, double to, double z)
{
    const double above = z - from, below = to - z;
    return above < 0 && below < 0 ? -above * below : above * below;
}

double scene_volume_field(const SceneColumn *c, unsigned pairs, double z)
{
    const double *h = c->heights;
    return fmax(pairs & 1 ? between(h[0], h[1], z) : -INFINITY,
                pairs & 2 ? between(h[2], h[3], z) : -INFINITY);
}

/* Returns the end of the solid interval that contains one end of a step, but not the other. */
static double end_within(const SceneColumn *c, double solid, bool above)
{
    double end = solid;
    for (int again = 0; again < 2; again++)
        for (int i = 0; i < 4; i += 2)
            if (c->heights[i] < c->heights[i + 1] && c->heights[i] <= end &&
                end <= c->heights[i + 1])
                end = c->heights[above ? i + 1 : i];
    return end;
}

static SceneSpot spot_of(const SceneLayers *layers, const SceneNode *node)
{
    const int a = layers->place[node->a], b = layers->place[node->b];
    SceneSpot s = {.from = a < b ? a : b,
                   .to = a < b ? b : a,
                   .height = layers->low + node->level * layers->step};
    s.there = layers->columns[s.from];
    if (node->kind == SCENE_NODE_up) {
        const bool above = scene_column_solid(&s.there, s.height);
        const double next = layers->low + (node->level + 1) * layers->step;
        s.height = end_within(&s.there, above ? s.height : next, above);
    }
    return s;
}

typedef struct {
    int from, to;
    double height;
    uint32_t node;
} Place;

static int by_place(const void *a, const void *b)
{
    const Place *x = a, *y = b;
    if (x->from != y->from)
        return (x->from > y->from) - (x->from < y->from);
    if (x->to != y->to)
        return (x->to > y->to) - (x->to < y->to);
    if (x->height != y->height)
        return (x->height > y->height) - (x->height < y->height);
    return (x->node > y->node) - (x->node < y->node);
}

static bool put_in_order(const SceneSpot *spots, size_t count, uint32_t *order)
{
    Place *places = malloc((count + 1) * sizeof *places);
    for (size_t i = 0; places && i < count; i++)
        places[i] = (Place){spots[i].from, spots[i].to, spots[i].height, (uint32_t)i};
    if (places)
        qsort(places, count, sizeof *places, by_place);
    for (size_t i = 0; places && i < count; i++)
        order[i] = places[i].node;
    free(places);
    return places != NULL;
}

static void begin(Looking *l, uint32_t node)
{
    const SceneSpot *s = &l->spots[node];
    Search search = {.node = node, .high = 1};
    search.pairs = scene_volume_pairs(&l->layers->columns[s->from], 1) |
                   scene_volume_pairs(&l->layers->columns[s->to], 1);
    search.f_low = scene_volume_field(&l->layers->columns[s->from], search.pairs, s->height);
    search.f_high = scene_volume_field(&l->layers->columns[s->to], search.pairs, s->height);
    search.first = search.f_high - search.f_low;
    l->searches[l->count++] = search;
}

/* Returns the zero of the secant between both ends; the midpoint if the secant has no zero
 * there. */
static double by_line(const Search *s)
{
    const double part = s->f_low / (s->f_low - s->f_high);
    return s->low + (s->high - s->low) * (part >= 0 && part <= 1 ? part : .5);
}

/* Returns the next place to evaluate by the ITP method: the secant's zero, moved towards the
 * midpoint so far that bisection would not be much faster. */
static double next_to_ask(const Search *s)
{
    const double width = s->high - s->low, middle = (s->low + s->high) / 2, line = by_line(s);
    const double toward = line < middle ? 1 : -1, way = truncation * width * width;
    const double radius = fmax(ldexp(1, -s->asked) - width / 2, 0);
    const double moved = way < fabs(middle - line) ? line + toward * way : middle;
    return fabs(moved - middle) <= radius ? moved : middle - toward * radius;
}

/* Returns the end of the searches on one edge. */
static size_t edge_end(const Looking *l, size_t first)
{
    const SceneSpot *s = &l->spots[l->searches[first].node];
    size_t end = first + 1;
    while (end < l->count && l->spots[l->searches[end].node].from == s->from &&
           l->spots[l->searches[end].node].to == s->to)
        end++;
    return end;
}

/* Requests columns for the searches of one edge: once for adjacent searches with equal brackets. */
static int ask_edge(Looking *l, size_t first, size_t end, int count)
{
    const Search *last = NULL;
    for (size_t i = first; i < end; i++) {
        Search *s = &l->searches[i];
        const SceneSpot *spot = &l->spots[s->node];
        if (s->done || (last && last->low == s->low && last->high == s->high))
            continue;
        l->asked[count] = (Asked){first, end, next_to_ask(s)};
        l->columns[count].at =
            scene_volume_mixed(&l->layers->columns[spot->from].at, &l->layers->columns[spot->to].at,
                               l->asked[count].t);
        s->asked++;
        count++;
        last = s;
    }
    return count;
}

/* Narrows the search by a column, if the column is between its ends. */
static void take(const Looking *l, Search *s, const SceneColumn *column, double t)
{
    SceneSpot *spot = &l->spots[s->node];
    const SceneColumn *from = &l->layers->columns[spot->from], *to = &l->layers->columns[spot->to];
    if (s->done || t <= s->low || t >= s->high)
        return;
    const double f = scene_volume_field(column, s->pairs, spot->height);
    const bool like_low =
        scene_column_solid(column, spot->height) == scene_column_solid(from, spot->height);
    *(like_low ? &s->low : &s->high) = t;
    *(like_low ? &s->f_low : &s->f_high) = f;
    s->done = s->high - s->low <= ldexp(1, -HALVINGS);
    if (!s->done)
        return;
    const bool met = fabs(s->f_low - s->f_high) < jump * fabs(s->first);
    spot->t = met ? by_line(s) : (s->low + s->high) / 2;
    spot->field = met ? 0 : f;
    spot->there = *column;
    spot->there.at = scene_volume_mixed(&from->at, &to->at, spot->t);
    for (int i = 0; i < 3; i++)
        spot->there.along[i] += (spot->t - t) * (to->along[i] - from->along[i]);
}

static bool answer(Looking *l, int count)
{
    if (!l->volume->solid(l->volume->user, l->columns, count))
        return false;
    for (int k = 0; k < count; k++)
        for (size_t i = l->asked[k].first; i < l->asked[k].end; i++)
            take(l, &l->searches[i], &l->columns[k], l->asked[k].t);
    return true;
}

/* Evaluates columns for each edge with unfinished searches, a batch at a time. False: failed;
 * *any is set if there was an unfinished search. */
static bool ask_all(Looking *l, bool *any)
{
    int count = 0;
    *any = false;
    for (size_t first = 0, end; first < l->count; first = end) {
        end = edge_end(l, first);
        if (count && (size_t)count + (end - first) > l->capacity) {
            if (!answer(l, count))
                return false;
            count = 0;
        }
        count = ask_edge(l, first, end, count);
        *any |= count > 0;
    }
    return !count || answer(l, count);
}

/* Sets the batch size: at least the number of searches on any edge. */
static bool make_capacity(Looking *l)
{
    l->capacity = BATCH;
    for (size_t first = 0, end; first < l->count; first = end) {
        end = edge_end(l, first);
        l->capacity = end - first > l->capacity ? end - first : l->capacity;
    }
    l->columns = calloc(l->capacity, sizeof *l->columns);
    l->asked = calloc(l->capacity, sizeof *l->asked);
    return l->columns && l->asked;
}

bool scene_volume_crossings(const SceneVolume *volume, const SceneLayers *layers,
                            const SceneCells *cells, SceneSpot *spots, uint32_t *order)
{
    Looking l = {.volume = volume, .layers = layers, .spots = spots};
    for (size_t i = 0; i < cells->node_count; i++)
        spots[i] = spot_of(layers, &cells->nodes[i]);
    l.searches = calloc(cells->node_count + 1, sizeof *l.searches);
    bool fine = l.searches && put_in_order(spots, cells->node_count, order), any = fine;
    for (size_t i = 0; fine && i < cells->node_count; i++)
        if (cells->nodes[order[i]].kind == SCENE_NODE_along)
            begin(&l, order[i]);
    fine = fine && make_capacity(&l);
    while (fine && any)
        fine = ask_all(&l, &any);
    free(l.asked);
    free(l.columns);
    free(l.searches);
    return fine;
}
