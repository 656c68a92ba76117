/* Exact shadows, for the passes: triangles and lists on the driver's side, which triangle a pixel
 * sees, and what the lighting of surfaces reads of them (pass_exact.c). */
#ifndef MATC_EXACT_EXACT_H
#define MATC_EXACT_EXACT_H
#include "runtime/exact/exact_state.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/frame/render_options.h"

/* Some light's shadows are exact, and light is drawn: so are numbers of triangles. And there is
 * something opaque. exact_lights.c. */
bool exact_lights_number(const Render *render);
bool exact_lights_cast(const Render *render);
/* Of what is needed, when the cache is there. */
bool pass_exact_make(Render *render);
/* The camera is another, or lights are, and lists are made again: a sum of RenderChange. */
bool pass_exact_change(Render *render, unsigned what);
/* So many objects from `first` on stand elsewhere. */
bool pass_exact_move(Render *render, int first, int count);
/* Makes the lists again; the driver may still be at it. */
bool pass_exact_list(Render *render);
/* For the programs that write numbers. */
void pass_exact_begin(const Render *render);
void pass_exact_delete(Render *render);

/* For lighting.c: GLSL, two texts before that of shadows and one behind it; `seen`: of the surface
 * that a pixel sees. Numbers; one unit. */
enum { EXACT_TEXTS = 3 };
void pass_exact_texts(const Render *render, bool seen, const char *texts[EXACT_TEXTS]);
void pass_exact_set(const Render *render, int unit, ScreenPass *pass);
void pass_exact_bind(const Render *render, int unit);
#endif
