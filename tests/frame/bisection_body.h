/* Meshes that compute stages bisect, for tests: one context and its programs for a whole test,
 * and triangles as sorted numbers. */
#ifndef TESTS_BISECTION_BODY_H
#define TESTS_BISECTION_BODY_H
#include "runtime/displace/bisection/displaced_bisection.h"
#include "tests/frame/frame_compare.h"

enum {
    BISECTION_BODY_EDGE = 64 /* width and height of a picture in pixels */,
    BISECTION_BODIES = 5
};
extern const char bisection_body_materials[];
extern const char
    /* a sheet, a ball, a box, a ball with jumps, a scaled cone */
    *const bisection_bodies[BISECTION_BODIES];

typedef struct {
    GlContext *gl;
    MatcOptions options;
    MatcDocument *document;
    Scene *scene;
    Store *store;
    Mesh mesh;
    Displaced displaced;
    double low[3], high[3]; /* box around all shadow receivers; NULL: shadows fall anywhere */
} BisectionBody;

/* One context for all meshes, because compiling its programs takes most of the time. */
typedef struct {
    GlContext *gl;
    Store *store;
    BisectionBody kept[2]; /* keeps the programs of both materials alive */
} BisectionBodies;

/* Setup of a group of tests; state is BisectionBodies. */
int bisection_bodies_open(void **state);
int bisection_bodies_close(void **state);
Scene *bisection_body_scene(const char *how, const char *object, const MatcOptions *options,
                            MatcDocument **document);
/* Opens a mesh; a failure ends the test. */
BisectionBody bisection_body_begin(const BisectionBodies *with, const char *how,
                                   const char *object);
void bisection_body_end(BisectionBody *b);
/* Discards the history of views. */
void bisection_body_fresh(BisectionBody *b);
/* Sets view number `view` of `views` from around, toward the camera's target. */
void bisection_body_look(SceneCamera *camera, int view, int views, double distance);
/* Leaves for the current camera, sorted; from malloc. */
uint64_t *bisection_body_leaves(BisectionBody *b, int *count);
void bisection_body_sort(uint64_t *leaves, int count);
/* Number of elements of either set that are missing in the other. */
int bisection_body_others(const uint64_t *a, int a_count, const uint64_t *b, int b_count);
#endif
