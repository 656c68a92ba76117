/* Shrinks a script of choices that leads to a fault, as long as the fault persists. Does not
 * interpret the choices. */
#ifndef MATC_STRESS_SHRINK_H
#define MATC_STRESS_SHRINK_H
#include "choices.h"

typedef struct {
    /* Whether what the script leads to still has the fault. */
    bool (*fails)(void *user, const uint32_t *script, int count);
    void *user;
    int tries; /* that may still be made */
} Shrinker;

/* In place; the new count. */
int shrink(Shrinker *s, uint32_t *script, int count);
#endif
