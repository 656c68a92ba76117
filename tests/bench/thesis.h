/* matbench thesis: tables 5.2 to 5.6 of Hartmann 2010, with its numbers beside ours. */
#ifndef THESIS_H
#define THESIS_H
#include "render_time.h"

/* Scenes of the thesis that are models of GroIMP's own. Each is stood in for by a generated scene with as many objects as
 * the thesis gives nodes, and with what the thesis says of its materials and lights. */
typedef enum { THESIS_city, THESIS_plants, THESIS_boids, THESIS_helicopter, THESIS_SCENES } ThesisScene;

/* Writes the document of a stand-in; object_count counts all of its objects, the ground too. */
void thesis_scene(Text *out, ThesisScene scene, int object_count);
/* Writes 4,000 spheres of 80 materials. */
void thesis_spheres(Text *out);
/* Writes a black plane with `count` spheres on it, and a lamp without shadows above each, all as bright as one together. */
void thesis_lights(Text *out, int count);
#endif
