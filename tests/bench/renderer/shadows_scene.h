/* Scenes of matbench shadows: casters of one mesh in sunlight, with different receivers, and the
 * methods of a light. */
#ifndef SHADOWS_SCENE_H
#define SHADOWS_SCENE_H
#include "runtime/renderer/renderer.h"

/* Receivers at which shadow boundaries are measured. The camera is between the casters and the
 * receiver and looks along the light, except for SHADOWS_itself. */
typedef enum {
    SHADOWS_plane,       /* an infinite plane, which no shadow map contains */
    SHADOWS_itself,      /* the caster */
    SHADOWS_second,      /* a smooth ball behind it, in the same map */
    SHADOWS_overlapping, /* the plane, behind two casters that overlap as seen from the light */
    SHADOWS_RECEIVERS,
    SHADOWS_frame = SHADOWS_RECEIVERS, /* a caster over the plane, and its shadow: for timing */
    SHADOWS_SCENES
} ShadowsScene;
extern const char *const shadows_receivers[SHADOWS_RECEIVERS];

/* A shadow method of a light: two keywords, which identify a table's rows. */
typedef struct {
    const char *name[2];
    Keyword shadows;
    int filter;
    Keyword volume;
    bool stretched;
    Keyword path;
} ShadowsMethod;
enum { SHADOWS_METHODS_MAX = 24 };
/* Methods of the list Shadows, and the volumes of hybrid ones; a keyword unknown to this file is
 * listed by its own name. The first method casts no shadows; *pcf is the baseline of times.
 * Returns their number. */
int shadows_methods(ShadowsMethod methods[SHADOWS_METHODS_MAX], int *pcf);
/* Sets the shadow method of the scene's light. */
void shadows_use(Scene *scene, const ShadowsMethod *method, int map_size);

/* A bumpy ball of about `triangles` triangles, at most 1 from the origin. Returns false if
 * memory ran out. */
bool shadows_ball(int triangles, Shape *made);

typedef struct {
    MatcDocument *document;
    Scene *scene;
    SceneMesh mesh; /* borrowed */
} ShadowsPlace;

/* Returns false after a message on standard error. The mesh, which lies within 1 of the origin,
 * must outlive the place. */
bool shadows_open(ShadowsScene which, const Shape *mesh, const MatcOptions *compile,
                  ShadowsPlace *made);
void shadows_close(ShadowsPlace *place);
#endif
