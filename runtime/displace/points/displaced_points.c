/* Displacement by points: a vertex program computes the points of a grid, and a geometry program
 * emits a symbol for each. */
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include "runtime/scene/scene_matrix.h"

enum { SOFTWARE_POINTS = 1 << 15 /* limit per draw: see displaced_tessellation.c */ };

/* Symbols, by their numbers in displace_symbol.glsl, with their numbers of triangles. */
static const struct {
    Keyword word;
    int triangles;
} symbols[] = {{KEYWORD_Symbol_square, 2},
               {KEYWORD_Symbol_billboard, 2},
               {KEYWORD_Symbol_cylinder, 22},
               {KEYWORD_Symbol_sphere, 36}};
enum {
    BILLBOARD = 1,
    HEIGHTS = 4 /* max symbols over a point of a volume */,
    SYMBOLS = sizeof symbols / sizeof *symbols
};

static int symbol_of(const Displaced *d)
{
    int symbol = 0;
    while (symbol < SYMBOLS - 1 && symbols[symbol].word != d->patches->dividing.symbol)
        symbol++;
    return symbol;
}

static bool make(const DisplacedMaking *making, Displaced *made)
{
    ProgramText text = {
        .vertex = {displaced_version, render_text_displace_point,
                   render_text_displace_symbol_vertex},
        .geometry = {displaced_version,
                     made->volume ? "#define DISPLACE_POINT\n#define DISPLACE_VOLUME\n"
                                  : "#define DISPLACE_POINT\n",
                     making->displace, render_text_displace_point, render_text_displace_symbol}};
    if (!displaced_program(making, &text, &made->material))
        return false;
    material_set_number(&made->material, "displace_symbol", (float)symbol_of(made));
    material_set_number(&made->material, "displace_spread", (float)made->patches->dividing.spread);
    return true;
}

static void set_eye(Displaced *d, const DisplacedView *view)
{
    SceneMatrix inverse;
    float eye[3];
    /* scene_displaced_mesh() has checked that the matrix is invertible */
    scene_matrix_invert(&d->patches->world_from_local, &inverse);
    for (int i = 0; i < 3; i++) {
        double sum = inverse.m[12 + i];
        for (int k = 0; k < 3; k++)
            sum += inverse.m[4 * k + i] * view->scene->camera.position[k];
        eye[i] = (float)sum;
    }
    material_set(&d->material, &(MaterialValue){"displace_eye", 3, eye});
}

/* Returns the number of points: the grid's, or three for each of its triangles. */
static int points_of(const Displaced *d, int n)
{
    return d->patches->dividing.spread > 0 ? 3 * n * n : (n + 1) * (n + 2) / 2;
}

/* Returns the number of triangles of a patch's symbols. */
static int triangles_of(const Displaced *d, int n)
{
    return points_of(d, n) * symbols[symbol_of(d)].triangles * (d->volume ? HEIGHTS : 1);
}

/* Draws patches of n parts, captured from row `at` of the mesh on; returns the next row. Draws
 * few patches at a time on Mesa's software renderers. */
static size_t draw_patches(Displaced *d, const int first[2], int n, const Mesh *mesh, size_t at)
{
    const GlContext *gl = displaced_context(d);
    const int points = 3 * triangles_of(d, n);
    const int most = gl->hardware               ? first[1] - first[0]
                     : points > SOFTWARE_POINTS ? 1
                                                : SOFTWARE_POINTS / points;
    material_set_number(&d->material, "displace_parts", (float)n);
    for (int from = first[0]; from < first[1];) {
        const int count = first[1] - from < most ? first[1] - from : most;
        material_set_number(&d->material, "displace_first", (float)from);
        displaced_capture(d, mesh, at, (size_t)count * (size_t)points);
        gl->DrawArraysInstanced(GL_POINTS, 0, points_of(d, n), count);
        gl->EndTransformFeedback();
        at += (size_t)count * (size_t)points;
        from += count;
    }
    return at;
}

static size_t patch_triangles(const Displaced *d, int n) { return (size_t)triangles_of(d, n); }
static const DisplacedByParts by_parts = {patch_triangles, draw_patches};

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    int first[SCENE_PATCH_PARTS + 2];
    if (symbol_of(d) == BILLBOARD)
        d->written = false; /* billboards turn with the camera */
    if (!displaced_parts(d, view, first))
        return false;
    set_eye(d, view);
    return !d->anew || displaced_by_parts(d, first, &by_parts, mesh);
}

const DisplacedMethod displaced_points = {
    KEYWORD_Displacing_points, true, displaced_geometry_supported, make, write, NULL};
