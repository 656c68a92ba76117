/* The omitted part of distant lights changes the picture by less than half a step of 8 bits, or
 * of half floats: the claims of light_bound.c. Claims about numbers are proved by intervals and
 * signs of polynomials; claims that its comment proves are sampled. */
#include "tests/test.h"
#include "runtime/light/light_far.h"
#include "tests/frame/frame_lamps.h"
#include <math.h>

static const double half_step = 1. / 510;

/* slope y + start */
typedef struct {
    double slope, start;
} Line;

/* Error bound of a tone-mapped component y: the smaller of two lines; for light with the error r
 * times itself plus a. */
typedef struct {
    SceneKind tone;
    Line lines[2]; /* in r and a */
} Off;

static const Off offs[] = {{SCENE_Clamp, {{1, 1}, {1, 1}}},
                           {SCENE_Shoulder, {{1, 1}, {1, 1}}},
                           {SCENE_Exponential, {{2.02, 1.01}, {2.02, 1.01}}},
                           {SCENE_Linear, {{2.02, 0}, {2.02, 0}}},
                           {SCENE_Filmic, {{2.6, .6}, {.85, 3.65}}}};
enum { OFFS = sizeof offs / sizeof *offs };

static double most_off(const Off *off, double y)
{
    double budget[2];
    assert_true(light_far_budget(off->tone, false, budget));
    assert_true(budget[0] > 1e-3);
    return fmin(off->lines[0].slope * budget[0] * y + off->lines[0].start * budget[1],
                off->lines[1].slope * budget[0] * y + off->lines[1].start * budget[1]);
}

/* The encoding rises: between two values y, off by less than at the upper one, it is off by less
 * than this interval says. Below the first, where it is a line, by 12.92 times what y is off. */
static void encoded_is_within_half_a_step(void **state)
{
    (void)state;
    const double least = 1e-5, step = 1.0001;
    for (int i = 0; i < OFFS; i++) {
        double most = 12.92 * most_off(&offs[i], least);
        for (double y = least; y < 1; y *= step) {
            const double above = fmin(y * step, 1), below = y - most_off(&offs[i], above);
            most = fmax(most, frame_lamps_encoded(above) - frame_lamps_encoded(fmax(below, 0)));
        }
        print_message("%s: %.3f of half a step\n", scene_kind_table[offs[i].tone].name,
                      most / half_step);
        assert_true(most < half_step);
    }
}

/* A component, and the greatest one beside it, off to either side. */
static void expect_mapped(const Off *off, const double budget[2], double x, double greatest)
{
    const double y = frame_lamps_mapped(off->tone, x, greatest),
                 most = most_off(off, y) * (1 + 1e-9) + 1e-15;
    for (int signs = 0; signs < 4; signs++) {
        const double a = signs & 1 ? 1 : -1, b = x < greatest ? (signs & 2 ? 1 : -1) : a;
        const double component = fmax(x + a * (budget[0] * x + budget[1]), 0);
        const double beside = fmax(greatest + b * (budget[0] * greatest + budget[1]), 1e-12);
        if (fabs(frame_lamps_mapped(off->tone, component, fmax(beside, component)) - y) > most)
            fail_msg("%s: %g of %g", scene_kind_table[off->tone].name, x, greatest);
    }
}

static void mapped_is_off_by_less(void **state)
{
    (void)state;
    double budget[2];
    for (int i = 0; i < OFFS; i++) {
        assert_true(light_far_budget(offs[i].tone, false, budget));
        for (double greatest = 1e-6; greatest < 100; greatest *= 1.05)
            for (double share = 1; share > 1e-4; share *= .93)
                expect_mapped(&offs[i], budget, share * greatest, greatest);
    }
}

/* -- Filmic, x (2.51 x + .03) / (x (2.43 x + .59) + .14) = p / q, by polynomials of degree 4 */

enum { DEGREE = 4 };
typedef struct {
    double of[DEGREE + 1]; /* of[i] belongs to x^i */
} Polynomial;

static Polynomial product(Polynomial a, Polynomial b)
{
    Polynomial p = {{0}};
    for (int i = 0; i <= DEGREE; i++)
        for (int k = 0; i + k <= DEGREE; k++)
            p.of[i + k] += a.of[i] * b.of[k];
    return p;
}

static Polynomial sum(Polynomial a, double factor, Polynomial b)
{
    for (int i = 0; i <= DEGREE; i++)
        a.of[i] += factor * b.of[i];
    return a;
}

/* a, of x = from + by t, as a polynomial in t: Horner's rule. */
static Polynomial shifted(Polynomial a, double from, double by)
{
    Polynomial p = {{0}};
    for (int i = DEGREE; i >= 0; i--) {
        p = product(p, (Polynomial){{from, by}});
        p.of[0] += a.of[i];
    }
    return p;
}

/* It is above 0 from `low` to `high`, since all of Bernstein's coefficients are, of both halves if
 * not of the whole. For example 1 - 2 t + 2 t^2 has 1, 0, 1, on its left half 1, 1/2, 1/2. */
static bool is_above(Polynomial p, double low, double high, int depth)
{
    static const double binomial[] = {1, 4, 6, 4, 1};
    const Polynomial t = shifted(p, low, high - low);
    bool all = true;
    for (int i = 0; i <= DEGREE; i++) {
        double b = 0, choose = 1; /* i over k */
        for (int k = 0; k <= i; k++) {
            b += choose / binomial[k] * t.of[k];
            choose = choose * (i - k) / (k + 1);
        }
        all = all && b > 0;
    }
    const double middle = .5 * (low + high);
    return all || (depth > 0 && is_above(p, low, middle, depth - 1) &&
                   is_above(p, middle, high, depth - 1));
}

/* |m(x') - m(x)| < slope m(x) + start, times both denominators, for x' = x + sign (r x + a), to
 * where the film is white. Below a / (1 - r), where light that is off may be none, m(x) itself is
 * less. */
static bool film_is_off_by_less(Line line, const double budget[2], int sign)
{
    const double white = 7.25, dark = budget[1] / (1 - budget[0]);
    const Polynomial p = {{0, .03, 2.51}}, q = {{.14, .59, 2.43}};
    const Polynomial moved_p = shifted(p, sign * budget[1], 1 + sign * budget[0]);
    const Polynomial moved_q = shifted(q, sign * budget[1], 1 + sign * budget[0]);
    Polynomial off = {{0}};
    off = sum(sum(off, line.slope * budget[0], p), line.start * budget[1], q);
    const Polynomial rise = sum(product(moved_p, q), -1, product(p, moved_q));
    const Polynomial rest = sum(product(off, moved_q), -sign, rise);
    return sign > 0 ? is_above(rest, 0, white, 40)
                    : is_above(rest, dark, white, 40) && is_above(sum(off, -1, p), 0, dark, 40);
}

static void film_is_proved(void **state)
{
    (void)state;
    const Off *film = &offs[OFFS - 1];
    double budget[2];
    assert_true(light_far_budget(SCENE_Filmic, false, budget));
    assert_true(frame_lamps_mapped(SCENE_Filmic, 7.25, 1) == 1);
    for (int i = 0; i < 2; i++)
        for (int sign = -1; sign <= 1; sign += 2)
            assert_true(film_is_off_by_less(film->lines[i], budget, sign));
    /* the proof can fail */
    assert_false(film_is_off_by_less((Line){.85, .6}, budget, 1));
    assert_false(film_is_off_by_less((Line){2.6, 0}, budget, -1));
    assert_false(is_above((Polynomial){{.24, -1, 1}}, 0, 1, 40));
}

/* A half has 11 bits: what light is off is less than half of its step. */
static void halves(void **state)
{
    (void)state;
    double budget[2];
    assert_true(light_far_budget(SCENE_Drago, true, budget));
    assert_true(budget[0] > 0 && budget[1] == 0);
    for (double light = 6.2e-5; light < 65504; light *= 1.01) {
        int exponent;
        frexp(light, &exponent);
        assert_true(budget[0] * light < .5 * ldexp(1, exponent - 11));
    }
}

static void others_have_none(void **state)
{
    (void)state;
    double budget[2];
    assert_false(light_far_budget(SCENE_Drago, false, budget));
    assert_false(light_far_budget(SCENE_ReinhardDevlin, false, budget));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(encoded_is_within_half_a_step),
        cmocka_unit_test(mapped_is_off_by_less),
        cmocka_unit_test(film_is_proved),
        cmocka_unit_test(halves),
        cmocka_unit_test(others_have_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
