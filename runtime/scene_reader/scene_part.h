/* Readers of a scene's parts, each from a node of the document into r->scene. They report errors
 * and then set r->fine to false. */
#ifndef MATC_SCENE_PART_H
#define MATC_SCENE_PART_H
#include "runtime/scene_reader/scene_node.h"

/* Reads all objects of a list, including groups. scene_objects.c */
void scene_objects_read(SceneReader *r, const Tree *list);
/* Reports errors in definitions that no object instances, which do not enter the scene. Call
 * after all objects are read. */
void scene_objects_check_unused(SceneReader *r);
/* Objects under `defs:`; opens them. scene_definition.c */
void scene_definition_open(SceneReader *r, const Tree *document);
/* Returns the definition of a name, and marks it as instanced. NULL after an error was reported. */
Tree *scene_definition_find(SceneReader *r, const Tree *name);
/* Returns the i-th definition if it is an object that no object instances; else NULL. */
Tree *scene_definition_unused(const SceneReader *r, uint32_t i);
/* Returns `defs:` without objects: only maps and materials. */
Tree *scene_definition_others(SceneReader *r, Tree *defs);
/* Reads the document's lights. scene_light.c */
void scene_lights_read(SceneReader *r, const Tree *list);
/* Adds the sun of a Sky light, after all materials are resolved. scene_sun.c */
void scene_sun_add(SceneReader *r);
/* Reads the camera; NULL: the default camera. scene_camera_read.c */
void scene_camera_read(SceneReader *r, Tree *tree);
/* Reads the motion, after the camera. scene_motion_read.c */
void scene_motion_read(SceneReader *r, Tree *tree);

/* Reads `indirect:`; NULL if missing. scene_indirect.c */
void scene_indirect_read(SceneReader *r, Tree *tree);

/* Counts the triangles of an object whose mesh no earlier object has. Returns false if there are
 * too many, which is reported. scene_triangles.c */
bool scene_triangles_add(SceneReader *r, const SceneNodeDesc *desc, const SceneObject *object);

/* Warns of a scene with more than SCENE_HEAVY_TRIANGLES, at the object that has the most. Call
 * after all objects are displaced. */
void scene_triangles_warn(SceneReader *r);

/* Returns the index of a material in scene->materials; -1 after an error was reported.
 * scene_material.c */
int scene_material_read(SceneReader *r, Tree *tree);
/* Returns the index of a mesh file's material, given its number in the file; -1 after an error. */
int scene_material_read_of(SceneReader *r, const Tree *path, int number);
/* Opens `materials:` of the document, before any material is read. */
void scene_material_open(SceneReader *r, const Tree *document);
/* Resolves the document's materials, named or inline, after all objects are read. */
void scene_material_resolve(SceneReader *r, const Tree *document);
/* Returns the index in scene->meshes of a file, which is read on first use; -1 after an error
 * was reported. scene_mesh.c */
int scene_mesh_read(SceneReader *r, const Tree *path);
/* Returns the number of meshes of a file split by material, consecutive from *first on, in
 * ascending order of material; -1 after an error was reported. */
int scene_mesh_read_parts(SceneReader *r, const Tree *path, int *first);
#endif
