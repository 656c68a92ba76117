/* Selects the frames of a scene's motion to draw, and names their files. */
#ifndef MATC_VIEWER_FRAMES_H
#define MATC_VIEWER_FRAMES_H
#include "runtime/scene/scene.h"
#include <stddef.h>

enum { FRAMES_MAX = 100000, FRAMES_CAPACITY = 80, FRAMES_A_SECOND = 25 };

/* Range of frames; {0}: no frames were requested. */
typedef struct {
    bool given;
    int first, last; /* inclusive, counted from 0 */
    int whole;       /* frame count of the motion; 0: the scene's own count */
} Frames;

/* Parses "N" (the motion in N frames) or "A-B" (frames A to B of the scene's own count). Returns
 * NULL, or the usage message. */
const char *frames_read(const char *text, Frames *frames);
/* Parses "K" (frame K of the scene's own count). Returns NULL, or the usage message. */
const char *frames_read_one(const char *text, Frames *frames);
/* Completes the range from the scene. Returns NULL, or an error message, which may be stored in
 * `capacity`. */
const char *frames_check(const Scene *scene, Frames *frames, char reason[FRAMES_CAPACITY]);

/* Sets the camera and the time of `seen` for a frame. Returns false if the camera's direction is
 * degenerate. */
bool frames_place(const Frames *frames, const Scene *scene, int frame, Scene *seen);

/* Expands the frame number in a pattern with a single % of the form %d or %0Nd (N from 1 to 9),
 * as in out-%04d.png. Returns false if the pattern has no or another %, or if the path exceeds
 * `capacity` bytes. */
bool frames_path(const char *pattern, int frame, char *path, size_t reason);
#endif
