/* Errors of a variant: deviation of its slot values and its picture from the reference. */
#ifndef MATC_AUTOTUNE_ERRORS_H
#define MATC_AUTOTUNE_ERRORS_H
#include "runtime/autotune/autotune.h"
#include "runtime/autotune/meter.h"

/* Cached errors of a program of pass value, which several variants often share. */
typedef struct {
    char *fragment;
    int slot, truth; /* slot, and index of the reference in Errors.truth */
    Distance computed, aliased;
} Known;

/* Reference values shared by several variants. */
typedef struct {
    SlotValues *values;      /* slot values at the points, from the C reference */
    bool unknown;            /* the reference exceeded its operation limit */
    float *mean[SLOT_COUNT]; /* supersampled picture per slot; NULL: not drawn yet */
} Truth;

/* State of error measurement, with the cached results. */
typedef struct {
    Meter *meter;
    const AutotuneRequest *request;
    FieldVertex vertices[POINTS];
    Field points, view;
    Framebuffer picture;
    Known *known;
    int known_count, known_capacity;
    Truth truth[CHOICE_COUNT * CHOICE_COUNT]; /* indexed by the choices of noise and derivatives */
} Errors;

/* Opens error measurement. Returns false with the message in meter->error if render targets
 * cannot be created. Call errors_close in both cases. */
bool errors_open(Errors *e, Meter *meter, const AutotuneRequest *request);
void errors_close(Errors *e);
/* Returns whether reference values exist for a variant. Returns false with the message in
 * meter->error if the reference takes too long; then no variant with these choices can be
 * measured. */
bool errors_has_truth(Errors *e, const Variant *variant);
/* Measures m->variant from its program of pass gbuffer: creates its material and fills in all
 * errors of *m. Returns false if the program cannot be drawn. */
bool errors_measure(Errors *e, Measured *m, MatcProgram *program, Material *material);
/* Allocates with calloc; ends the process if memory runs out. */
void *errors_allocate(size_t count, size_t size);
#endif
