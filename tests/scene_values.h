/* Compares numbers of a Scene with expected ones, for tests. A member has one name in both:
 *
 *   CHECK(half)            is->half against should_be->half
 *   CHECK_LIST(position)   each component */
#ifndef TESTS_SCENE_VALUES_H
#define TESTS_SCENE_VALUES_H
#include "tests/scene_text.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))
#define PI           3.14159265358979324
/* Gives scenes light and a visible object, so that they cause no warning. */
#define LIT        RED "lights: [{ light: Ambient }]\n"
#define LIT_SPHERE LIT "objects: [{ object: Sphere, material: red }]\n"

static inline void same(double is, double should_be, const char *member, const char *text)
{
    if (!(fabs(is - should_be) <= 1e-12 * fmax(1, fabs(should_be))))
        fail_msg("%s is %.17g, not %.17g:\n%s", member, is, should_be, text);
}

static inline void same_list(const double *is, const double *should_be, int count,
                             const char *member, const char *text)
{
    for (int i = 0; i < count; i++)
        same(is[i], should_be[i], member, text);
}

#define CHECK(member) same((double)is->member, (double)should_be->member, #member, text)
#define CHECK_LIST(member)                                                                         \
    same_list((const double *)is->member, (const double *)should_be->member,                       \
              (int)(sizeof is->member / sizeof(double)), #member, text)

/* Fails for a kind without a row in a table. */
static inline void all_kinds_met(SceneSort sort, const bool met[SCENE_KIND_COUNT])
{
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++)
        if (scene_kind_table[kind].sort == sort && !met[kind])
            fail_msg("the kind %s has no row", scene_kind_table[kind].name);
}
#endif
