/* Delta debugging in passes over the script until a pass finds no improvement: runs of choices
 * are removed, runs are set to 0, numbers are decreased. */
#include "shrink.h"
#include <string.h>

static bool still_fails(Shrinker *s, const uint32_t *script, int count)
{
    return s->tries-- > 0 && s->fails(s->user, script, count);
}

/* Tries the script without choices first..first+length-1. */
static bool leave_out(Shrinker *s, uint32_t *script, int *count, int first, int length)
{
    uint32_t shorter[MAX_CHOICES];
    int rest = *count - first - length;
    memcpy(shorter, script, sizeof *script * (size_t)first);
    memcpy(shorter + first, script + first + length, sizeof *script * (size_t)rest);
    if (!still_fails(s, shorter, *count - length))
        return false;
    *count -= length;
    memcpy(script, shorter, sizeof *script * (size_t)*count);
    return true;
}

static bool zero(Shrinker *s, uint32_t *script, int count, int first, int length)
{
    uint32_t simpler[MAX_CHOICES];
    bool any = false;
    memcpy(simpler, script, sizeof *script * (size_t)count);
    for (int i = first; i < first + length; i++) {
        any |= simpler[i] != 0;
        simpler[i] = 0;
    }
    if (!any || !still_fails(s, simpler, count))
        return false;
    memcpy(script, simpler, sizeof *script * (size_t)count);
    return true;
}

/* Finds the smallest failing value of a choice, by bisection. */
static void lessen(Shrinker *s, uint32_t *script, int count, int i)
{
    uint32_t fine = script[i], least = 0;
    while (least < fine) {
        script[i] = least + (fine - least) / 2;
        if (still_fails(s, script, count))
            fine = script[i];
        else
            least = script[i] + 1;
    }
    script[i] = fine;
}

int shrink(Shrinker *s, uint32_t *script, int count)
{
    for (bool better = true; better && s->tries > 0;) {
        better = false;
        for (int length = count; length > 0; length /= 2)
            for (int first = count - length; first >= 0; first -= length > 1 ? length / 2 : 1)
                if (first + length <= count)
                    better |= leave_out(s, script, &count, first, length);
        for (int length = 8; length > 0; length /= 2)
            for (int first = 0; first + length <= count; first += length)
                better |= zero(s, script, count, first, length);
    }
    for (int i = 0; i < count && s->tries > 0; i++)
        lessen(s, script, count, i);
    while (count > 0 && script[count - 1] == 0)
        count--;
    return count;
}
