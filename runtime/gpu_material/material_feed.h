/* Attributes of meshes that a material reads by names from its document: attribute("wetness",
 * float, 0). */
#ifndef MATC_GPU_MATERIAL_MATERIAL_FEED_H
#define MATC_GPU_MATERIAL_MATERIAL_FEED_H
#include "runtime/gpu_material/material.h"
#include "runtime/gl/mesh.h"

enum { MATERIAL_FEED_NAMES = 32 };

/* Lists the program's named attributes in the material. If the program declares no locations,
 * the attributes are bound by `names`, an array of MATERIAL_FEED_NAMES, to which `text` then
 * points. Returns false on failure; see the context's error. */
bool material_feed_make(Material *material, const MatcProgram *program, const char **names,
                        ProgramText *text);
/* Points the program's attributes to those of the mesh, before each mesh that is drawn. */
void material_feed(const Material *material, const Mesh *mesh);
#endif
