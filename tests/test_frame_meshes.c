/* Shadows of meshes that others made (tests/meshes), against rays of Embree: how far their ends are off, on four receivers. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/shadow_ends.h"
#include "tests/meshes/meshes.h"
#include <string.h>

/* Bounds are half again of what llvmpipe draws; exact shadows are off by pixels whose points a rasteriser and
 * a ray have on other triangles, and where the dragon has holes: what looks away from the light there is taken to be dark. */
typedef struct {
    const char *mesh, *method;
    double most[SHADOW_ENDS_RECEIVERS]; /* texels */
} Case;

static void ends_of(const ShadowPair *pair, const Case *c)
{
    Shape shape = meshes_read(c->mesh);
    for (int i = 0; i < SHADOW_ENDS_RECEIVERS; i++) {
        const ShadowEnds ends = {&shape, c->method, (ShadowEndsReceiver)i, true};
        const double distance = shadow_ends_distance(pair, &ends);
        print_message("%-12s %-10s on %-11s %.4f texels off\n", c->mesh, c->method, shadow_ends_receivers[i], distance);
        assert_true(distance <= c->most[i]);
    }
    shape_free(&shape);
}

static void ends_are_true(void **state)
{
    (void)state;
    static const Case cases[] = {{"bunny", "exact", {.005, .006, .003, .002}},
                                 {"bunny", "silhouette", {.01, .055, .02, .045}},
                                 {"dragon-small", "exact", {.002, .03, .003, .003}},
                                 {"dragon-small", "silhouette", {.012, .12, .045, .035}}};
    ShadowPair pair;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Shape shape = meshes_read(cases[i].mesh); /* ends the process where it is not there, before anything is open */
        shape_free(&shape);
    }
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        ends_of(&pair, &cases[i]);
    shadow_pair_close(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends_are_true)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
