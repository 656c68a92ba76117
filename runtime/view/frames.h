/* Which frames of a scene's motion are drawn, and the names of their files. */
#ifndef MATC_VIEW_FRAMES_H
#define MATC_VIEW_FRAMES_H
#include "runtime/scene/scene.h"
#include <stddef.h>

enum { FRAMES_MOST = 100000, FRAMES_ROOM = 80, FRAMES_A_SECOND = 25 };

/* {0}: none was asked for. */
typedef struct {
    bool given;
    int first, last; /* the first of all is 0 */
    int whole;       /* so many has the motion; 0: as many as the scene says */
} Frames;

/* "N": the motion in N frames; "A-B": those of the scene's, A to B. NULL, or what is wanted. */
const char *frames_read(const char *text, Frames *frames);
/* "K": that one of the scene's. */
const char *frames_read_one(const char *text, Frames *frames);
/* Fills in what the scene says. NULL, or what is wrong, perhaps in `room`. */
const char *frames_check(const Scene *scene, Frames *frames, char room[FRAMES_ROOM]);

/* Where the camera stands in a frame, and when that is. False: it has no direction. */
bool frames_place(const Frames *frames, const Scene *scene, int frame, Scene *seen);

/* A path whose only % begins %d, or %0 with up to nine places and d, as in out-%04d.png: with the
 * frame's number there. False: it has none, another %, or no room. */
bool frames_path(const char *pattern, int frame, char *path, size_t room);
#endif
