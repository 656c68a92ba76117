/* The option sets under which random documents are tried: modes.def. */
#ifndef MATC_STRESS_MODES_H
#define MATC_STRESS_MODES_H
#include "compiler/matc.h"
#include <stddef.h>

enum { MODE_OPTIONS = 3 };
typedef struct {
    const char *name;
    struct {
        const char *name, *value; /* terminated by a NULL name */
    } options[MODE_OPTIONS];
} StressMode;

extern const StressMode stress_modes[];
extern const int stress_mode_count;

/* Returns NULL for an unknown mode. */
const StressMode *stress_mode(const char *name);
void stress_mode_set(const StressMode *mode, MatcOptions *options);
#endif
