#include "tests/frame/flicker.h"
#include <stdlib.h>
#include <string.h>

static const float bright = 1e-7f; /* below, no light could arrive */

bool flicker_open(int pixels, Flicker *made)
{
    *made = (Flicker){pixels, malloc((size_t)pixels), calloc((size_t)pixels, sizeof *made->turns)};
    if (made->lit && made->turns)
        memset(made->lit, -1, (size_t)pixels);
    else
        flicker_close(made);
    return made->lit;
}

static void add(Flicker *flicker, int pixel, float share)
{
    const signed char lit = share >= .5f;
    if (share < 0)
        return;
    flicker->turns[pixel] += flicker->lit[pixel] >= 0 && flicker->lit[pixel] != lit;
    flicker->lit[pixel] = lit;
}

void flicker_add(Flicker *flicker, const float *shares)
{
    for (int i = 0; i < flicker->pixels; i++)
        add(flicker, i, shares[i]);
}

void flicker_add_pictures(Flicker *flicker, const float *with, const float *without)
{
    for (int i = 0; i < flicker->pixels; i++)
        add(flicker, i, without[4 * i] > bright ? with[4 * i] / without[4 * i] : -1);
}

long flicker_count(const Flicker *flicker, const Flicker *truth)
{
    long count = 0;
    for (int i = 0; i < flicker->pixels; i++)
        if (flicker->turns[i] > truth->turns[i])
            count += (flicker->turns[i] - truth->turns[i]) / 2;
    return count;
}

long flicker_turns(const Flicker *flicker)
{
    long count = 0;
    for (int i = 0; i < flicker->pixels; i++)
        count += flicker->turns[i];
    return count;
}

void flicker_close(Flicker *flicker)
{
    free(flicker->lit);
    free(flicker->turns);
    *flicker = (Flicker){0};
}
