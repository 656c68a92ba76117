/* Params of materials that displace, and faults of displacing. */
#ifndef MATC_SCENE_DISPLACE_PARAM_H
#define MATC_SCENE_DISPLACE_PARAM_H
#include "runtime/scene/scene_displacer.h"

/* The values that params of a material have. */
Key scene_displacer_param_key(const SceneDisplacer *by, int material);
/* The material's displacement reads the param. */
bool scene_displacer_reads(const Scene *scene, int material, const char *name, int count);
/* Finds or adds it, with the value that it has; NULL: memory ran out. */
SceneDisplacedParam *scene_displacer_param(Scene *scene, int material, const char *name, int count);
/* Remembers why nothing can be made of a material; false. */
bool scene_displacer_fail(SceneDisplacer *by, int material, const char *why);
#endif
