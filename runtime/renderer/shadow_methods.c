/* The shadow techniques, in the order in which their rows are called: the first that uses
 * triangle ids owns the target `seen`; shadow volumes may read silhouette crossings. */
#include "runtime/renderer/passes.h"
#include "runtime/renderer/renderer.h"
#include "runtime/shadow/shadow_method.h"

/* clang-format off */
#define METHODS(ROW) \
    ROW(map) \
    ROW(exact) \
    ROW(silhouette) \
    ROW(hybrid)
/* clang-format on */
#define DECLARE(name) extern const ShadowMethod shadow_##name;
#define ENTER(name)   &shadow_##name,
METHODS(DECLARE)
const ShadowMethod *const shadow_methods[] = {METHODS(ENTER) NULL};
_Static_assert(sizeof shadow_methods / sizeof *shadow_methods <= SHADOW_METHODS_MAX,
               "GLSL counts from 1");

const char *renderer_shadows_vary(Scene *scene, Keyword method, Keyword variant)
{
    int i = 0;
    while (shadow_methods[i] && shadow_methods[i]->word != method)
        i++;
    return shadow_methods[i] && shadow_methods[i]->vary && shadow_methods[i]->vary(scene, variant)
               ? keyword_table[variant].name
               : NULL;
}
