/* Looks up modes by name. */
#include "modes.h"
#include <string.h>

const StressMode stress_modes[] = {
#define MODE(name, ...) {#name, {__VA_ARGS__}},
#include "modes.def"
};
const int stress_mode_count = sizeof stress_modes / sizeof *stress_modes;

const StressMode *stress_mode(const char *name)
{
    for (int i = 0; i < stress_mode_count; i++)
        if (!strcmp(stress_modes[i].name, name))
            return &stress_modes[i];
    return NULL;
}

void stress_mode_set(const StressMode *mode, MatcOptions *options)
{
    for (int i = 0; i < MODE_OPTIONS && mode->options[i].name; i++)
        matc_options_set(options, mode->options[i].name, mode->options[i].value);
}
