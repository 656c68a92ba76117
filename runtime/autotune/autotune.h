/* Run time against error: compiles a material in several variants, draws each, and reports its
 * time per pixel and its deviation from the C reference and from a supersampled picture. Prints
 * nothing. */
#ifndef MATC_AUTOTUNE_H
#define MATC_AUTOTUNE_H
#include "runtime/autotune/meter.h"
#include "runtime/autotune/variant.h"

/* Errors are measured in units of max(1, |reference|), with both values clamped to the slot's
 * range: the absolute difference for a color, the relative one for an exponent. NaN counts as
 * infinite error. */
typedef struct {
    double maximum, rms; /* errors over all components of all points; NaN: not measured */
} Distance;

typedef struct {
    Variant variant;
    /* time per pixel of pass gbuffer, minus the time of a constant color, at least 0 */
    double nanoseconds;
    /* error after packing into the layout and unpacking; NaN: slot not in the layout */
    Distance packed[SLOT_COUNT];
    Distance computed[SLOT_COUNT]; /* error of pass value in floats, against the reference */
    /* pass value sampled at pixel centers, against the supersampled picture; NaN for normals */
    Distance aliased[SLOT_COUNT];
    double error;     /* max of packed[].maximum */
    double rms;       /* max of packed[].rms */
    double aliasing;  /* max of aliased[].rms */
    bool front;       /* the variant is on the Pareto front of time and `error` */
    bool alias_front; /* the variant is on the Pareto front of time and `aliasing` */
} Measured;

typedef struct {
    Measured *at;
    int count;
    int same;        /* variants whose program equals another variant's */
    int left_out;    /* variants skipped because time ran out */
    int refused;     /* variants that fail to compile, or whose render targets the driver lacks */
    double constant; /* nanoseconds per pixel of the constant color */
} MeasuredList;

/* Request of a measurement. The document must have been read with MatcOptions.pixels. */
typedef struct {
    const MatcDocument *document;
    int material;
    const MatcOptions *options; /* names the fixed choices */
    VariantAxes open;           /* axes to vary */
    double range;               /* coordinates of the points are in [-range, range] */
    /* Units of u and v per length unit of the plane that is drawn for aliasing and timing; 0: 1. */
    double scale;
    double seconds; /* approximate time budget in seconds */
    bool aliasing;  /* also measure aliasing */
    void (*progress)(void *user, int done, int total);
    void *user;
} AutotuneRequest;

enum { MEASURE_ROUNDS = 15, MEASURE_SIDE = 256 /* picture size for aliasing, in pixels */ };
extern const double measure_range; /* matc's default range */

/* Measures all variants. list->at is from malloc; its first member is the variant given by the
 * options. Returns false with the reason in meter->error. */
bool autotune_variants(Meter *meter, const AutotuneRequest *request, MeasuredList *list);
void autotune_free(MeasuredList *list);

/* Evaluates all points with the C reference and the variant's noise. `values` holds POINTS
 * elements. Returns false if the evaluation exceeds the reference's operation limit; then the
 * values are undefined. */
bool autotune_reference(const AutotuneRequest *request, const Variant *variant,
                        const FieldVertex *points, SlotValues *values);
/* Returns the errors of one slot over `count` points. */
Distance autotune_distance(Slot slot, const SlotValues *found, const SlotValues *wanted, int count);

/* Pareto front: marks the points that no other point dominates. A point dominates another if it
 * is at least as good in time and error and better in one of them. Errors within 1% of each
 * other count as equal. */
typedef struct {
    double time, error;
    bool front;
} FrontPoint;
void front_mark(FrontPoint *points, int count);

/* Returns the index of the fastest variant with error <= most that holds every slot of the first
 * variant; -1: none. *best is the index of the smallest error, or -1 for an empty list. */
int autotune_choose(const MeasuredList *list, double most, int *best);

/* Formats the list as CSV, one line per variant. `subject` fills the first column; `header` adds
 * a header line. Returns a string from malloc. */
char *autotune_csv(const MeasuredList *list, const char *subject, const GlContext *gl, bool header);
/* Formats the list as a readable table. Returns a string from malloc. */
char *autotune_table(const MeasuredList *list);
#endif
