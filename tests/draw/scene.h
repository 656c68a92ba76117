/* Documents drawn as an engine draws them: from a camera, by matc's own vertex programs; and the
 * expected values of the C reference. */
#ifndef MATC_VALUE_SCENE_H
#define MATC_VALUE_SCENE_H
#include "compiler/matc.h"
#include "compiler/oracle/oracle.h"
#include "runtime/gpu_material/spaces.h"

typedef Spaces Space;

/* All spaces are one: what is drawn is seen along -z, without perspective. */
Space space_flat(void);
/* A perspective camera; `height` is the tangent of half its angle, the picture is square. */
Space space_camera(const float eye[3], const float target[3], float height);
Mat4 space_clip_from_world(const Space *space);
/* Turns, stretches by three numbers and moves what is drawn; the plane becomes that of
 * SHAPE_plane. */
void space_place(Space *space);
/* As usual; a near plane as a water's reflection wants it, (0.2, 0.3, -1, -0.5) in the eye's space;
 * z from 1 at the near plane to 0 at infinity. */
typedef enum { SPACE_usual, SPACE_oblique, SPACE_reversed } SpaceDepth;
void space_change_depth(Space *space, SpaceDepth kind);
/* mat4 times (x, y, z, w), in double. */
void space_transform(const Mat4 *matrix, const double point[3], double w, double result[4]);

/* Where the line of sight of a place of the picture, x and y in [-1, 1], meets the plane. */
typedef struct {
    double ray[3];                       /* of unit length */
    double u, v, position[3], normal[3]; /* the normal is U x V, of unit length */
    double slope;                        /* ray times normal: below 0, the front is seen */
    bool before;                         /* the eye: the plane is seen */
} Hit;
Hit space_meet(const Space *space, double x, double y);
/* The plane there; of a mesh whose u and v are from 0 to 1, local positions are those of
 * SHAPE_plane. */
Surface space_surface(const Space *space, const Hit *hit, bool mesh);
/* Depth of a position in the world, as the depth buffer has it. */
double space_depth(const Space *space, const double position[3]);
void surface_set3(Surface *surface, Group group, const double components[3]);

typedef struct {
    /* as MatcOptions; NULL is the default, of aa none */
    const char *pass, *slot, *target, *aa, *normals;
} SceneOptions;

/* A material's program, with its own vertex program. */
typedef struct {
    MatcOptions options;
    MatcDocument *document;
    MatcProgram *program;
    Material material;
    char error[4096];
} Scene;

/* `text` is YAML, or the path of a document if it ends in .yaml. False: see error. Close it in any
 * case. */
bool scene_open(Scene *scene, Store *store, const char *text, const SceneOptions *options);
void scene_close(Scene *scene);
/* Makes it the current program and sets all that is not the material's. */
void scene_use(Scene *scene, const Space *space);
/* The slots at a point, by the C reference. */
bool scene_values(const Scene *scene, const Surface *surface, SlotValues *values);
#endif
