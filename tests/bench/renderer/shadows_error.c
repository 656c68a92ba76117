/* Two pictures of the same points, compared by tests/frame_reference/boundary.h. */
#include "shadows_error.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame_reference/boundary.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static bool reported(const char *why) { return fprintf(stderr, "matbench: %s\n", why) < 0; }

/* -- pictures */

const ShadowsMethod shadows_truth = {
    {"exact", "default"}, KEYWORD_Shadows_exact, 1, KEYWORD_Volume_perfect, false,
    KEYWORD_Path_auto};
static const ShadowsMethod usual = {
    {"map", "default"}, KEYWORD_Shadows_map, 1, KEYWORD_Volume_perfect, false, KEYWORD_Path_auto};

/* Draws a view of the scene, four floats per pixel, from malloc; NULL after a message. The
 * light's first shadow view goes to *view, if not NULL. */
static float *draw(const ShadowsPicture *p, const char *view, const ShadowsMethod *method,
                   ShadowView *seen)
{
    const RendererOptions options = {.compile = p->target.compile,
                                     .view = view,
                                     .width = p->target.edge,
                                     .height = p->target.edge,
                                     .no_shadows = !method};
    shadows_use(p->scene, method ? method : &usual, p->target.map_size);
    Renderer *render = renderer_open(p->target.gl, &options);
    float *rgba = malloc(4 * sizeof *rgba * (size_t)p->target.edge * (size_t)p->target.edge);
    const bool done = render && rgba && renderer_set_scene(render, p->scene) &&
                      renderer_frame(render) && renderer_read(render, rgba);
    if (done && seen)
        *seen = render->shadows->views.views[0];
    renderer_close(render);
    if (done)
        return rgba;
    free(rgba);
    return reported(p->target.gl->error), NULL;
}

/* One component of a view. */
static float *draw_component(const ShadowsPicture *p, const ShadowsMethod *method)
{
    float *components = draw(p, "light", method, NULL);
    for (int i = 0; components && i < p->target.edge * p->target.edge; i++)
        components[i] = components[4 * i];
    return components;
}

/* The share of the light that arrives; NULL after a message. */
static float *draw_shares(const ShadowsPicture *p, const ShadowsMethod *method)
{
    float *shares = draw_component(p, method);
    for (int i = 0; shares && i < p->target.edge * p->target.edge; i++)
        shares[i] = p->light[i] > 0 ? shares[i] / p->light[i] : 0;
    return shares;
}

/* An orthographic camera's depth is 1 - distance / depth. */
static void place_pixel(const ShadowsPicture *p, const ShadowView *view, int pixel, double depth)
{
    const SceneCamera *camera = &p->scene->camera;
    const double x = (2 * (pixel % p->target.edge) + 1.0) / p->target.edge - 1,
                 y = (2 * (pixel / p->target.edge) + 1.0) / p->target.edge - 1;
    for (int row = 0; row < 2; row++) {
        double component = view->rows[row][3];
        for (int i = 0; i < 3; i++)
            component +=
                view->rows[row][i] *
                (camera->position[i] + camera->half * (x * camera->right[i] + y * camera->up[i]) -
                 (1 - depth) * camera->depth * camera->back[i]);
        p->places[pixel][row] = component * p->target.map_size / 2;
    }
}

static bool place_pixels(ShadowsPicture *p)
{
    ShadowView view;
    float *depths = draw(p, "depth", &usual, NULL),
          *unused = depths ? draw(p, "light", &usual, &view) : NULL;
    p->places = malloc(sizeof *p->places * (size_t)p->target.edge * (size_t)p->target.edge);
    for (int i = 0; unused && p->places && i < p->target.edge * p->target.edge; i++)
        place_pixel(p, &view, i, (double)depths[4 * i]);
    free(depths);
    free(unused);
    return unused && p->places;
}

/* -- errors */

static Boundary boundary_of(const ShadowsPicture *p)
{
    const double apart = 8; /* in texels: a more distant neighbor pixel shows another surface */
    return (Boundary){p->target.edge, (const double(*)[2])p->places, p->light, p->truth, apart};
}

bool shadows_picture_error(const ShadowsPicture *p, const ShadowsMethod *method, int map_size,
                           ShadowsError *error)
{
    const Boundary boundary = boundary_of(p);
    ShadowsPicture other = *p; /* with another map size; positions stay in texels of this one */
    other.target.map_size = map_size;
    float *shares = draw_shares(&other, method);
    if (!shares)
        return false;
    Boundary drawn = boundary;
    drawn.truth = shares;
    *error = (ShadowsError){boundary_area(&boundary, shares) / p->length,
                            boundary_length(&drawn) / p->length};
    free(shares);
    return true;
}

bool shadows_picture_open(const ShadowsTarget *target, const ShadowsPlace *place,
                          ShadowsPicture *made)
{
    *made = (ShadowsPicture){.target = *target, .scene = place->scene};
    made->light = draw_component(made, NULL);
    made->truth = made->light ? draw_shares(made, &shadows_truth) : NULL;
    if (!made->truth || !place_pixels(made))
        return false;
    const Boundary boundary = boundary_of(made);
    made->length = boundary_length(&boundary);
    return true;
}

void shadows_picture_close(ShadowsPicture *picture)
{
    free(picture->places);
    free(picture->light);
    free(picture->truth);
    *picture = (ShadowsPicture){0};
}
