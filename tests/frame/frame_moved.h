/* A scene's text with all of its content translated: objects are put into a group that moves
 * them, and the camera, a path's keys and lights are moved. Only the text is changed, by
 * libyaml, so that the change passes through every reader of scenes. */
#ifndef MATC_FRAME_MOVED_H
#define MATC_FRAME_MOVED_H
#include <stdbool.h>

typedef struct {
    double rotation[3]; /* rotation of the group: radians about x, y, z, before the translation */
    double translation[3];
    bool apart; /* only add to each object's own translation, without a group */
} FrameMove;

/* From malloc. */
char *frame_moved(const char *text, const FrameMove *move);
#endif
