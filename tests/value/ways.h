/* The modes in which test_value.c computes every value, and the accuracy required of each. */
#ifndef MATC_VALUE_WAYS_H
#define MATC_VALUE_WAYS_H
#include "tests/value/bounds.h"
#include "tests/value/documents.h"
#include "tests/value/points.h"

typedef struct {
    Target target;
    int optimize;
    Choice choice; /* the one that is not its axis' default, if any; of aa that is none here */
    bool buffered; /* numbers of the document come from a buffer */
} Way;

extern const Way way_table[];
extern const int way_count;

const char *way_name(const Way *way, bool front, char text[64]);
/* Over a document's own. */
void way_options(const Way *way, Slot slot, MatcOptions *options);
/* Whether its choice can change what the subjects make. */
bool way_matters(const Way *way, const Subjects *subjects);
/* Options of the oracle for a way. */
ReferenceNoise way_noise(const Way *way);
Choice way_derivatives(const Way *way);
/* Whether it belongs to this commit's share of the slots of a material with that number. */
bool way_taken(const Way *way, Slot slot, int number);
/* How far a value may lie outside of its hull, in units of max(1, |oracle|). */
double way_bound(const Way *way, const Document *document, int governing);
/* Whether the driver's sampler takes part, whose pictures are those of sampler.h. */
bool way_samples(const Way *way, const Subjects *subjects);
/* Whether the bound holds at the point; elsewhere a value has to be finite, and no more. */
bool way_judges(const Way *way, const Subjects *subjects, const Point *point);
#endif
