/* Results of a run over many documents: its faults, one per slot, and the worst value of every
 * subject. Worker threads may add results concurrently. */
#ifndef MATC_VALUE_VERDICTS_H
#define MATC_VALUE_VERDICTS_H
#include "tests/value/bounds.h"
#include <pthread.h>

enum { VERDICTS_FAULTS = 200 };

/* A slot of a material that some modes draw wrongly, or that cannot be drawn. */
typedef struct {
    char slot[160]; /* document, material and slot; faults of one slot are merged */
    int count;
    double miss;
    char worst[500];
} Fault;

/* The worst errors of values to which a subject contributes. */
typedef struct {
    bool seen;
    double miss;
    char where[160];
} Worst;

typedef struct {
    pthread_mutex_t lock;
    Worst worst[SUBJECT_COUNT];
    Fault faults[VERDICTS_FAULTS];
    int fault_count;
    long values, sharp; /* number of compared values; and of those judged within a narrow hull */
} Verdicts;

/* Result of a draw. */
typedef struct {
    const char *name;
    double worst;
    int values, sharp;
    const Subjects *subjects;
    int governing; /* index of the subject whose bound counts */
} Seen;

void verdicts_open(Verdicts *verdicts); /* The struct must be all zero before. */
void verdicts_fault(Verdicts *verdicts, const char *slot, double miss, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* Records the worst error of a draw, for the subject whose bound counts or, without such a
 * subject, for all contributing ones. */
void verdicts_record(Verdicts *verdicts, const Seen *seen);
/* Prints a line for every subject, then one for every fault. */
void verdicts_print(const Verdicts *verdicts);
#endif
