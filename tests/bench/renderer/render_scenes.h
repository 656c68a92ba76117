/* The documents that matbench render draws. */
#ifndef RENDER_SCENES_H
#define RENDER_SCENES_H
#include "compiler/base/text.h"

enum { SCENES_QUADS = 2000, SCENES_MAX_LIGHTS = 1024 };

/* 2,000 adjacent parallelograms, two lights; `count` checkers of different color and scale, in
 * turns. */
void scenes_materials(Text *out, int count);
/* A floor with 1,024 boxes, and a lamp over each of the first `count`, spread evenly; the lamps'
 * total intensity is constant. */
void scenes_lights(Text *out, int count);
/* A bush of `count` twigs and leaves, of four materials, in sunlight. */
void scenes_objects(Text *out, int count);
/* A scene with every feature: solids on a plane, a sky, a spot and the sun with shadows, ten
 * panes of glass, a tone mapping that measures the picture. */
void scenes_passes(Text *out, int panes);
/* `count` panes over the whole picture, lit by one lamp, not sorted by depth. */
void scenes_panes(Text *out, int count);
/* A wall of a material over the whole picture, with `count` lamps in front. */
void scenes_lobes(Text *out, const char *material, int count);
/* Another object, behind the camera, which adds a coat and fuzz to the scene's surfaces. */
void scenes_unseen(Text *out);
#endif
