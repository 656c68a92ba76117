/* Allowed distance of a shader from the oracle: tests/bounds.def, by the kinds, waves and slots
 * that contribute to a value. */
#ifndef MATC_VALUE_BOUNDS_H
#define MATC_VALUE_BOUNDS_H
#include "compiler/graph/graph.h"

/* A subject of the table is a kind, a wave, a slot or a word of words.def, or none of them. */
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
    bool drivers; /* it is of the driver's own functions */
    const char *why;
} Bound;
extern const Bound bound_table[SUBJECT_COUNT]; /* bound 0: no row */

typedef struct {
    bool has[SUBJECT_COUNT];
    bool displaced; /* the normal is that of a surface after it was displaced */
} Subjects;

const char *subject_name(int subject);
/* Maps and functions that the value of a slot is made of. */
void subjects_of(const Node *material, Slot slot, Subjects *subjects);
/* The subject whose bound counts with that choice of functions: the one with the greatest. */
int subject_governing(const Subjects *subjects, Choice trigonometry);
/* Whether a displacement's slopes are among them. The oracle has differences for these. */
bool subjects_slopes(const Subjects *subjects, Choice derivatives);
/* Whether lattice noise is among them. */
bool subjects_noise(const Subjects *subjects);
#endif
