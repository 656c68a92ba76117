/* A method of indirect light: how rays find their hits. A method is a row in a folder of its
 * own, next to its GLSL; runtime/indirect/indirect_methods.c lists the rows. */
#ifndef MATC_INDIRECT_INDIRECT_METHOD_H
#define MATC_INDIRECT_INDIRECT_METHOD_H
#include "grammar/tables.h"

/* Inputs of a method's rays, in addition to depth, G-buffer and light. */
typedef enum {
    INDIRECT_READS_voxels = 1,
    INDIRECT_READS_voxels_by_march = 2, /* reads voxels if the key `march` selects them */
    /* reads the radiance cache for hits that are not on screen */
    INDIRECT_READS_radiance = 4,
    INDIRECT_READS_near = 8 /* reads the depth buffer, for a ray's first voxels only */
} IndirectReads;

typedef struct {
    Keyword word; /* the method's keyword of the list Indirect */
    /* `auto` selects the first row with this flag that the scene and the driver support */
    bool automatic;
    unsigned reads;  /* a set of IndirectReads */
    bool unlit;      /* the method finds ambient occlusion, but no light */
    bool one_shift;  /* a pixel's samples share one random shift */
    int steps;       /* default of the key `steps` */
    const char *ray; /* GLSL after voxel_map.glsl: a ray through voxels; NULL without voxels */
    const char *hit; /* GLSL of indirectMeet(): intersects a ray with the scene */
    /* GLSL of indirectAround(), the mean over a hemisphere; NULL: the mean over rays
     * (indirect_rays.glsl) */
    const char *around;
} IndirectMethod;
#endif
