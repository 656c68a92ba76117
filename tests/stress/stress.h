/* Tries many random documents in every mode. */
#ifndef MATC_STRESS_STRESS_H
#define MATC_STRESS_STRESS_H
#include "generate.h"
#include "trial.h"
#include <stdio.h>

typedef struct {
    void (*generate)(Choices *choices, Text *text); /* generate_document at first */
    uint64_t seed;
    long first, count;
    long validate_every, draw_every; /* which trees glslang and the driver see; 0: none */
    int threads;
    int points;          /* of a tree */
    int faults;          /* after which it ends */
    const char *folder;  /* documents of faults are written here, or NULL */
    bool progress;       /* on a terminal */
    MatcOptions options; /* choices */
    FILE *out;
} StressOptions;

void stress_options_init(StressOptions *options);
/* The number of faults; what was done is added to `total`. */
int stress_run(const StressOptions *options, TrialCount *total);
/* Tests one given document, with `count` pixels in turn, of which every `draw_every`th is drawn, if
 * it only uses numbers within the limits; a large intermediate number is no excuse. */
int stress_document(const StressOptions *options, const char *text, size_t size, TrialCount *total);
#endif
