/* Parses frame numbers in options and expands them in file names. */
#include "runtime/viewer/frames.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Parses decimal digits. Returns the end, or NULL if digits are missing or the number exceeds
 * FRAMES_MAX. */
static const char *read_number(const char *text, int *number)
{
    const size_t digits = strspn(text, "0123456789");
    *number = digits && digits < 8 ? atoi(text) : -1;
    return *number >= 0 && *number <= FRAMES_MAX ? text + digits : NULL;
}

const char *frames_read(const char *text, Frames *frames)
{
    int first;
    const char *end = read_number(text, &first);
    *frames = (Frames){.given = true, .last = first - 1, .whole = first};
    if (end && !*end && first > 0)
        return NULL;
    *frames = (Frames){.given = true, .first = first};
    end = end && *end == '-' ? read_number(end + 1, &frames->last) : NULL;
    return end && !*end && frames->last >= first
               ? NULL
               : "--frames expects a number from 1 on, or a range such as 10-19";
}

const char *frames_read_one(const char *text, Frames *frames)
{
    *frames = (Frames){.given = true};
    const char *end = read_number(text, &frames->first);
    frames->last = frames->first;
    return end && !*end ? NULL : "--frame expects a number from 0 on";
}

const char *frames_check(const Scene *scene, Frames *frames, char reason[FRAMES_CAPACITY])
{
    if (!frames->given)
        return NULL;
    if (!scene->motion.frames)
        return "--frames and --frame need a scene with `motion:`";
    frames->whole = frames->whole ? frames->whole : scene->motion.frames;
    if (frames->last < frames->whole)
        return NULL;
    snprintf(reason, FRAMES_CAPACITY, "the motion has the frames 0 to %d, and no frame %d",
             frames->whole - 1, frames->last);
    return reason;
}

bool frames_place(const Frames *frames, const Scene *scene, int frame, Scene *seen)
{
    seen->time = scene->time + (double)frame / FRAMES_A_SECOND;
    return !frames->given || scene_motion_camera(scene, frame, frames->whole, &seen->camera);
}

/* Returns the minimum field width of a %d or %0Nd conversion; -1: another conversion. */
static int places_of(const char *percent, const char **end)
{
    const char *at = percent + 1;
    int places = 0;
    if (at[0] == '0' && at[1] >= '1' && at[1] <= '9') {
        places = at[1] - '0';
        at += 2;
    }
    *end = at + 1;
    return *at == 'd' ? places : -1;
}

bool frames_path(const char *pattern, int frame, char *path, size_t reason)
{
    const char *percent = strchr(pattern, '%'), *end = "";
    const int places = percent ? places_of(percent, &end) : -1;
    if (places < 0 || strchr(end, '%'))
        return false;
    const int size =
        snprintf(path, reason, "%.*s%0*d%s", (int)(percent - pattern), pattern, places, frame, end);
    return size >= 0 && (size_t)size < reason;
}
