/* Exact shadows, for the passes: triangles and lists on the driver's side, which triangle a pixel sees, and what the lighting of surfaces reads of them
 * (pass_exact.c). Private to frame.c, render.c and the passes. */
#ifndef MATC_RENDER_EXACT_H
#define MATC_RENDER_EXACT_H
#include "runtime/render/exact_lists.h"
#include "runtime/render/render.h"
#include "runtime/render/screen_pass.h"

typedef struct {
    double origin[3], reach;        /* of exact_triangles.h */
    int triangle_count, list_count; /* lights with lists */
    size_t list_bytes;
    size_t longest;                 /* list */
    double seconds;                 /* in which triangles and lists were made */
    GLuint array, triangles, lists; /* buffers: corners, as vertices too; words of exact_lists.h */
    Material material;              /* draws numbers of triangles */
} ExactShadows;

/* Some light's shadows are exact, and there is something opaque. */
bool pass_exact_needed(const Render *render);
bool pass_exact_make(Render *render);
/* The camera is another, or what triangles and lists are made of. */
bool pass_exact_change(Render *render, bool made_again);
void pass_exact_draw(Render *render);
void pass_exact_delete(Render *render);

/* For lighting.c: GLSL, two texts before that of shadows and one behind it; `seen`: of the surface that a pixel sees. Numbers; one unit. */
enum { EXACT_TEXTS = 3 };
void pass_exact_texts(const Render *render, bool seen, const char *texts[EXACT_TEXTS]);
void pass_exact_set(const Render *render, int unit, ScreenPass *pass);
void pass_exact_bind(const Render *render, int unit);
#endif
