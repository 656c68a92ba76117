/* Adaptive subdivision by error. Each triangle has a few sample points; the distance between a
 * sample's displaced position and the triangle interpolated from its displaced corners is the
 * error there. The mean square of that distance, times the area, is the triangle's share of the
 * total error. The triangles with the largest shares are bisected, an eighth of all at a time;
 * samples go to the half that contains them, and each half gets new ones up to its minimum.
 *
 *     a triangle with a ridge of height 1 across half of its samples: 1/2 times its area; the
 *     halves that the ridge does not cross have 0, and are not divided
 *
 * Finally places are moved off the surface to reduce the triangles' error. Features between
 * samples are not found. So the first thirty-second of the triangles is made by area alone, and
 * these have up to four times as many samples: a part of the surface as large as two triangles
 * of an even division contains one. */
#include "runtime/tessellate/scene_refine.h"
#include "compiler/base/vec3.h"
#include "runtime/tessellate/scene_bisection.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/tessellate/scene_priority_queue.h"
#include "runtime/tessellate/scene_growing.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- Fitting of corners to minimize the error */

/* Triangles whose corners are on a curved surface all miss it on one side. Moving corners off
 * the surface a little halves the error.
 *
 *     y = x^2 and a chord from -1 to 1: y = 1 misses by 2/3 in the mean, 0.73 in root mean
 *     square; moved by that mean, y = 1/3, by 0.30
 *
 * A place moves by the mean error of its triangles, weighted by area: one step of Jacobi's
 * method towards least squares. If one of its triangles has almost no error the place is kept: a
 * flat area next to a cliff stays flat. */

/* Difference between a triangle and its displaced samples. */
typedef struct {
    double mean[3], square, area; /* square: mean of the squared distance */
} SceneMiss;

static const double STEP = 0.7; /* relaxation factor of a Jacobi step: two full steps overshoot */
/* Share of the square of the worst triangle's error below which a triangle is flat. */
static const double FLAT = 0.02 * 0.02;

typedef struct {
    /* Totals of the triangles at a place: weighted error; squared errors of the best and the
     * worst. */
    double sum[3], area, low, high;
} Around;

static void add_triangle(const SceneBisection *b, uint32_t triangle, const SceneMiss *miss,
                         Around *around)
{
    for (int corner = 0; corner < 3; corner++) {
        Around *at = &around[b->place_of[b->triangles[triangle].vertex[corner]]];
        for (int component = 0; component < 3; component++)
            at->sum[component] += miss->area * miss->mean[component];
        at->area += miss->area;
        at->low = fmin(at->low, miss->square);
        at->high = fmax(at->high, miss->square);
    }
}

static bool scene_refine_fit(const SceneBisection *b, const SceneMiss *misses, double least,
                             double (*to)[3])
{
    Around *around = calloc(b->place_count + 1, sizeof *around);
    if (!around)
        return false;
    for (size_t i = 0; i < b->place_count; i++)
        around[i].low = INFINITY;
    for (size_t i = 0; i < b->count; i++)
        add_triangle(b, (uint32_t)i, &misses[i], around);
    for (size_t i = 0; i < b->place_count; i++)
        for (int component = 0; around[i].low > fmax(least, FLAT * around[i].high) && component < 3;
             component++)
            to[i][component] += STEP * around[i].sum[component] / around[i].area;
    free(around);
    return true;
}

enum {
    FITS = 2,           /* number of fitting steps */
    SAMPLES = 4,        /* min samples per triangle */
    FIRST_SAMPLES = 16, /* max samples per triangle made by area */
    EVEN_SHARE = 32,    /* share of the triangles that is made by area: 1 / 32 */
    ROUND_SHARE = 8,    /* share of the triangles that a round divides: 1 / 8, */
    ROUND_MIN = 32,     /* min number of triangles that a round divides */
    BATCH = 4096        /* points moved in one call */
};

typedef struct {
    int weights[3]; /* integer weights of the base triangle's corners */
    uint32_t next;  /* next sample of the same triangle; NONE: last */
    double to[3];
} Sample;

static const uint32_t NONE = UINT32_MAX;

typedef struct {
    SceneBisection b;
    const SceneRefining *how;
    Sample *samples;
    size_t sample_count, sample_capacity, sample_moved;
    uint32_t *first; /* first sample by triangle */
    uint32_t *stamp; /* indexed by triangle: the round that changed it last */
    uint32_t round, first_round;
    size_t state_count, first_capacity, stamp_capacity;
    double (*to)[3]; /* indexed by place: its displaced position */
    size_t to_count, to_capacity;
    uint32_t *touched; /* triangles changed since the last round */
    size_t touched_count, touched_capacity;
    ScenePriorityQueue ranks;
    double least; /* mean square below which float rounding dominates */
    bool fine;
} Refiner;

/* -- samples */

/* Interpolates the displaced corners of a triangle at a sample's weights. */
static void mixed(const Refiner *r, const SceneBisectionTriangle *t, const int weights[3],
                  double result[3])
{
    const double whole = scene_bisection_turn(t->weights[0], t->weights[1], t->weights[2]);
    const double a = scene_bisection_turn(weights, t->weights[1], t->weights[2]) / whole,
                 b = scene_bisection_turn(weights, t->weights[2], t->weights[0]) / whole;
    const double *to[3];
    for (int i = 0; i < 3; i++)
        to[i] = r->to[r->b.place_of[t->vertex[i]]];
    for (int component = 0; component < 3; component++)
        result[component] =
            a * to[0][component] + b * to[1][component] + (1 - a - b) * to[2][component];
}

static double square_scale(const Refiner *r, const double at[3])
{
    const double scale = r->how->scale ? r->how->scale(r->how->user, at) : 1;
    return scale * scale;
}

static double error_of(const Refiner *r, uint32_t triangle)
{
    const SceneBisectionTriangle *t = &r->b.triangles[triangle];
    double sum = 0, scaled = 0, scales = 0;
    int count = 0;
    for (uint32_t i = r->first[triangle]; i != NONE; i = r->samples[i].next, count++) {
        const double scale = square_scale(r, r->samples[i].to);
        double at[3], square = 0;
        mixed(r, t, r->samples[i].weights, at);
        for (int component = 0; component < 3; component++)
            square += (at[component] - r->samples[i].to[component]) *
                      (at[component] - r->samples[i].to[component]);
        sum += square;
        scaled += square * scale;
        scales += scale;
    }
    const bool small = sum <= count * r->least || scaled <= count * r->how->least * r->how->least;
    return small ? 0 : scaled / count * scene_bisection_area(&r->b, triangle) * scales / count;
}

/* Returns the area before displacement, in squared units of the scale. */
static double scaled_area(const Refiner *r, uint32_t triangle)
{
    const SceneBisectionTriangle *t = &r->b.triangles[triangle];
    double scale = 0;
    for (int i = 0; i < 3; i++) {
        const float *p = r->b.vertices[t->vertex[i]].position;
        scale += square_scale(r, (const double[3]){(double)p[0], (double)p[1], (double)p[2]});
    }
    return scene_bisection_area(&r->b, triangle) * scale;
}

static SceneMiss miss_of(const Refiner *r, uint32_t triangle)
{
    SceneMiss miss = {.area = scene_bisection_area(&r->b, triangle)};
    int count = 0;
    for (uint32_t i = r->first[triangle]; i != NONE; i = r->samples[i].next, count++) {
        double at[3];
        mixed(r, &r->b.triangles[triangle], r->samples[i].weights, at);
        for (int component = 0; component < 3; component++) {
            const double off = r->samples[i].to[component] - at[component];
            miss.mean[component] += off;
            miss.square += off * off;
        }
    }
    for (int component = 0; count && component < 3; component++)
        miss.mean[component] /= count;
    miss.square /= count ? count : 1;
    return miss;
}

/* Returns half a unit in the last place of the largest coordinate, squared. */
static double least_square(const Shape *shape)
{
    double most = 0;
    for (int i = 0; i < shape->vertex_count; i++)
        for (int component = 0; component < 3; component++)
            most = fmax(most, fabs((double)shape->vertices[i].position[component]));
    return most * most * ldexp(1, -48);
}

/* Distributes samples evenly over a triangle: points of a lattice whose steps are 1 over the
 * plastic number and its square, with the far half of the square folded over (Roberts, The
 * unreasonable effectiveness of quasirandom sequences, 2018). */
static void place_sample(const SceneBisectionTriangle *t, size_t number, int weights[3])
{
    const double steps[2] = {0.7548776662466927, 0.5698402909980532};
    double x[2];
    for (int i = 0; i < 2; i++)
        x[i] = fmod(.5 + steps[i] * (double)(number % (1u << 24)), 1);
    if (x[0] + x[1] > 1) {
        x[0] = 1 - x[0];
        x[1] = 1 - x[1];
    }
    for (int component = 0; component < 2; component++)
        weights[component] =
            (int)lrint(t->weights[2][component] +
                       x[0] * (t->weights[0][component] - t->weights[2][component]) +
                       x[1] * (t->weights[1][component] - t->weights[2][component]));
    weights[2] = SCENE_BISECTION_PARTS - weights[0] - weights[1];
}

static bool fill_samples(Refiner *r, uint32_t triangle, int least)
{
    int count = 0;
    for (uint32_t i = r->first[triangle]; i != NONE; i = r->samples[i].next)
        count++;
    if (!scene_growing(&r->samples, r->sample_count + FIRST_SAMPLES, &r->sample_capacity,
                       sizeof *r->samples))
        return false;
    for (; count < least; count++) {
        Sample *made = &r->samples[r->sample_count];
        place_sample(&r->b.triangles[triangle], r->sample_count, made->weights);
        made->next = r->first[triangle];
        r->first[triangle] = (uint32_t)r->sample_count++;
    }
    return true;
}

/* Adds state for new triangles, without samples. */
static bool add_states(Refiner *r)
{
    if (!scene_growing(&r->first, r->b.count, &r->first_capacity, sizeof *r->first) ||
        !scene_growing(&r->stamp, r->b.count, &r->stamp_capacity, sizeof *r->stamp))
        return false;
    for (; r->state_count < r->b.count; r->state_count++) {
        r->first[r->state_count] = NONE;
        r->stamp[r->state_count] = 0;
    }
    return true;
}

static bool touch(Refiner *r, uint32_t triangle)
{
    if (r->stamp[triangle] == r->round)
        return true;
    if (!scene_growing(&r->touched, r->touched_count + 1, &r->touched_capacity, sizeof *r->touched))
        return false;
    r->touched[r->touched_count++] = triangle;
    r->stamp[triangle] = r->round;
    return true;
}

/* Distributes samples after a division into (c, a, m) and (b, c, m), by the side of the line
 * from c to m on which they are. */
static void share_samples(void *user, uint32_t triangle, uint32_t made)
{
    Refiner *r = user;
    r->fine = r->fine && add_states(r) && touch(r, triangle) && touch(r, made);
    if (!r->fine)
        return;
    const SceneBisectionTriangle *t = &r->b.triangles[triangle];
    const double side = scene_bisection_turn(t->weights[0], t->weights[2], t->weights[1]);
    uint32_t next = r->first[triangle];
    r->first[triangle] = r->first[made] = NONE;
    while (next != NONE) {
        Sample *sample = &r->samples[next];
        const uint32_t at = next,
                       to = scene_bisection_turn(t->weights[0], t->weights[2], sample->weights) *
                                        side >=
                                    0
                                ? triangle
                                : made;
        next = sample->next;
        sample->next = r->first[to];
        r->first[to] = at;
    }
}

/* -- points */

/* Returns the vertex whose displacement moves a place. */
static ShapeVertex place_vertex(const SceneBisection *b, size_t place)
{
    ShapeVertex vertex = b->vertices[b->places[place].first];
    memcpy(vertex.normal, b->places[place].normal, sizeof vertex.normal);
    return vertex;
}

static bool move_places(Refiner *r, ShapeVertex *at)
{
    if (!scene_growing(&r->to, r->b.place_count, &r->to_capacity, sizeof *r->to))
        return false;
    while (r->to_count < r->b.place_count) {
        int count = 0;
        for (; count < BATCH && r->to_count + (size_t)count < r->b.place_count; count++)
            at[count] = place_vertex(&r->b, r->to_count + (size_t)count);
        if (!r->how->move(r->how->user, at, count, r->to + r->to_count))
            return false;
        r->to_count += (size_t)count;
    }
    return true;
}

/* Displaces the new samples of touched triangles. */
static bool move_samples(Refiner *r, ShapeVertex *at, double (*to)[3])
{
    uint32_t waiting[BATCH];
    int count = 0;
    for (size_t i = 0; i <= r->touched_count; i++) {
        const bool all = i == r->touched_count;
        for (uint32_t k = all ? NONE : r->first[r->touched[i]]; k != NONE; k = r->samples[k].next)
            if (k >= r->sample_moved && count < BATCH) {
                waiting[count] = k;
                at[count++] = scene_divide_point(r->b.shape, r->b.triangles[r->touched[i]].base,
                                                 r->samples[k].weights, SCENE_BISECTION_PARTS);
            }
        if ((!all && count + FIRST_SAMPLES <= BATCH) || !count)
            continue;
        if (!r->how->move(r->how->user, at, count, to))
            return false;
        for (int k = 0; k < count; k++)
            memcpy(r->samples[waiting[k]].to, to[k], sizeof to[k]);
        count = 0;
    }
    r->sample_moved = r->sample_count;
    return true;
}

/* -- rounds */

/* Returns the initial number of samples per triangle: in total half the number of requested
 * triangles. */
static int first_samples(const Refiner *r)
{
    const size_t share = (size_t)r->how->triangles / 2 / r->b.count;
    return share < SAMPLES ? SAMPLES : share > FIRST_SAMPLES ? FIRST_SAMPLES : (int)share;
}

/* Updates samples and queue entries of the triangles that changed. */
static bool end_round(Refiner *r, bool by_area, ShapeVertex *at, double (*to)[3])
{
    bool fine = true;
    for (size_t i = 0; fine && !by_area && i < r->touched_count; i++)
        fine =
            fill_samples(r, r->touched[i], r->round == r->first_round ? first_samples(r) : SAMPLES);
    fine = fine && (by_area || (move_places(r, at) && move_samples(r, at, to)));
    for (size_t i = 0; fine && i < r->touched_count; i++) {
        const uint32_t triangle = r->touched[i];
        const double error = by_area ? scaled_area(r, triangle) : error_of(r, triangle);
        if (r->b.triangles[triangle].depth < SCENE_BISECTION_DEPTH - 2 && error > 0)
            fine = scene_priority_queue_put(&r->ranks,
                                            (ScenePriority){error, triangle, r->stamp[triangle]});
    }
    r->touched_count = 0;
    return fine;
}

static bool divide_most(Refiner *r, size_t triangles)
{
    const size_t share = r->b.count / ROUND_SHARE;
    const size_t round = r->b.count + (share > ROUND_MIN ? share : ROUND_MIN),
                 to = round < triangles ? round : triangles;
    bool fine = true;
    r->round++;
    while (fine && r->b.count < to && r->ranks.count) {
        const ScenePriority rank = scene_priority_queue_take(&r->ranks);
        if (rank.stamp == r->stamp[rank.triangle])
            fine = scene_bisection_split(&r->b, rank.triangle) && r->fine;
    }
    return fine;
}

/* Refines until the number of triangles is reached, or no error is left. */
static bool refine_to(Refiner *r, size_t triangles, bool by_area)
{
    ShapeVertex *at = malloc(BATCH * sizeof *at);
    double(*to)[3] = malloc(BATCH * sizeof *to);
    bool fine = at && to && add_states(r);
    r->ranks.count = 0;
    r->first_round = ++r->round;
    for (uint32_t i = 0; fine && r->b.count < triangles && i < r->b.count; i++)
        fine = touch(r, i);
    fine = fine && end_round(r, by_area, at, to);
    while (fine && r->b.count < triangles && r->ranks.count)
        fine = divide_most(r, triangles) && end_round(r, by_area, at, to);
    fine = fine && move_places(r, at);
    free(at);
    free(to);
    return fine;
}

/* Returns the length of a place's displacement. */
static double length_of(const Refiner *r, size_t place)
{
    const float *from = r->b.vertices[r->b.places[place].first].position;
    double by[3];
    for (int component = 0; component < 3; component++)
        by[component] = r->to[place][component] - (double)from[component];
    return r->how->length ? r->how->length(r->how->user, by) : vec3_length(by);
}

/* Moves all places to reduce the error; places that would move farther than the longest
 * displacement are kept. */
static bool fit(Refiner *r)
{
    SceneMiss *misses = malloc((r->b.count + 1) * sizeof *misses);
    double(*was)[3] = malloc((r->b.place_count + 1) * sizeof *was);
    bool fine = misses && was;
    double most = 0;
    for (size_t i = 0; i < r->b.place_count; i++)
        most = fmax(most, length_of(r, i));
    for (int i = 0; fine && i < FITS; i++) {
        memcpy(was, r->to, r->b.place_count * sizeof *was);
        for (uint32_t t = 0; t < r->b.count; t++)
            misses[t] = miss_of(r, t);
        fine = scene_refine_fit(&r->b, misses, r->least, r->to);
        for (size_t k = 0; k < r->b.place_count; k++)
            if (length_of(r, k) > most)
                memcpy(r->to[k], was[k], sizeof *was);
    }
    free(was);
    free(misses);
    return fine;
}

bool scene_refine(const Shape *shape, const SceneRefining *how, Shape *made)
{
    Refiner r = {.how = how, .fine = true};
    const size_t triangles = (size_t)how->triangles;
    bool fine = scene_bisection_begin(shape, &r.b);
    r.least = least_square(shape);
    r.b.divided = share_samples;
    r.b.user = &r;
    fine = fine &&
           (r.b.count >= triangles / EVEN_SHARE || refine_to(&r, triangles / EVEN_SHARE, true));
    fine = fine && refine_to(&r, triangles, false) && fit(&r) &&
           scene_bisection_shape(&r.b, (const double(*)[3])r.to, made);
    scene_bisection_end(&r.b);
    free(r.samples);
    free(r.first);
    free(r.stamp);
    free(r.to);
    free(r.touched);
    scene_priority_queue_end(&r.ranks);
    if (!fine)
        *made = (Shape){0};
    return fine;
}
