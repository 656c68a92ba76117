/* Params of displacing materials, and failures of displacement. */
#ifndef MATC_SCENE_DISPLACE_PARAM_H
#define MATC_SCENE_DISPLACE_PARAM_H
#include "runtime/scene/scene_displacer.h"

/* Returns the hash of a material's param values. */
Key scene_displacer_param_key(const SceneDisplacer *by, int material);
/* Returns whether the material's displacement reads the param. */
bool scene_displacer_reads(const Scene *scene, int material, const char *name, int count);
/* Finds or adds a param, with its current value; NULL: out of memory. */
SceneDisplacedParam *scene_displacer_param(Scene *scene, int material, const char *name, int count);
/* Records why a material's displacement failed; returns false. */
bool scene_displacer_fail(SceneDisplacer *by, int material, const char *why);
#endif
