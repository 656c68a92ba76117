/* Scenes of matbench shadows: casters of one mesh in sunlight, with different receivers, and the
 * methods of a light. */
#ifndef SHADOWS_SCENE_H
#define SHADOWS_SCENE_H
#include "runtime/renderer/renderer.h"

/* Where ends of shadows are looked at. All is seen from between the casters and the receiver, along
 * the light but for SHADOWS_itself. */
typedef enum {
    SHADOWS_plane,       /* an infinite plane, which is in no map */
    SHADOWS_itself,      /* the caster */
    SHADOWS_second,      /* a smooth ball behind it, of the same map */
    SHADOWS_overlapping, /* the plane, behind two casters that overlap as the light sees them */
    SHADOWS_RECEIVERS,
    SHADOWS_frame = SHADOWS_RECEIVERS, /* a caster over the plane, and its shadow: what is timed */
    SHADOWS_SCENES
} ShadowsScene;
extern const char *const shadows_receivers[SHADOWS_RECEIVERS];

/* How a light casts shadows: two words, so that a table's lines can be told apart. */
typedef struct {
    const char *name[2];
    Keyword shadows;
    int filter;
    Keyword volume;
    bool stretched;
    Keyword path;
} ShadowsMethod;
enum { SHADOWS_METHODS_MAX = 24 };
/* Those of the list Shadows and the volumes of hybrid ones; a word that this file does not know has
 * its own name. The first casts none; *pcf is what times are compared with. How many. */
int shadows_methods(ShadowsMethod methods[SHADOWS_METHODS_MAX], int *pcf);
/* The scene's light casts its shadows so. */
void shadows_use(Scene *scene, const ShadowsMethod *method, int map_size);

/* A ball with bumps of about so many triangles, at most 1 from the origin. False: memory ran
 * out. */
bool shadows_ball(int triangles, Shape *made);

typedef struct {
    MatcDocument *document;
    Scene *scene;
    SceneMesh mesh; /* borrowed */
} ShadowsPlace;

/* False: said on standard error. The mesh, which lies within 1 from the origin, is there until the
 * end. */
bool shadows_open(ShadowsScene which, const Shape *mesh, const MatcOptions *compile,
                  ShadowsPlace *made);
void shadows_close(ShadowsPlace *place);
#endif
