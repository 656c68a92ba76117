/* Where a draw stands and is seen from: all that matc's vertex programs, and the passes plane and
 * sky, are told by uniforms. */
#ifndef MATC_DRAW_SPACES_H
#define MATC_DRAW_SPACES_H
#include "runtime/draw/material.h"
#include "runtime/gl/matrix.h"

typedef struct {
    Mat4 world_from_local, eye_from_world, clip_from_eye;
    float origin[3];   /* in the world, of all positions here */
    float eye[3];      /* in the world */
    float viewer[4];   /* the eye and 1, or, of parallel rays, the direction toward it and 0 */
    float time;        /* seconds */
    float object;      /* the object's random number, in [0, 1) */
    float plane[3][3]; /* of the pass plane: origin, step of u, step of v */
    /* rays are parallel: `rays` says from where to where they are drawn instead */
    bool parallel;
    /* an eye; from there to the plane at the picture's middle; its step to the right, and
     * upwards */
    float rays[4][3];
    bool zero_to_one; /* depth in clip space is from 0 to 1: glClipControl; else from -1 */
} Spaces;

/* Sets those that the material's program has. */
void spaces_set(const Spaces *spaces, Material *material);
/* Its program reads the time. */
bool spaces_by_time(const Material *material);
#endif
