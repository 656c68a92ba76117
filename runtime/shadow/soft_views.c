/* Half-cube views around the points of an area light. */
#include "runtime/shadow/soft_views.h"
#include "runtime/scene/scene_area.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

/* Inset of the outermost points, as a share of an edge: they must not be inside an object along
 * the light's edge. */
static const double inset = 1.0 / 256;

bool soft_views_wanted(const SceneLight *light)
{
    return light_from(light) == LIGHT_FROM_extent && scene_light_casts(light);
}

static int points_of(const Scene *scene) { return scene->shadow_points * scene->shadow_points; }

int soft_views_count(const Scene *scene, const SceneLight *light)
{
    return soft_views_wanted(light) ? points_of(scene) * (light->both_sides ? 2 : 1) : 0;
}

void soft_views_place(const Scene *scene, const SceneLight *light, int number, double position[3])
{
    const int points = scene->shadow_points, at[2] = {number % points, number / points % points};
    SceneLight cut;
    scene_area_cut(&scene->camera, light, &cut);
    memcpy(position, cut.position, 3 * sizeof *position);
    for (int edge = 0; edge < 2; edge++) {
        const double part = fmin(fmax((double)at[edge] / (points - 1), inset), 1 - inset);
        for (int i = 0; i < 3; i++)
            position[i] += part * cut.edges[edge][i];
    }
}

static void axes_of(const SceneLight *light, bool back, double axes[3][3])
{
    memcpy(axes[0], light->edges[0], sizeof axes[0]);
    vec3_normalize(axes[0]);
    vec3_cross(light->edges[0], light->edges[1], axes[2]);
    vec3_normalize(axes[2]);
    vec3_cross(axes[2], axes[0], axes[1]);
    for (int i = 0; i < 3 && back; i++)
        axes[2][i] = -axes[2][i];
}

void soft_views_make(const Scene *scene, const SceneLight *light, int number, double near,
                     ShadowView *view)
{
    const int quarter = scene->shadow_size / 4;
    double axes[3][3], position[3];
    axes_of(light, number >= points_of(scene), axes);
    soft_views_place(scene, light, number, position);
    *view = (ShadowView){.near = near, .texel = 1.0 / quarter, .soft = true};
    for (int row = 0; row < 3; row++) {
        memcpy(view->rows[row], axes[row], sizeof axes[row]);
        view->rows[row][3] = -vec3_dot(axes[row], position);
    }
}

/* Returns true for left-handed axes, like a map's own if z points away from the light. */
static bool is_mirrored(const ShadowView *view)
{
    double across[3];
    vec3_cross(view->rows[0], view->rows[1], across);
    return vec3_dot(across, view->rows[2]) > 0;
}

void soft_views_face(const ShadowView *view, int size, int face, ShadowView *made, int rect[4])
{
    const int quarter = size / 4, axis = (face - 1) / 2, sign = face % 2 ? 1 : -1;
    *made = *view;
    for (int i = 0; i < 2; i++) {
        rect[i] = quarter;
        rect[2 + i] = 2 * quarter;
    }
    if (face) {
        rect[axis] = sign > 0 ? 3 * quarter : 0;
        rect[2 + axis] = quarter;
        for (int k = 0; k < 4; k++) {
            made->rows[axis][k] = view->rows[axis][k] - 2 * sign * view->rows[2][k];
            made->rows[2][k] = sign * view->rows[axis][k];
        }
    }
    made->mirrored = is_mirrored(made);
}
