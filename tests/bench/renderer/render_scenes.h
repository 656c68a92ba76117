/* The documents that matbench render draws. */
#ifndef RENDER_SCENES_H
#define RENDER_SCENES_H
#include "compiler/base/text.h"

enum { SCENES_QUADS = 2000, SCENES_MAX_LIGHTS = 1024 };

/* 2,000 parallelograms beside each other, two lights; `count` checkers that differ in colour and
 * scale, in turns. */
void scenes_materials(Text *out, int count);
/* A floor with 1,024 boxes on it, and a lamp over each of the first `count` of them, spread evenly,
 * all together as bright as one. */
void scenes_lights(Text *out, int count);
/* A bush of so many twigs and leaves, of four materials, in the light of the sun. */
void scenes_objects(Text *out, int count);
/* One of everything: solids on a plane, a sky, a spot and the sun with shadows, ten panes of glass,
 * a tone mapping that asks the picture. */
void scenes_passes(Text *out, int panes);
/* So many panes over the whole picture, lit by one lamp, not in the order of their depths. */
void scenes_panes(Text *out, int count);
/* A wall of a material over the whole picture, and so many lamps before it. */
void scenes_lobes(Text *out, const char *material, int count);
/* A further object of it, behind the camera: a coat and fuzz are among the scene's surfaces. */
void scenes_unseen(Text *out);
#endif
