/* Shadows of third-party meshes (tests/meshes), against Embree's rays: the error of their
 * boundaries, on four receivers. */
/* ctest: unsanitized seconds=29 */
#include "tests/test.h"
#include "tests/frame_reference/shadow_ends.h"
#include "tests/meshes/meshes.h"
#include <string.h>

/* Bounds are half again of what llvmpipe draws; exact shadows are off by pixels whose points a
 * rasterizer and a ray have on other triangles, and where the dragon has holes: what looks away
 * from the light there is taken to be dark. */
enum { PIXELS = 768 }; /* of 320 a dozen wrong ones would be the figure */
typedef struct {
    const char *mesh, *method;
    Keyword volume;
    double most[SHADOW_ENDS_RECEIVERS]; /* texels */
} Case;

/* Number of receivers whose error exceeds the bound. */
static int ends_of(const ShadowPair *pair, const Case *c)
{
    Shape shape = meshes_read(c->mesh);
    int far = 0;
    for (int i = 0; i < SHADOW_ENDS_RECEIVERS; i++) {
        const ShadowEnds ends = {&shape, c->method, (ShadowEndsReceiver)i, true, c->volume, PIXELS};
        const double distance = shadow_ends_distance(pair, &ends);
        print_message("%-12s %-10s on %-11s %.4f texels off\n", c->mesh, c->method,
                      shadow_ends_receivers[i], distance);
        far += !(distance <= c->most[i]);
    }
    shape_free(&shape);
    return far;
}

/* The argument: tests exact shadows of this mesh alone, as the largest takes a minute. */
static const char *alone;

static void ends_are_true(void **state)
{
    (void)state;
    static const Case cases[] = {
        {"bunny", "exact", 0, {.005, .006, .003, .002}},
        {"bunny", "silhouette", 0, {.017, .036, .026, .025}},
        {"bunny", "hybrid", KEYWORD_Volume_silhouette, {.04, .09, .048, .066}},
        {"dragon-small", "exact", 0, {.002, .03, .003, .003}},
        {"dragon-small", "silhouette", 0, {.02, .06, .043, .03}}};
    const Case one = {alone, "exact", 0, {.005, .03, .005, .005}};
    const Case *const of = alone ? &one : cases;
    const size_t count = alone ? 1 : sizeof cases / sizeof *cases;
    ShadowPair pair;
    for (size_t i = 0; i < count; i++) {
        /* ends the process where it is not there, before anything is open */
        Shape shape = meshes_read(of[i].mesh);
        shape_free(&shape);
    }
    shadow_pair_open(GL_KIND_osmesa, &pair);
    int far = 0;
    for (size_t i = 0; i < count; i++)
        far += ends_of(&pair, &of[i]);
    shadow_pair_close(&pair);
    assert_int_equal(far, 0);
}

int main(int count, char **arguments)
{
    alone = count > 1 ? arguments[1] : NULL;
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends_are_true)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
