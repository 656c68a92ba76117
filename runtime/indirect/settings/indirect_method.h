/* A method of indirect light: how rays find what they hit. A method is a row in a folder of its
 * own, beside its GLSL; runtime/indirect/indirect_methods.c lists the rows. */
#ifndef MATC_INDIRECT_INDIRECT_METHOD_H
#define MATC_INDIRECT_INDIRECT_METHOD_H
#include "grammar/tables.h"

/* Inputs of a method's rays beside depth, G-buffer and light. */
typedef enum {
    INDIRECT_READS_voxels = 1,
    INDIRECT_READS_voxels_by_march = 2, /* voxels if the key `march` selects them */
    INDIRECT_READS_radiance = 4,        /* cached radiance: hits have light that is not on screen */
    INDIRECT_READS_near = 8             /* the picture, for the first voxels of a ray alone */
} IndirectReads;

typedef struct {
    Word word;       /* of the list Indirect */
    bool automatic;  /* `auto` selects the first such row that the scene and the driver allow */
    unsigned reads;  /* a set of IndirectReads */
    bool unlit;      /* finds ambient occlusion alone */
    bool one_shift;  /* a pixel's samples share one random shift */
    int steps;       /* the value of the key `steps` if it is 0 */
    const char *ray; /* GLSL behind voxel_map.glsl, a ray through voxels; NULL without voxels */
    const char *hit; /* GLSL of indirectMeet(): what one ray hits */
    /* GLSL of indirectAround(), the mean over a hemisphere; NULL: over rays (indirect_rays.glsl) */
    const char *around;
} IndirectMethod;
#endif
