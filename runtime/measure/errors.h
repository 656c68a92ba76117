/* How far the numbers and the picture of a variant are from what they should be. */
#ifndef MATC_MEASURE_ERRORS_H
#define MATC_MEASURE_ERRORS_H
#include "runtime/measure/measure.h"
#include "runtime/measure/meter.h"

/* A program of pass value whose errors are known: variants often share it. */
typedef struct {
    char *fragment;
    int slot, truth; /* of the reference */
    Distance computed, aliased;
} Known;

/* Values that several variants are compared with. */
typedef struct {
    SlotValues *values;      /* by the C reference */
    bool unknown;            /* they take it too many operations */
    float *mean[SLOT_COUNT]; /* supersampled; NULL: not made yet */
} Truth;

/* State of drawing, and results of the programs that were drawn. */
typedef struct {
    Meter *meter;
    const MeasureRequest *request;
    FieldVertex vertices[POINTS];
    Field points, view;
    Framebuffer picture;
    Known *known;
    int known_count, known_room;
    Truth truth[CHOICE_COUNT * CHOICE_COUNT]; /* by the choices of noise and derivatives */
} Errors;

/* False, with a word in the meter: there is no room to draw in. Closed either way. */
bool errors_open(Errors *e, Meter *meter, const MeasureRequest *request);
void errors_close(Errors *e);
/* False, with a word in the meter: the reference takes too long for what nothing can then be
 * compared with. */
bool errors_has_truth(Errors *e, const Variant *variant);
/* Measures m->variant, whose program of pass gbuffer is given: makes its material, and fills in all
 * errors of m. False: it cannot be drawn. */
bool errors_measure(Errors *e, Measured *m, MatcProgram *program, Material *material);
/* From calloc; memory that is missing ends the process. */
void *errors_room(size_t count, size_t size);
#endif
