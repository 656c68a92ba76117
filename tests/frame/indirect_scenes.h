/* Scenes with goals for their indirect light: cameras, lights, materials and objects, to be
 * appended to a document that sets the picture's size and `indirect:`. */
#ifndef MATC_INDIRECT_SCENES_H
#define MATC_INDIRECT_SCENES_H

enum { INDIRECT_SCENES_TEXT = 2048 };

/* The Cornell box: walls as thick as a voxel of 64, and two boxes. Its lamp has no shadows, neither
 * here nor in what it is compared with. */
extern const char indirect_scenes_box[];
/* A mesh of a file, y up, so far above a slab: `lift` is 0.9913 for the bunny of glmark2-data. */
void indirect_scenes_bunny(const char *mesh, const char *lift, char text[INDIRECT_SCENES_TEXT]);
#endif
