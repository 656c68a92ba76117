/* Silhouette shadows against Embree's rays: mean distances of their boundaries from the true
 * ones, on four receivers; wrong pixels away from boundaries, for each kind of light, from half
 * a degree over the ground to straight above. */
/* ctest: unsanitized seconds=17 */
#include "tests/test.h"
#include "tests/frame/shadow_band.h"
#include "tests/frame_reference/shadow_ends.h"
#include "tests/frame/shadow_knot.h"
#include "tests/frame/shadow_scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- how far ends are off */

static void ends_are_true(void **state)
{
    (void)state;
    ShadowPair pair;
    Shape shape = shadow_knot();
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (int i = 0; i < SHADOW_ENDS_RECEIVERS; i++) {
        const ShadowEndsReceiver receiver = (ShadowEndsReceiver)i;
        const double distance =
            shadow_ends_distance(&pair, &(ShadowEnds){&shape, "silhouette", receiver, false, 0, 0});
        const double all =
            shadow_ends_distance(&pair, &(ShadowEnds){&shape, "silhouette", receiver, true, 0, 0});
        print_message("ends on %s: %.4f texels off; %.4f with triangles that look away\n",
                      shadow_ends_receivers[i], distance, all);
        assert_true(distance <= .01 && all <= .02);
    }
    shadow_pair_close(&pair);
    shape_free(&shape);
}

/* -- pixels away from ends */

#define HEAD "image: { width: 120, height: 90 }\nshadowMaps: { size: 256 }\n"
/* Intersecting objects, coincident copies, a box without width, degenerate triangles. */
#define NASTY                                                                                      \
    "- { object: Sphere, radius: .7, material: m, transform: { translation: [-.9, -.4, .5] } }\n"  \
    "- { object: Sphere, radius: .7, material: m, transform: { translation: [-.3, -.2, .6] } }\n"  \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] " \
    "} }\n"                                                                                        \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] " \
    "} }\n"                                                                                        \
    "- { object: Parallelogram, u: [3, 0, 0], v: [0, .0001, .3], material: m, transform: { "       \
    "translation: [-1, -1.5, "                                                                     \
    ".2] } }\n"                                                                                    \
    "- { object: Box, size: [.000001, 1, 1], material: m, transform: { translation: [0, .9, .5] "  \
    "} }\n"                                                                                        \
    "- { object: Cylinder, radius: .3, height: .000001, material: m, transform: { translation: "   \
    "[.6, -1.9, .5] } }\n"
/* Half below the ground, an infinite plane that hides triangles. */
#define SUNK                                                                                       \
    "- { object: Sphere, radius: .6, material: m, transform: { translation: [-.4, -2, .1] } }\n"
typedef struct {
    int lit, dark;   /* compared, outside of bands */
    int band;        /* within */
    int acne, leaks; /* wrong ones */
} Count;

/* Width of all objects of a scene; radius in texels within which all rays have to agree. */
static const double REACH = 11.5, BAND = 1;

static int expected(const Tracer *tracer, const Hit *hit)
{
    return shadow_band_expected(
        tracer, hit,
        BAND * shadow_texel(tracer->scene, &tracer->scene->lights[0], hit->world, REACH));
}

static void add_pixel(const Tracer *tracer, int pixel, double share, Count *count)
{
    const int wide = tracer->scene->width;
    const Ray ray = reference_ray(tracer->scene, pixel % wide + .5, pixel / wide + .5);
    const Hit hit = reference_hit(tracer, &ray, 0);
    if (hit.object < 0 || !shadow_sides_agree(&tracer->scene->lights[0], &hit) ||
        reference_is_edge(tracer, pixel % wide, pixel / wide, &hit, 1))
        return;
    const int wanted = expected(tracer, &hit);
    count->band += wanted < 0;
    count->lit += wanted == 1;
    count->dark += wanted == 0;
    count->acne += wanted == 1 && share < .5;
    count->leaks += wanted == 0 && share > .5;
}

/* The argument `all` selects all angles with all lamps. */
static bool all_of_them;

static Count by_lamp(const ShadowPair *pair, const ShadowScene *from)
{
    MatcDocument *document;
    Count count = {0};
    Scene *scene = shadow_scene(from, &pair->options, &document);
    float *shares = shadow_pair_shares(pair, scene);
    Tracer tracer = reference_open(scene);
    for (int i = 0; i < scene->width * scene->height; i++)
        if (shares[i] >= 0)
            add_pixel(&tracer, i, (double)shares[i], &count);
    reference_close(&tracer);
    free(shares);
    frame_forget(scene, document);
    return count;
}

/* At most `most` leaks are allowed. */
static void by_every_lamp(const ShadowPair *pair, const char *name, const char *objects[2],
                          int most)
{
    Count all = {0};
    for (int i = 0; i < SHADOW_ANGLES * SHADOW_LAMPS; i++) {
        if (i % SHADOW_ANGLES % SHADOW_LAMPS != i / SHADOW_ANGLES && !all_of_them)
            continue; /* each angle with a lamp */
        const ShadowLamp *lamp = &shadow_lamps[i / SHADOW_ANGLES];
        const double *angle = shadow_angles[i % SHADOW_ANGLES];
        const Count count = by_lamp(
            pair, &(ShadowScene){HEAD, "silhouette", lamp, angle, {objects[0], objects[1]}});
        all.lit += count.lit, all.dark += count.dark, all.band += count.band;
        all.acne += count.acne, all.leaks += count.leaks;
        print_message(
            "%-12s %-14.14s %4g degrees: %5d lit, %4d dark, %4d in bands; acne %d, leaks %d\n",
            name, lamp->kind, angle[0], count.lit, count.dark, count.band, count.acne, count.leaks);
    }
    print_message("%s: %d lit, %d dark, %d in bands; acne %d, leaks %d\n", name, all.lit, all.dark,
                  all.band, all.acne, all.leaks);
    assert_true(all.lit > 8000 && all.dark > 2000);
    assert_int_equal(all.acne, 0);
    assert_true(all.leaks <= most);
}

/* With intersecting bodies, in all 35 lights, two pixels of 172,062 are lit beside an end: the
 * visible surface begins within the cell. */
static void away_from_ends(void **state)
{
    (void)state;
    ShadowPair pair;
    shadow_pair_open(GL_KIND_osmesa, &pair);
    by_every_lamp(&pair, "on a mesh",
                  (const char *[2]){SHADOW_SCENE_GROUND, SHADOW_SCENE_OBJECTS("")}, 0);
    by_every_lamp(&pair, "on a plane",
                  (const char *[2]){SHADOW_SCENE_PLANE, SHADOW_SCENE_OBJECTS("") SUNK}, 0);
    by_every_lamp(&pair, "nasty", (const char *[2]){SHADOW_SCENE_GROUND, NASTY},
                  all_of_them ? 2 : 0);
    shadow_pair_close(&pair);
}

int main(int count, char **arguments)
{
    all_of_them = count > 1 && !strcmp(arguments[1], "all");
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends_are_true),
                                       cmocka_unit_test(away_from_ends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
