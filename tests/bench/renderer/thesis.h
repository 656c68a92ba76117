/* matbench thesis: tables 5.2 to 5.6 of Hartmann 2010, with its numbers beside ours. */
#ifndef THESIS_H
#define THESIS_H
#include "render_time.h"

/* Scenes of the thesis that are models of GroIMP's own. A generated scene replaces each. It has as
 * many objects as the thesis states nodes, and the kinds of materials and lights that the thesis
 * describes. */
typedef enum {
    THESIS_city,
    THESIS_plants,
    THESIS_boids,
    THESIS_helicopter,
    THESIS_SCENES
} ThesisScene;

/* Writes the document of a generated scene. object_count includes the ground. */
void thesis_scene(Text *out, ThesisScene scene, int object_count);
/* Writes 4,000 spheres of 80 materials. */
void thesis_spheres(Text *out);
/* Writes a black plane with `count` spheres on it and a lamp without shadows above each. The sum of
 * all lamps is as bright as a single lamp. */
void thesis_lights(Text *out, int count);
#endif
