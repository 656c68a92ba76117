/* Exact shadows: triangles and lists on the GPU, functions of the shadow_method.h row, and the
 * triangle id per pixel. */
#ifndef MATC_EXACT_EXACT_H
#define MATC_EXACT_EXACT_H
#include "runtime/exact/exact_cover.h"
#include "runtime/shadow/shadow_method.h"

/* Exact shadows' state for a scene. */
typedef struct {
    ExactTriangles triangles;
    ExactCover cover; /* the lights' lists; its programs live as long as the renderer */
    /* `corners` holds the triangles; `firsts` the number of each object's first triangle, from 1 */
    GLuint corners, firsts;
} ExactShadows;

static inline ExactShadows *exact_state(const Renderer *renderer)
{
    return shadow_method_state(renderer, KEYWORD_Shadows_exact);
}
/* Return whether some light has exact shadows, and the view shows lighting; and additionally,
 * whether some object has triangles for exact shadows. */
bool pass_exact_wanted(const Renderer *renderer);
bool pass_exact_needed(const Renderer *renderer);
/* Functions of the row. pass_exact_list() makes the lists; the GPU may still be working on them
 * when it returns. */
bool pass_exact_make(Renderer *renderer);
bool pass_exact_change(Renderer *renderer, unsigned what);
bool pass_exact_move(Renderer *renderer, int first, int count);
bool pass_exact_list(Renderer *renderer);
void pass_exact_delete(Renderer *renderer);
#endif
