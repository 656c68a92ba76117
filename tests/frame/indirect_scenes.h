/* Scenes with goals for their indirect light: cameras, lights, materials and objects, to be
 * appended to a document that sets the picture's size and `indirect:`. */
#ifndef MATC_INDIRECT_SCENES_H
#define MATC_INDIRECT_SCENES_H

enum { INDIRECT_SCENES_TEXT = 2048 };

/* The Cornell box: walls one voxel thick at 64 voxels, and two boxes. Its lamp casts no shadows,
 * neither here nor in the reference. */
extern const char indirect_scenes_box[];
/* A mesh file, y up, `lift` above a slab: 0.9913 for the bunny of glmark2-data. */
void indirect_scenes_bunny(const char *mesh, const char *lift, char text[INDIRECT_SCENES_TEXT]);
#endif
