/* Shrinks a script of choices that leads to a fault, as long as the fault persists. Does not
 * interpret the choices. */
#ifndef MATC_STRESS_SHRINK_H
#define MATC_STRESS_SHRINK_H
#include "choices.h"

typedef struct {
    /* Returns true if the script's document still has the fault. */
    bool (*fails)(void *user, const uint32_t *script, int count);
    void *user;
    int tries; /* remaining number of tries */
} Shrinker;

/* Shrinks in place; returns the new count. */
int shrink(Shrinker *s, uint32_t *script, int count);
#endif
