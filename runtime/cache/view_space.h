/* From a scene's camera and lights to what the passes are told: matrices, the rays of pixels,
 * lights in the eye's space. */
#ifndef MATC_CACHE_VIEW_SPACE_H
#define MATC_CACHE_VIEW_SPACE_H
#include "gen/light_layout.h"
#include "runtime/draw/spaces.h"
#include "runtime/scene/scene.h"

typedef struct {
    Spaces spaces; /* world_from_local is the identity */
    /* Ray of pixel p: (2 p + 1 - zw) xy are x and y of its direction where z = -1; orthographic: of
     * its point. zw: the picture's size, less twice the pixel from which p counts. */
    float ray[4];
    /* x: near, or the depth of an orthographic view; y: 1 where it is orthographic */
    float depth[4];
    double eye_from_world[16];
} ViewSpace;

/* `zero_to_one`: the driver has glClipControl. */
void view_space_make(const SceneCamera *camera, const int size[2], bool zero_to_one,
                     ViewSpace *made);
/* view_space_make()'s matrices for the sky's program, which derives the view direction from clip
 * space. An orthographic camera gets increasing instead of reversed depth: w is constant there, so
 * the program could not see that depth is reversed. */
Spaces view_space_of_sky(const ViewSpace *space);
/* Pixels count from that one of the picture from now on. Exact: the rays of a tile are those of the
 * picture. */
void view_space_place(ViewSpace *space, const int size[2], const int at[2]);

/* Lights come section by section, so that each loop of a shader has one formula. */
enum {
    VIEW_SPACE_PLAIN,  /* points without a cone and shadows: their first two texels say all */
    VIEW_SPACE_POINTS, /* other points, and parallel light */
    VIEW_SPACE_KINDS,  /* from here on kinds with a GLSL, by their numbers in light_kind_table */
    VIEW_SPACE_SECTIONS = VIEW_SPACE_KINDS + LIGHT_KINDS_MAX
};
/* The section of a light; VIEW_SPACE_SECTIONS: light from all around, which has no texels.
 * `shadows`: lights cast them if they are to. */
int view_space_section(const SceneLight *light, bool shadows);

/* Parallel rays meet a plane in points that are linear in the pixel; so they are seen as well along
 * rays from one point, each of which ends where its parallel does. Of a plane that is seen edge-on
 * no ray meets it. */
void view_space_parallels(const SceneCamera *camera, const int size[2], const SceneMatrix *plane,
                          Spaces *spaces);

/* Texels of all lights that have a place (light.layout.def), and the number of lights in each
 * section. */
void view_space_lights(const ViewSpace *space, const Scene *scene, bool shadows, float (*texels)[4],
                       int counts[VIEW_SPACE_SECTIONS]);
/* How many texels the sections before that one have. */
int view_space_texels(const int counts[VIEW_SPACE_SECTIONS], int section);
/* The sums over the lights of a kind from around: up, in the eye's space, then the light from above
 * and that from below. False: there are none. */
enum { VIEW_SPACE_AROUND = 3 };
bool view_space_around(const ViewSpace *space, const Scene *scene, const LightKind *kind,
                       float numbers[VIEW_SPACE_AROUND][4]);
#endif
