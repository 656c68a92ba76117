/* Documents drawn as an engine draws them: from a camera, by matc's own vertex programs; and the
 * expected values of the C reference. */
#ifndef MATC_VALUE_SCENE_H
#define MATC_VALUE_SCENE_H
#include "compiler/matc.h"
#include "compiler/oracle/oracle.h"
#include "runtime/gpu_material/spaces.h"

typedef Spaces Space;

/* All spaces are equal: an orthographic view along -z. */
Space space_flat(void);
/* A perspective camera; `height` is the tangent of half its angle, the picture is square. */
Space space_camera(const float eye[3], const float target[3], float height);
Mat4 space_clip_from_world(const Space *space);
/* Rotates, scales non-uniformly and translates the object; the plane becomes that of
 * SHAPE_plane. */
void space_place(Space *space);
/* The usual projection; an oblique near plane as for water reflections, (0.2, 0.3, -1, -0.5) in
 * eye space; reversed z, from 1 at the near plane to 0 at infinity. */
typedef enum { SPACE_usual, SPACE_oblique, SPACE_reversed } SpaceDepth;
void space_change_depth(Space *space, SpaceDepth kind);
/* mat4 times (x, y, z, w), in double. */
void space_transform(const Mat4 *matrix, const double point[3], double w, double result[4]);

/* Intersection of the plane with the view ray of a picture position, x and y in [-1, 1]. */
typedef struct {
    double ray[3];                       /* unit length */
    double u, v, position[3], normal[3]; /* the normal is U x V, normalized */
    double slope;                        /* ray times normal; below 0: the front is visible */
    bool before;                         /* the plane is in front of the eye */
} Hit;
Hit space_meet(const Space *space, double x, double y);
/* The plane's surface point; for a mesh, with u and v in [0, 1], local positions are those of
 * SHAPE_plane. */
Surface space_surface(const Space *space, const Hit *hit, bool mesh);
/* Depth buffer value of a world position. */
double space_depth(const Space *space, const double position[3]);
void surface_set3(Surface *surface, Group group, const double components[3]);

typedef struct {
    /* as in MatcOptions; NULL: the default, for aa "none" */
    const char *pass, *slot, *target, *aa, *normals;
} SceneOptions;

/* A material's program, with matc's vertex program. */
typedef struct {
    MatcOptions options;
    MatcDocument *document;
    MatcProgram *program;
    Material material;
    char error[4096];
} Scene;

/* `text` is YAML, or a document's path ending in .yaml. Returns false with a message in `error`.
 * Close it in any case. */
bool scene_open(Scene *scene, Store *store, const char *text, const SceneOptions *options);
void scene_close(Scene *scene);
/* Makes the program current and sets all inputs that do not belong to the material. */
void scene_use(Scene *scene, const Space *space);
/* The slot values at a point, by the C reference. */
bool scene_values(const Scene *scene, const Surface *surface, SlotValues *values);
#endif
