/* How a method makes triangles of patches, and what methods share. A method is a file with a row of
 * this type, which stands in the table of displaced.c. */
#ifndef MATC_DISPLACE_DISPLACED_METHOD_H
#define MATC_DISPLACE_DISPLACED_METHOD_H
#include "runtime/displace/displaced.h"

enum { DISPLACED_BINDINGS = 9 /* of buffers, up to those of displace_point.glsl */ };

/* Inputs of a method's programs. */
typedef struct {
    Store *store;
    const Scene *scene;
    const ScenePatches *patches;
    MatcProgram *program; /* the material's */
    const char *displace; /* its matc_displaced() */
} DisplacedMaking;

typedef struct DisplacedMethod {
    Word word;    /* of the list Displacing */
    bool by_view; /* triangles go by the camera, whatever the key `pixels` says */
    /* The driver can, beyond what displaced_there asks for all. NULL: always. */
    bool (*there)(const GlContext *gl);
    /* Makes `material`, and what else the method keeps, in `own`. False: see the context's error;
     * `forget` is called where there is a material. */
    bool (*make)(const DisplacedMaking *making, Displaced *made);
    /* Writes the mesh, where it does not stand so for this view, and says in `anew` whether it had
     * to. False: see the context's error. */
    bool (*write)(Displaced *displaced, const DisplacedView *view, Mesh *mesh);
    /* Deletes `own`. NULL: there is none. */
    void (*forget)(Displaced *displaced);
} DisplacedMethod;

extern const DisplacedMethod displaced_grid, displaced_tessellation, displaced_geometry,
    displaced_points, displaced_feedback, displaced_bisection, displaced_by_tracing,
    displaced_by_parallax;
extern const char displaced_version[]; /* the first line of each stage */

GlContext *displaced_context(const Displaced *displaced);
/* Makes a program of stages that set the captured variables of displace_point.glsl: what stands
 * behind them, and their uniforms; or of one that sets them for itself: a compute stage, or with a
 * fragment stage of its own. */
bool displaced_program(const DisplacedMaking *making, ProgramText *text, Material *made);
/* Rows and patches become buffers, beside an empty one, an array and a framebuffer. */
bool displaced_buffers(GlContext *gl, Displaced *made);
bool displaced_fill(GlContext *gl, GLuint buffer, const void *bytes, size_t size);
/* Memory for a buffer of the mesh, 0 its rows, 1 its indices: what was there is lost where it did
 * not suffice. */
void displaced_reserve(Displaced *displaced, const Mesh *mesh, int buffer, size_t bytes);
/* The mesh has these indices. NULL: memory ran out. */
bool displaced_indices(Displaced *displaced, Mesh *mesh, const uint32_t *indices, size_t count);
/* Its rows are triangles, one behind the other. */
bool displaced_unshared(Displaced *displaced, Mesh *mesh, int triangles);
/* Around draws whose points are captured, and nothing else. */
void displaced_begin(const Displaced *displaced);
bool displaced_end(const Displaced *displaced);
/* Uses the material, and captures triangles of so many points as rows of the mesh, from row `first`
 * on, until glEndTransformFeedback. */
void displaced_capture(Displaced *displaced, const Mesh *mesh, size_t first, size_t points);
/* Geometry programs read buffers, as displace_point.glsl has it, and write what every driver does
 * at least. */
bool displaced_geometry_there(const GlContext *gl);
/* `parts` for the view; if they are not as they were, `anew`, and the third buffer has what
 * displace_point.glsl draws: patches by the parts of their insides, `first` of each number of
 * parts, and behind the last. */
bool displaced_parts(Displaced *displaced, const DisplacedView *view,
                     int first[SCENE_PATCH_PARTS + 2]);
/* Functions of methods that draw patches: triangles of a patch of n parts; a draw of patches
 * first[0] .. first[1], captured from a place of the mesh's rows on, which returns the place
 * behind. */
typedef struct {
    size_t (*triangles)(const Displaced *displaced, int n);
    size_t (*draw)(Displaced *displaced, const int first[2], int n, const Mesh *mesh, size_t at);
} DisplacedByParts;
/* The mesh's rows become all their triangles. */
bool displaced_by_parts(Displaced *displaced, const int first[SCENE_PATCH_PARTS + 2],
                        const DisplacedByParts *by, Mesh *mesh);
#endif
