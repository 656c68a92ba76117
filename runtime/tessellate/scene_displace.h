/* The meshes of displaced objects: made when a scene is read, and updated after changes. */
#ifndef MATC_SCENE_DISPLACE_H
#define MATC_SCENE_DISPLACE_H
#include "runtime/scene/scene.h"

struct Session;

/* Replaces objects whose materials displace them by displaced meshes. False: failed, with a
 * diagnostic. */
bool scene_displace(Scene *scene, struct Session *session, const MatcOptions *options);
/* Frees memory outside of the session's arena. */
void scene_displace_free(Scene *scene);

/* Effect of a change on meshes: `none`: no mesh depends on it; `same`: meshes are unchanged;
 * `rebuilt`: objects have new meshes, so the renderer must be rebuilt; `failed`: new meshes could
 * not be made, and objects keep the old ones. */
typedef enum {
    SCENE_DISPLACED_none,
    SCENE_DISPLACED_same,
    SCENE_DISPLACED_rebuilt,
    SCENE_DISPLACED_failed
} SceneDisplaced;
/* Updates meshes after `count` objects from `first` on have got other matrices. */
SceneDisplaced scene_displace_moved(Scene *scene, int first, int count);
/* Updates meshes after a param of a material has got another value. */
SceneDisplaced scene_displace_param(Scene *scene, int material, const char *name,
                                    const double *components, int count);
/* Tessellates all meshes by another method of the list Displacing. */
SceneDisplaced scene_displace_by(Scene *scene, Keyword method);
/* Updates view-dependent detail (scene_detail.h) for another picture size. */
SceneDisplaced scene_displace_resized(Scene *scene, int width, int height);
/* Replaces patches by evenly divided meshes, for a renderer that cannot displace patches or
 * needs their triangles; later changes do so, too. False: failed, see scene_displace_fault(). */
bool scene_displace_patches(const Scene *scene);
/* Exchanges a material's set param values with its document's defaults, until the next call. */
void scene_displace_params(const Scene *scene, int material);
/* Returns the reason of the last failure, and its material. */
const char *scene_displace_fault(const Scene *scene, const SceneMaterial **material);
#endif
