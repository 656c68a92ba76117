/* A chart of materials: a sphere for each, in rows. */
#ifndef ENGINE_SCENE_H
#define ENGINE_SCENE_H
#include "gl.h"
#include "manifest.h"

enum { SCENE_CELL = 120 }; /* pixels of a sphere's square in the picture */

/* Compiles every program once and gives each material its buffer range and textures, then draws all
 * into a G-buffer and lights it by the GLSL `light` behind the manifest's own reading code. Pixels
 * of the frame, 4 bytes each, the bottom row first; from malloc. */
unsigned char *scene_draw(const Manifest *manifest, const char *light, int *width, int *height);
#endif
