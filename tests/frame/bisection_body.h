/* Meshes that compute stages bisect, for tests: one context and its programs for a whole test,
 * and triangles as sorted numbers. */
#ifndef TESTS_BISECTION_BODY_H
#define TESTS_BISECTION_BODY_H
#include "runtime/displace/bisection/displaced_bisection.h"
#include "tests/frame/frame_compare.h"

enum { BISECTION_BODY_EDGE = 64 /* pixels of a picture's side */, BISECTION_BODIES = 5 };
extern const char bisection_body_materials[];
extern const char
    /* a sheet, a ball, a box, a ball with jumps, a cone that is scaled */
    *const bisection_bodies[BISECTION_BODIES];

typedef struct {
    GlContext *gl;
    MatcOptions options;
    MatcDocument *document;
    Scene *scene;
    Store *store;
    Mesh mesh;
    Displaced displaced;
    double low[3], high[3]; /* around all that shadows may fall on; none: they fall anywhere */
} BisectionBody;

/* One context for all: its programs take longer to compile than all else. */
typedef struct {
    GlContext *gl;
    Store *store;
    BisectionBody kept[2]; /* so that programs of both materials stay */
} BisectionBodies;

/* Setup of a group of tests; state is BisectionBodies. */
int bisection_bodies_open(void **state);
int bisection_bodies_close(void **state);
Scene *bisection_body_scene(const char *how, const char *object, const MatcOptions *options,
                            MatcDocument **document);
/* A failure ends the test. */
BisectionBody bisection_body_begin(const BisectionBodies *with, const char *how,
                                   const char *object);
void bisection_body_end(BisectionBody *b);
/* It has seen nothing before. */
void bisection_body_fresh(BisectionBody *b);
/* One of so many views from around, towards the camera's target. */
void bisection_body_look(SceneCamera *camera, int view, int views, double distance);
/* Leaves for the camera as it is, sorted; from malloc. */
uint64_t *bisection_body_leaves(BisectionBody *b, int *count);
void bisection_body_sort(uint64_t *leaves, int count);
/* How many of either are not in the other. */
int bisection_body_others(const uint64_t *a, int a_count, const uint64_t *b, int b_count);
#endif
