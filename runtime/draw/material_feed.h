/* Attributes that a material reads of meshes by names of its document: attribute("wetness", float,
 * 0). */
#ifndef MATC_DRAW_MATERIAL_FEED_H
#define MATC_DRAW_MATERIAL_FEED_H
#include "runtime/draw/material.h"
#include "runtime/gl/mesh.h"

enum { MATERIAL_FEED_NAMES = 32 };

/* Lists them in the material; where its program declares no locations, they are bound by `names`,
 * of MATERIAL_FEED_NAMES, which the text then points at. False: see the context's error. */
bool material_feed_make(Material *material, const MatcProgram *program, const char **names,
                        ProgramText *text);
/* Gives its program what the mesh has of them; before each mesh that is drawn with it. */
void material_feed(const Material *material, const Mesh *mesh);
#endif
