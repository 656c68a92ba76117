/* The modes in which test_value.c computes every value, and the accuracy required of each. */
#ifndef MATC_VALUE_WAYS_H
#define MATC_VALUE_WAYS_H
#include "tests/value/bounds.h"
#include "tests/value/documents.h"
#include "tests/value/points.h"

typedef struct {
    Target target;
    int optimize;
    /* the choice that is not its axis' default, if any; for aa, none is the default here */
    Choice choice;
    bool buffered; /* the document's constants come from a buffer */
} Way;

extern const Way way_table[];
extern const int way_count;

const char *way_name(const Way *way, bool front, char text[64]);
/* Sets a mode's options on top of the document's. */
void way_options(const Way *way, Slot slot, MatcOptions *options);
/* True if the mode's choice can change the subjects' values. */
bool way_matters(const Way *way, const Subjects *subjects);
/* The oracle's noise for a mode. */
ReferenceNoise way_noise(const Way *way);
Choice way_derivatives(const Way *way);
/* True if the mode is in this commit's share of the slots of the material with that number. */
bool way_taken(const Way *way, Slot slot, int number);
/* Tolerance of a value outside of its hull, in units of max(1, |oracle|). */
double way_bound(const Way *way, const Document *document, int governing);
/* True if the driver's sampler is used, whose pictures are those of sampler.h. */
bool way_samples(const Way *way, const Subjects *subjects);
/* True if the bound holds at the point; elsewhere a value only has to be finite. */
bool way_judges(const Way *way, const Subjects *subjects, const Point *point);
#endif
