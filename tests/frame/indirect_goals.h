/* Goals for ambient occlusion and indirect light, as rows: the error against many rays in
 * double, the cost of the passes, and the cost of the thesis' march in the same run. */
#ifndef MATC_INDIRECT_GOALS_H
#define MATC_INDIRECT_GOALS_H
#include <stdbool.h>

typedef struct {
    /* a bunny's file, y up, and its height above the ground; NULL: only rows of the box */
    const char *mesh, *lift;
    const char *const *keys; /* settings of rows, instead of the goals' own */
    int key_count;
    bool timed;
} IndirectGoals;

/* Prints the rows. Returns false if a goal is missed. */
bool indirect_goals_print(const IndirectGoals *goals);
#endif
