/* Transforms of a draw: the uniforms of matc's vertex programs, and of the passes plane and sky. */
#ifndef MATC_GPU_MATERIAL_SPACES_H
#define MATC_GPU_MATERIAL_SPACES_H
#include "runtime/gpu_material/material.h"
#include "runtime/gl/matrix.h"

typedef struct {
    Mat4 world_from_local, eye_from_world, clip_from_eye;
    float origin[3]; /* origin in world space of all positions here */
    float eye[3];    /* position of the eye in world space */
    /* perspective: the eye, and 1; parallel rays: the direction to the eye, and 0 */
    float viewer[4];
    float time;        /* time in seconds */
    float object;      /* the object's random number, in [0, 1) */
    float plane[3][3]; /* mapping of the pass plane: origin, step of u, step of v */
    /* Rays are parallel: the pass plane draws the rays of `rays` instead. */
    bool parallel;
    /* Parallel rays of the pass plane: an eye; the vector from the eye to the plane at the
     * picture's center; the vectors on the plane from that point to the right and upper border
     * of the picture. */
    float rays[4][3];
    bool zero_to_one; /* clip space depth is 0 to 1, by glClipControl; else -1 to 1 */
} Spaces;

/* Sets all transforms that the material's program reads. */
void spaces_set(const Spaces *spaces, Material *material);
/* Reports whether the material's program reads the time. */
bool spaces_by_time(const Material *material);
#endif
