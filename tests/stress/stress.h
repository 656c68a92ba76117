/* Tries many random documents in every mode. */
#ifndef MATC_STRESS_STRESS_H
#define MATC_STRESS_STRESS_H
#include "generate.h"
#include "trial.h"
#include <stdio.h>

typedef struct {
    void (*generate)(Choices *choices, Text *text); /* default: generate_document */
    uint64_t seed;
    long first, count;
    /* every n-th tree is validated by glslang, and drawn; 0: none */
    long validate_every, draw_every;
    int threads;
    int points;          /* points per tree */
    int faults;          /* max faults before the run ends */
    const char *folder;  /* folder for documents with faults, or NULL */
    bool progress;       /* show progress on a terminal */
    MatcOptions options; /* compile options */
    FILE *out;
} StressOptions;

void stress_options_init(StressOptions *options);
/* Returns the number of faults; adds the work done to `total`. */
int stress_run(const StressOptions *options, TrialCount *total);
/* Tests one given document with `count` pixels in turn, and draws every `draw_every`th. Skips
 * documents with numbers outside the limits; large intermediate numbers are no excuse. */
int stress_document(const StressOptions *options, const char *text, size_t size, TrialCount *total);
#endif
