#include "tests/value/verdicts.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void verdicts_open(Verdicts *verdicts) { pthread_mutex_init(&verdicts->lock, NULL); }

static Fault *fault_of(Verdicts *verdicts, const char *slot)
{
    for (int i = 0; i < verdicts->fault_count; i++)
        if (!strcmp(verdicts->faults[i].slot, slot))
            return &verdicts->faults[i];
    if (verdicts->fault_count == VERDICTS_FAULTS)
        return NULL;
    Fault *fault = &verdicts->faults[verdicts->fault_count++];
    snprintf(fault->slot, sizeof fault->slot, "%s", slot);
    return fault;
}

void verdicts_fault(Verdicts *verdicts, const char *slot, double miss, const char *format, ...)
{
    va_list args;
    pthread_mutex_lock(&verdicts->lock);
    Fault *fault = fault_of(verdicts, slot);
    if (fault && (miss > fault->miss || !fault->count)) {
        va_start(args, format);
        vsnprintf(fault->worst, sizeof fault->worst, format, args);
        va_end(args);
        fault->miss = miss;
    }
    if (fault)
        fault->count++;
    pthread_mutex_unlock(&verdicts->lock);
}

void verdicts_record(Verdicts *verdicts, const Seen *seen)
{
    pthread_mutex_lock(&verdicts->lock);
    verdicts->values += seen->values;
    verdicts->sharp += seen->sharp;
    for (int i = 0; i < SUBJECT_COUNT; i++) {
        Worst *w = &verdicts->worst[i];
        bool counts =
            i == seen->governing || (seen->governing == SUBJECT_DEFAULT && !bound_table[i].bound);
        if (!seen->subjects->has[i] || !counts || (w->seen && seen->worst <= w->miss))
            continue;
        w->seen = true;
        w->miss = seen->worst;
        snprintf(w->where, sizeof w->where, "%s", seen->name);
    }
    pthread_mutex_unlock(&verdicts->lock);
}

void verdicts_print(const Verdicts *verdicts)
{
    printf("%-24s %9s %9s  worst at\n", "subject", "bound", "worst");
    for (int i = 0; i < SUBJECT_COUNT; i++)
        if (verdicts->worst[i].seen && bound_table[i].bound > 0)
            printf("%-24s %9.2g %9.2g  %s\n", subject_name(i), bound_table[i].bound,
                   verdicts->worst[i].miss, verdicts->worst[i].where);
        else if (verdicts->worst[i].seen)
            printf("%-24s %9s %9.2g  %s\n", subject_name(i), "", verdicts->worst[i].miss,
                   verdicts->worst[i].where);
    for (int i = 0; i < verdicts->fault_count; i++)
        fprintf(stderr, "%s (%d): %s\n", verdicts->faults[i].slot, verdicts->faults[i].count,
                verdicts->faults[i].worst);
}
