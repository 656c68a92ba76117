/* A scene's text with everything somewhere else: objects in a group that moves them, camera, the
 * keys of a path, lights. The text alone is changed, by libyaml, so that it goes through all that
 * reads scenes. */
#ifndef MATC_FRAME_MOVED_H
#define MATC_FRAME_MOVED_H
#include <stdbool.h>

typedef struct {
    double rotation[3]; /* of the group: radians about x, y, z, before the translation */
    double translation[3];
    bool apart; /* each object by its own translation instead, which is all that is done to it */
} FrameMove;

/* From malloc. */
char *frame_moved(const char *text, const FrameMove *move);
#endif
