/* Run time against error: compiles a material in several ways, draws each, and says how long a
 * pixel takes and how far the numbers are from the C reference and from a supersampled picture.
 * Prints nothing. */
#ifndef MATC_MEASURE_H
#define MATC_MEASURE_H
#include "runtime/measure/meter.h"
#include "runtime/measure/variant.h"

/* Distances are taken in units of max(1, |what it should be|), both sides kept to the slot's range:
 * of a colour it is the plain difference, of an exponent the relative one. A NaN is infinitely
 * far. */
typedef struct {
    double maximum, rms; /* of all lanes of all points; NaN: not measured */
} Distance;

typedef struct {
    Variant variant;
    double nanoseconds; /* a pixel of pass gbuffer, the constant colour's subtracted, at least 0 */
    Distance
        /* through the layout and back, against the reference; NaN: the layout lacks the slot */
        packed[SLOT_COUNT];
    Distance computed[SLOT_COUNT]; /* pass value, in floats, against the reference */
    Distance
        /* pass value at pixels' centres, against the supersampled picture; NaN for the normal */
        aliased[SLOT_COUNT];
    double error;     /* greatest packed[].maximum */
    double rms;       /* greatest packed[].rms */
    double aliasing;  /* greatest aliased[].rms */
    bool front;       /* no other is both faster and of less `error` */
    bool alias_front; /* the same for `aliasing` */
} Measured;

typedef struct {
    Measured *at;
    int count;
    int same;        /* variants that are the same program as one of these */
    int left_out;    /* variants for which there was no time */
    int refused;     /* variants that do not compile, or whose targets the driver lacks */
    double constant; /* nanoseconds a pixel of the constant colour */
} MeasuredList;

/* Request of a measurement. The document was read with `pixels`. */
typedef struct {
    const MatcDocument *document;
    int material;
    const MatcOptions *options; /* names what is fixed */
    VariantAxes open;           /* what is varied */
    double range;               /* coordinates of the points are in [-range, range] */
    /* u and v a unit of the plane that is looked at for aliasing and for the time; 0: 1 */
    double scale;
    double seconds; /* about how long it may take */
    bool aliasing;  /* measure it */
    void (*progress)(void *user, int done, int total);
    void *user;
} MeasureRequest;

enum { MEASURE_ROUNDS = 15, MEASURE_SIDE = 256 /* pixels of the view for aliasing */ };
extern const double measure_range; /* that of matc */

/* False: see meter->error. The list is from malloc; the first is the variant that the options
 * mean. */
bool measure_variants(Meter *meter, const MeasureRequest *request, MeasuredList *list);
void measure_free(MeasuredList *list);

/* Values of all points by the C reference, with the noise of a variant. `values` has room for
 * POINTS. False: they take more operations than the reference is given, and are not known. */
bool measure_reference(const MeasureRequest *request, const Variant *variant,
                       const FieldVertex *points, SlotValues *values);
/* Distance of one slot over the points; `lanes` components each. */
Distance measure_distance(Slot slot, const SlotValues *found, const SlotValues *wanted, int count);

/* Marks the members for which no other is better in one of time and error and as good in the other;
 * errors within a hundredth of each other are alike. */
typedef struct {
    double time, error;
    bool front;
} FrontPoint;
void front_mark(FrontPoint *points, int count);

/* The fastest whose error is at most `most`, which holds every slot that the first one holds; -1:
 * none. *best is that of least error, -1 for an empty list. */
int measure_choose(const MeasuredList *list, double most, int *best);

/* The table as CSV, a header line and a line each; `subject` fills the first column. From malloc.
 * Without `header`, lines alone. */
char *measure_csv(const MeasuredList *list, const char *subject, const GlContext *gl, bool header);
/* The list as a table for people. */
char *measure_table(const MeasuredList *list);
#endif
