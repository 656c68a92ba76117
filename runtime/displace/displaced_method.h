/* Interface of a displacement method, and functions that methods share. A method is a file that
 * defines a row of this type for the table in displaced.c. */
#ifndef MATC_DISPLACE_DISPLACED_METHOD_H
#define MATC_DISPLACE_DISPLACED_METHOD_H
#include "runtime/displace/displaced.h"

enum { DISPLACED_BINDINGS = 9 /* number of buffer bindings, up to those of displace_point.glsl */ };

/* Inputs for making a method's programs. */
typedef struct {
    Store *store;
    const Scene *scene;
    const ScenePatches *patches;
    MatcProgram *program; /* the material's program */
    const char *displace; /* text of the function matc_displaced() */
} DisplacedMaking;

typedef struct DisplacedMethod {
    Keyword word; /* keyword of the list Displacing */
    bool by_view; /* triangles depend on the camera, whatever the key `pixels` says */
    /* Returns whether the driver supports the method, in addition to displaced_supported()'s
     * requirements. NULL: always true. */
    bool (*there)(const GlContext *gl);
    /* Makes `material` and the method's state `own`. False: failed, see the context's error;
     * `forget` is called if there is a material. */
    bool (*make)(const DisplacedMaking *making, Displaced *made);
    /* Writes the mesh unless it is up to date for the view, and sets `anew` if it was written.
     * False: failed, see the context's error. */
    bool (*write)(Displaced *displaced, const DisplacedView *view, Mesh *mesh);
    /* Deletes `own`. NULL: no state. */
    void (*forget)(Displaced *displaced);
} DisplacedMethod;

extern const DisplacedMethod displaced_grid, displaced_tessellation, displaced_geometry,
    displaced_points, displaced_feedback, displaced_bisection, displaced_by_tracing,
    displaced_by_parallax;
extern const char displaced_version[]; /* the #version line that begins each stage */

GlContext *displaced_context(const Displaced *displaced);
/* Makes a program. If `text` has neither a compute nor a fragment stage, its stages set the
 * variables captured by displace_point.glsl. Sets the uniforms of the mesh. */
bool displaced_program(const DisplacedMaking *making, ProgramText *text, Material *made);
/* Makes buffers of rows and patches, an empty buffer of drawn patches, a vertex array and a
 * framebuffer. */
bool displaced_buffers(GlContext *gl, Displaced *made);
bool displaced_fill(GlContext *gl, GLuint buffer, const void *bytes, size_t size);
/* Reserves memory for a buffer of the mesh, 0 for rows, 1 for indices; enlarging discards the
 * contents. */
void displaced_reserve(Displaced *displaced, const Mesh *mesh, int buffer, size_t bytes);
/* Sets the mesh's indices. NULL: out of memory. */
bool displaced_indices(Displaced *displaced, Mesh *mesh, const uint32_t *indices, size_t count);
/* Makes the mesh's rows consecutive triangles without shared vertices. */
bool displaced_unshared(Displaced *displaced, Mesh *mesh, int triangles);
/* Begin and end a sequence of draws whose points are captured, and not rasterized. */
void displaced_begin(const Displaced *displaced);
bool displaced_end(const Displaced *displaced);
/* Uses the material, and captures triangles of `points` points as rows of the mesh, from row
 * `first` on, until glEndTransformFeedback. */
void displaced_capture(Displaced *displaced, const Mesh *mesh, size_t first, size_t points);
/* Returns whether the driver's geometry programs can read the buffers of displace_point.glsl;
 * outputs stay within the limits that every driver has. */
bool displaced_geometry_supported(const GlContext *gl);
/* Computes `parts` for the view. If they have changed, sets `anew` and fills the buffer of drawn
 * patches, ordered by the parts of their interiors: first[n] is the first patch of n parts, and
 * the last element is the end. */
bool displaced_parts(Displaced *displaced, const DisplacedView *view,
                     int first[SCENE_PATCH_PARTS + 2]);
/* Functions of methods that draw patches by number of parts: triangles of a patch of n parts;
 * and a draw of patches first[0] .. first[1], captured from row `at` of the mesh on, which
 * returns the next row. */
typedef struct {
    size_t (*triangles)(const Displaced *displaced, int n);
    size_t (*draw)(Displaced *displaced, const int first[2], int n, const Mesh *mesh, size_t at);
} DisplacedByParts;
/* Writes all triangles of the drawn patches to the mesh's rows. */
bool displaced_by_parts(Displaced *displaced, const int first[SCENE_PATCH_PARTS + 2],
                        const DisplacedByParts *by, Mesh *mesh);
#endif
