/* Displacement by a geometry program with loops: patches of n parts are one draw. Each patch is
 * divided into parts small enough for the geometry program's output limit, and each part is an
 * input point. */
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include <stdio.h>

/* Components captured per point; and the limit of points per draw on Mesa's software renderers:
 * displaced_tessellation.c. */
enum { GEOMETRY_COMPONENTS = sizeof(MeshCaptured) / sizeof(float), SOFTWARE_POINTS = 1 << 15 };

bool displaced_geometry_supported(const GlContext *gl)
{
    GLint buffers = 0;
    gl->GetIntegerv(GL_MAX_GEOMETRY_SHADER_STORAGE_BLOCKS, &buffers);
    return buffers >= DISPLACED_BUFFERS;
}

/* Returns the max number of points that a geometry program may emit per input, with all captured
 * components. */
static int displaced_geometry_points(const GlContext *gl)
{
    GLint components = 0, points = 0;
    gl->GetIntegerv(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS, &components);
    gl->GetIntegerv(GL_MAX_GEOMETRY_OUTPUT_VERTICES, &points);
    return components / GEOMETRY_COMPONENTS < points ? components / GEOMETRY_COMPONENTS : points;
}

/* -- output sizes: n rows have n^2 triangles in strips of n^2 + 2 n points; a band has two
 * points for each end of its edges, and two triangles for each edge */

static int points_of(int rows, Keyword skirts)
{
    const int strips = rows * (rows + 2);
    return skirts == KEYWORD_Skirts_outline ? strips + 6 * (rows + 1)
           : skirts == KEYWORD_Skirts_all   ? strips + 8 * rows * rows
           : skirts == KEYWORD_Skirts_copy  ? strips + 3
                                            : strips;
}

/* Returns the number of triangles of a patch whose edges have n parts. */
static size_t triangles_of(int n, Keyword skirts)
{
    const size_t all = (size_t)n * (size_t)n;
    return skirts == KEYWORD_Skirts_outline ? all + 6 * (size_t)n
           : skirts == KEYWORD_Skirts_all   ? 7 * all
           : skirts == KEYWORD_Skirts_copy  ? all + 1
                                            : all;
}

/* Returns the greatest number of rows that divides n and fits into `points`. */
static int rows_of(int n, Keyword skirts, int points)
{
    int rows = n;
    while (rows > 1 && (n % rows || points_of(rows, skirts) > points))
        rows--;
    return rows;
}

/* -- programs */

static bool make(const DisplacedMaking *making, Displaced *made)
{
    char most[64];
    snprintf(most, sizeof most, "#define DISPLACE_VERTICES %d\n",
             displaced_geometry_points(store_context(making->store)));
    ProgramText text = {.vertex = {displaced_version, render_text_displace_item},
                        .geometry = {displaced_version, "#define DISPLACE_POINT\n", most,
                                     making->displace, render_text_displace_point,
                                     render_text_displace_loop}};
    if (!displaced_program(making, &text, &made->material))
        return false;
    const Keyword skirts = making->patches->dividing.skirts;
    material_set_number(&made->material, "displace_skirts",
                        skirts == KEYWORD_Skirts_copy      ? 1
                        : skirts == KEYWORD_Skirts_outline ? 2
                        : skirts == KEYWORD_Skirts_all     ? 3
                                                           : 0);
    return true;
}

/* -- triangles */

/* Draws patches of n parts, captured from row `at` of the mesh on; returns the next row. Draws
 * few patches at a time on Mesa's software renderers. */
static size_t draw_patches(Displaced *d, const int first[2], int n, const Mesh *mesh, size_t at)
{
    const GlContext *gl = displaced_context(d);
    const Keyword skirts = d->patches->dividing.skirts;
    const int rows = rows_of(n, skirts, displaced_geometry_points(gl)), parts = n / rows;
    const size_t points = 3 * triangles_of(n, skirts);
    const int most = gl->hardware               ? first[1] - first[0]
                     : points > SOFTWARE_POINTS ? 1
                                                : SOFTWARE_POINTS / (int)points;
    material_set_number(&d->material, "displace_rowCount", (float)rows);
    material_set_number(&d->material, "displace_parts", (float)parts);
    for (int from = first[0]; from < first[1];) {
        const int count = first[1] - from < most ? first[1] - from : most;
        material_set_number(&d->material, "displace_first", (float)from);
        displaced_capture(d, mesh, at, (size_t)count * points);
        gl->DrawArrays(GL_POINTS, 0, count * parts * parts);
        gl->EndTransformFeedback();
        at += (size_t)count * points;
        from += count;
    }
    return at;
}

static size_t patch_triangles(const Displaced *d, int n)
{
    return triangles_of(n, d->patches->dividing.skirts);
}
static const DisplacedByParts by_parts = {patch_triangles, draw_patches};

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    int first[SCENE_PATCH_PARTS + 2];
    return displaced_parts(d, view, first) &&
           (!d->anew || displaced_by_parts(d, first, &by_parts, mesh));
}

const DisplacedMethod displaced_geometry = {
    KEYWORD_Displacing_geometry, false, displaced_geometry_supported, make, write, NULL};
