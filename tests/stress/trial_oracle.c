/* The oracle's value of a slot; for exact derivatives, also the accuracy of its finite
 * differences. */
#include "trial.h"
#include <string.h>

/* For exact derivatives: one-sided differences that disagree by more are not compared; greatest
 * error of the others. */
static const double slope_apart = 1e-3, slope_tolerance = 1e-6;

/* Spans of the finite differences for exact derivatives: before and after the point; if these
 * disagree, the slope is unknown. Two that agree may share an error, from the rounding of a
 * large number or strong curvature within them; the other spans have other widths. */
enum { SPAN_BEHIND, SPAN_AHEAD, SPAN_OTHER, SPAN_NARROW, SPAN_COUNT };
static const double spans[SPAN_COUNT][2] = {{-1, 0}, {0, 1}, {-0.37, 0.59}, {-0.05, 0.04}};

/* At greater distances the spans are wide compared with the maps' features. */
static const float far = 1000;

static void judge_slope(TrialWanted *w, const SlotValues *sides, Slot slot, int component)
{
    const double value = w->value.component[slot][component], size = fmax(1, fabs(value));
    double apart = fabs(sides[SPAN_BEHIND].component[slot][component] -
                        sides[SPAN_AHEAD].component[slot][component]);
    w->known = w->known && apart <= slope_apart * size;
    for (int i = SPAN_OTHER; i < SPAN_COUNT; i++)
        apart = fmax(apart, fabs(sides[i].component[slot][component] - value));
    w->tolerance.component[slot][component] = apart == 0 ? 0 : slope_tolerance * size + 4 * apart;
}

void trial_query_oracle(Trial *t, const Point *point, bool front, Slot slot, TrialWanted *w)
{
    Surface surface;
    SlotValues sides[SPAN_COUNT];
    /* true displacement has no other slopes */
    const bool differs = t->bumps[slot] && (t->exact || oracle_displaced(t->material));
    memset(&w->tolerance, 0, sizeof w->tolerance);
    point_surface(point, front, &surface);
    oracle_judge_slopes(t->oracle, true);
    oracle_material(t->oracle, t->material, &surface, &w->value);
    oracle_judge_slopes(t->oracle, false);
    w->known = t->plan->oracle && !oracle_slopes_rough(t->oracle) &&
               !(differs && point_is_far(point, far));
    for (int i = 0; differs && i < SPAN_COUNT; i++) {
        oracle_slope_span(t->oracle, spans[i][0], spans[i][1]);
        oracle_material(t->oracle, t->material, &surface, &sides[i]);
    }
    oracle_slope_span(t->oracle, -1, 1);
    for (int component = 0; differs && component < 4; component++)
        judge_slope(w, sides, slot, component);
}
