/* Arithmetic of 200 bits by MPFR, for formulas written as expressions: every result is a new
 * number, and exact_forget() frees them all. Also the oracle's values of documents, to compare
 * with. */
#ifndef MATC_EXACT_H
#define MATC_EXACT_H
#include "tests/test.h"
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>
#include "compiler/oracle/oracle.h"
#include "compiler/pipeline.h"

enum { EXACT_BITS = 200, EXACT_CAPACITY = 1 << 18 };

typedef mpfr_ptr R;

/* All allocated numbers; a test has one thread. */
typedef struct {
    mpfr_t at[EXACT_CAPACITY];
    int made, used;
} Exact;
static Exact exact;

static inline R fresh(void)
{
    assert_true(exact.used < EXACT_CAPACITY);
    if (exact.used == exact.made)
        mpfr_init2(exact.at[exact.made++], EXACT_BITS);
    return exact.at[exact.used++];
}
static inline void exact_forget(void) { exact.used = 0; }
static inline int exact_close(void **state)
{
    (void)state;
    while (exact.made)
        mpfr_clear(exact.at[--exact.made]);
    mpfr_free_cache();
    return 0;
}

static inline R num(double v)
{
    R r = fresh();
    mpfr_set_d(r, v, MPFR_RNDN);
    return r;
}
static inline double value(R a) { return mpfr_get_d(a, MPFR_RNDN); }

#define EXACT_1(name, call)                                                                        \
    static inline R name(R a)                                                                      \
    {                                                                                              \
        R r = fresh();                                                                             \
        call(r, a, MPFR_RNDN);                                                                     \
        return r;                                                                                  \
    }
#define EXACT_2(name, call)                                                                        \
    static inline R name(R a, R b)                                                                 \
    {                                                                                              \
        R r = fresh();                                                                             \
        call(r, a, b, MPFR_RNDN);                                                                  \
        return r;                                                                                  \
    }
EXACT_1(minus, mpfr_neg)
EXACT_1(size, mpfr_abs)
EXACT_1(root, mpfr_sqrt)
EXACT_1(sine, mpfr_sin)
EXACT_1(cosine, mpfr_cos)
EXACT_1(tangent, mpfr_tan)
EXACT_1(arc_sine, mpfr_asin)
EXACT_1(arc_cosine, mpfr_acos)
EXACT_1(arc_tangent, mpfr_atan)
EXACT_1(power_e, mpfr_exp)
EXACT_1(power_2, mpfr_exp2)
EXACT_1(power_e_less_1, mpfr_expm1)
EXACT_1(natural_log, mpfr_log)
EXACT_1(decimal_log, mpfr_log10)
EXACT_1(hyper_sine, mpfr_sinh)
EXACT_1(hyper_cosine, mpfr_cosh)
EXACT_1(hyper_tangent, mpfr_tanh)
EXACT_2(plus, mpfr_add)
EXACT_2(less, mpfr_sub)
EXACT_2(times, mpfr_mul)
EXACT_2(over, mpfr_div)
EXACT_2(lesser, mpfr_min)
EXACT_2(greater, mpfr_max)
EXACT_2(power, mpfr_pow)
#undef EXACT_1
#undef EXACT_2

static inline R whole(R a)
{
    R r = fresh();
    mpfr_floor(r, a);
    return r;
}
static inline R part(R a) { return less(a, whole(a)); }
static inline R pi(void)
{
    R r = fresh();
    mpfr_const_pi(r, MPFR_RNDN);
    return r;
}
static inline bool below(R a, R b) { return mpfr_cmp(a, b) < 0; }
static inline R dot3(R *a, R *b)
{
    return plus(plus(times(a[0], b[0]), times(a[1], b[1])), times(a[2], b[2]));
}
static inline void cross3(R *a, R *b, R *r)
{
    for (int i = 0; i < 3; i++)
        r[i] = less(times(a[(i + 1) % 3], b[(i + 2) % 3]), times(a[(i + 2) % 3], b[(i + 1) % 3]));
}
static inline void unit3(R *a)
{
    R length = root(dot3(a, a));
    for (int i = 0; i < 3; i++)
        a[i] = over(a[i], length);
}

/* A document and its oracle. */
typedef struct {
    MatcOptions options;
    Arena arena;
    Session session;
    Graph *graph;
    Oracle *oracle;
} Read;

static inline void read_open(Read *r, const char *text, ReferenceNoise noise)
{
    Tree *tree;
    *r = (Read){0};
    matc_options_init(&r->options);
    r->session = (Session){.options = &r->options, .arena = &r->arena};
    Source source = {.name = "exact.yaml", .text = text, .size = strlen(text)};
    ARENA_PUSH(&r->arena, r->session.sources, r->session.source_count, r->session.source_capacity,
               source);
    r->graph = compile_front(&r->session, 0, &tree);
    if (!r->graph || r->session.diags.errors)
        fail_msg("%s: %s", text, r->session.diags.count ? r->session.diags.at[0].message : "");
    r->oracle = oracle_open(r->graph, &(ReferenceContext){.noise = noise});
}

static inline void read_close(Read *r)
{
    oracle_close(r->oracle);
    arena_free(&r->arena);
}

static inline void read_values(Read *r, const Surface *surface, SlotValues *values)
{
    oracle_material(r->oracle, r->graph->materials[0].node, surface, values);
}

/* Checks that the oracle's double equals the exact number within bound * max(1, |number|). */
static inline void agrees(const char *what, double got, R want, double bound)
{
    double error = fabs(value(less(num(got), want))) / fmax(1, fabs(value(want)));
    if (!(error <= bound))
        fail_msg("%s: %.17g instead of %.17g, error %.2g", what, got, value(want), error);
}
#endif
