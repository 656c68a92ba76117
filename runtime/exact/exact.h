/* Exact shadows: triangles and lists on the driver's side, the row of shadow_method.h, and which
 * triangle a pixel sees. */
#ifndef MATC_EXACT_EXACT_H
#define MATC_EXACT_EXACT_H
#include "runtime/exact/exact_cover.h"
#include "runtime/shadow/shadow_method.h"

/* State for a scene. */
typedef struct {
    ExactTriangles triangles;
    ExactCover cover;       /* lists; its programs live as long as the renderer */
    GLuint corners, firsts; /* buffers: triangles; each object's first, counted from 1 */
} ExactShadows;

static inline ExactShadows *exact_state(const Render *render)
{
    return shadow_method_state(render, WORD_Shadows_exact);
}
/* A light's shadows are exact, and light is drawn; and something opaque casts. */
bool pass_exact_wanted(const Render *render);
bool pass_exact_needed(const Render *render);
/* Functions of the row; `list` makes the lists again, at which the driver may still be. */
bool pass_exact_make(Render *render);
bool pass_exact_change(Render *render, unsigned what);
bool pass_exact_move(Render *render, int first, int count);
bool pass_exact_list(Render *render);
void pass_exact_delete(Render *render);
#endif
