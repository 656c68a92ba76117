/* Allowed distance of a shader from the oracle: tests/bounds.def, by the kinds, waves and slots
 * that contribute to a value. */
#ifndef MATC_VALUE_BOUNDS_H
#define MATC_VALUE_BOUNDS_H
#include "compiler/graph/graph.h"

/* A subject of the table is a kind, a wave, a slot, a keyword of words.def, or the default. */
enum {
    SUBJECT_KINDS = 0,
    SUBJECT_WAVES = KIND_COUNT,
    SUBJECT_SLOTS = SUBJECT_WAVES + WAVE_COUNT + 1,
    SUBJECT_WORDS = SUBJECT_SLOTS + SLOT_COUNT,
    SUBJECT_DEFAULT = SUBJECT_WORDS + WORD_COUNT,
    SUBJECT_COUNT
};

typedef struct {
    double bound; /* in units of max(1, |oracle|), outside of the hull */
    bool drivers; /* the bound is that of the driver's own functions */
    const char *why;
} Bound;
extern const Bound bound_table[SUBJECT_COUNT]; /* bound 0: no row */

typedef struct {
    bool has[SUBJECT_COUNT];
    bool displaced; /* the normal is that of the displaced surface */
} Subjects;

const char *subject_name(int subject);
/* Collects the maps and functions that contribute to a slot's value. */
void subjects_of(const Node *material, Slot slot, Subjects *subjects);
/* The subject with the greatest bound under that choice of functions. */
int subject_governing(const Subjects *subjects, Choice trigonometry);
/* True if the value depends on a displacement's slopes, which the oracle approximates by finite
 * differences. */
bool subjects_slopes(const Subjects *subjects, Choice derivatives);
/* True if the value depends on lattice noise. */
bool subjects_noise(const Subjects *subjects);
#endif
