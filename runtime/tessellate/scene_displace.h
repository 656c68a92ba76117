/* The meshes of displaced objects: made when a scene is read, and again after changes. */
#ifndef MATC_SCENE_DISPLACE_H
#define MATC_SCENE_DISPLACE_H
#include "runtime/scene/scene.h"

struct Session;

/* Objects whose materials displace them become meshes that are displaced. False: a diagnostic
 * says why. */
bool scene_displace(Scene *scene, struct Session *session, const MatcOptions *options);
/* Frees what it has beside the session's memory. */
void scene_displace_free(Scene *scene);

/* Effect of a change on meshes: none; they depend on it, and are unchanged; objects have new ones,
 * so that the scene has to be drawn as a new one; or these could not be made, and objects keep the
 * old ones. */
typedef enum {
    SCENE_DISPLACED_none,
    SCENE_DISPLACED_same,
    SCENE_DISPLACED_anew,
    SCENE_DISPLACED_failed
} SceneDisplaced;
/* So many objects from `first` on have other matrices. */
SceneDisplaced scene_displace_moved(Scene *scene, int first, int count);
/* A param of a material has another value. */
SceneDisplaced scene_displace_param(Scene *scene, int material, const char *name,
                                    const double *lanes, int count);
/* All are divided by another method of the list Displacing. */
SceneDisplaced scene_displace_by(Scene *scene, Word method);
/* Detail that goes by the picture (scene_detail.h) goes by one of another size. */
SceneDisplaced scene_displace_resized(Scene *scene, int width, int height);
/* Replaces patches by meshes that are divided evenly, for a renderer that cannot displace patches
 * or needs their triangles; later changes do so, too. False: see scene_displace_fault. */
bool scene_displace_patches(const Scene *scene);
/* A material's params have the values that were set, in its document, until this is called once
 * more. */
void scene_displace_params(const Scene *scene, int material);
/* Why none could be made, and of which material. */
const char *scene_displace_fault(const Scene *scene, const SceneMaterial **material);
#endif
