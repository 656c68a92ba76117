/* The parts of a scene, each from its thing into r->scene. Faults are told, and r->fine is false
 * then. */
#ifndef MATC_SCENE_PART_H
#define MATC_SCENE_PART_H
#include "runtime/scene_reader/scene_thing.h"

/* All objects of a list, groups in it too. scene_objects.c */
void scene_objects_read(SceneReader *r, const Tree *list);
/* Tells what is wrong with definitions that nothing has instanced; they are not in the scene. After
 * all objects are read. */
void scene_objects_check_unused(SceneReader *r);
/* Objects under `defs:`. scene_definition.c */
void scene_definition_open(SceneReader *r, const Tree *document);
/* That of a name, which is instanced from now on. NULL: told. */
Tree *scene_definition_find(SceneReader *r, const Tree *name);
/* The i-th, if it is an object that nothing has instanced; else NULL. */
Tree *scene_definition_unused(const SceneReader *r, uint32_t i);
/* `defs:` without objects: maps and materials. */
Tree *scene_definition_others(SceneReader *r, Tree *defs);
/* scene_light.c */
void scene_lights_read(SceneReader *r, const Tree *list);
/* The lights of kind Sky, after all materials are resolved. scene_sun.c */
void scene_sun_add(SceneReader *r);
/* NULL: the default. scene_camera_read.c */
void scene_camera_read(SceneReader *r, Tree *tree);
/* After the camera. scene_motion_read.c */
void scene_motion_read(SceneReader *r, Tree *tree);

/* NULL: there is none. scene_indirect.c */
void scene_indirect_read(SceneReader *r, Tree *tree);

/* Counts the triangles of an object whose mesh no object before it has. False: they are too many,
 * which is told. scene_triangles.c */
bool scene_triangles_add(SceneReader *r, const SceneThing *thing, const SceneObject *object);

/* Warns of a scene that has more than SCENE_HEAVY_TRIANGLES, at the object that has most of them.
 * After all are displaced. */
void scene_triangles_warn(SceneReader *r);

/* Its place in scene->materials, or -1: it is told what is wrong. scene_material.c */
int scene_material_read(SceneReader *r, Tree *tree);
/* Reads a file's material, by its number. */
int scene_material_read_of(SceneReader *r, const Tree *path, int number);
/* `materials:` of the document, before any is read. */
void scene_material_open(SceneReader *r, const Tree *document);
/* Resolves those of the document that were met or named, after all are read. */
void scene_material_resolve(SceneReader *r, const Tree *document);
/* The place in scene->meshes of a file, read when it is met first; or -1. scene_mesh.c */
int scene_mesh_read(SceneReader *r, const Tree *path);
/* How many meshes there are of the file's materials, side by side from *first on, by ascending
 * material; -1: told. */
int scene_mesh_read_parts(SceneReader *r, const Tree *path, int *first);
#endif
