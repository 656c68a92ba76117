/* Conversions from a scene's camera and lights to the inputs of passes: matrices, pixel rays,
 * lights in eye space. */
#ifndef MATC_GPU_SCENE_VIEW_SPACE_H
#define MATC_GPU_SCENE_VIEW_SPACE_H
#include "gen/light_layout.h"
#include "runtime/gpu_material/spaces.h"
#include "runtime/scene/scene.h"

typedef struct {
    Spaces spaces; /* spaces of the view; world_from_local is the identity */
    /* Ray of pixel p: (2 p + 1 - zw) xy are x and y of its direction at z = -1; in an
     * orthographic view, of its origin. zw: the picture's size, minus twice the first pixel of
     * the tile. */
    float ray[4];
    /* x: near distance, or depth of an orthographic view; y: 1 if orthographic */
    float depth[4];
    double eye_from_world[16];
} ViewSpace;

/* Computes the camera's matrices and rays. `zero_to_one`: the driver supports glClipControl. */
void view_space_make(const SceneCamera *camera, const int size[2], bool zero_to_one,
                     ViewSpace *made);
/* view_space_make()'s matrices for the sky's program, which derives the view direction from clip
 * space. An orthographic camera gets increasing instead of reversed depth: w is constant there,
 * so the program could not detect that depth is reversed. */
Spaces view_space_of_sky(const ViewSpace *space);
/* Sets the first pixel of the tile. Exact: the rays of a tile equal those of the picture. */
void view_space_place(ViewSpace *space, const int size[2], const int at[2]);

/* Lights are sorted into sections, so that each loop of a shader evaluates one formula. */
enum {
    VIEW_SPACE_PLAIN,  /* points without a cone and without shadows: two texels each */
    VIEW_SPACE_POINTS, /* other points, and directional lights */
    VIEW_SPACE_KINDS,  /* first light kind with GLSL of its own, by index in light_kind_table */
    VIEW_SPACE_SECTIONS = VIEW_SPACE_KINDS + LIGHT_KINDS_MAX
};
/* Returns the section of a light; VIEW_SPACE_SECTIONS for ambient lights, which have no texels.
 * `shadows`: shadows are enabled. */
int view_space_section(const SceneLight *light, bool shadows);

/* Replaces the parallel rays of an orthographic camera by rays from one point that hit the plane
 * in the same points, which is possible since these are linear in the pixel. If the plane is
 * edge-on no ray hits it. */
void view_space_parallels(const SceneCamera *camera, const int size[2], const SceneMatrix *plane,
                          Spaces *spaces);

/* Writes the texels of all lights with a position or direction (light.layout.def), and counts
 * the lights in each section. */
void view_space_lights(const ViewSpace *space, const Scene *scene, bool shadows, float (*texels)[4],
                       int counts[VIEW_SPACE_SECTIONS]);
/* Returns the number of texels in all earlier sections. */
int view_space_texels(const int counts[VIEW_SPACE_SECTIONS], int section);
/* Sums the ambient lights of a kind: the up direction in eye space, then the light from above
 * and from below. Returns false if the scene has none. */
enum { VIEW_SPACE_AROUND = 3 };
bool view_space_around(const ViewSpace *space, const Scene *scene, const LightKind *kind,
                       float numbers[VIEW_SPACE_AROUND][4]);
#endif
