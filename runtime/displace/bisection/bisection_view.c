/* A view for bisection: frustum planes and positions as uniforms, lights, and the camera's
 * movement. */
#include "runtime/displace/bisection/bisection.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

/* Sets the unit normals of the four sides of the view frustum, and of its near plane. */
static void find_sides(const SceneCamera *camera, const int size[2], double normals[5][3])
{
    const double shorter = size[0] < size[1] ? size[0] : size[1];
    for (int side = 0; side < 5; side++) {
        const double reach = camera->half * size[side / 2 % 2] / shorter, way = side % 2 ? 1 : -1;
        const double back = side == 4 ? 1 : camera->kind == SCENE_Orthographic ? 0 : reach;
        const double length = sqrt(side == 4 ? 1 : 1 + back * back);
        for (int i = 0; i < 3; i++)
            normals[side][i] =
                ((side == 4 ? 0 : way * (side / 2 ? camera->up[i] : camera->right[i])) -
                 back * camera->back[i]) /
                length;
    }
}

static void set_plane(const double normal[3], const double at[3], double offset, float plane[4])
{
    plane[3] = (float)offset;
    for (int i = 0; i < 3; i++) {
        plane[i] = (float)normal[i];
        plane[3] -= (float)(normal[i] * at[i]);
    }
}

void bisection_view_set(Displaced *d, const DisplacedView *view, const Mesh *mesh)
{
    const SceneCamera *camera = &view->scene->camera;
    const double shorter = view->size[0] < view->size[1] ? view->size[0] : view->size[1];
    const bool parallel = camera->kind == SCENE_Orthographic;
    float sides[16], front[4], eye[4];
    double normals[5][3];
    find_sides(camera, view->size, normals);
    for (int side = 0; side < 4; side++)
        set_plane(normals[side], camera->position,
                  parallel ? camera->half * view->size[side / 2] / shorter : 0, &sides[4 * side]);
    set_plane(normals[4], camera->position, 0, front);
    for (int i = 0; i < 3; i++)
        eye[i] = (float)(parallel ? camera->back[i] : camera->position[i]);
    eye[3] = parallel ? 0 : 1;
    bisection_set(d, "bisect_sides", 16, sides);
    bisection_set(d, "bisect_front", 4, front);
    bisection_set(d, "bisect_eye", 4, eye);
    bisection_set_number(d, "bisect_near", fmax(camera->near, 1e-6));
    bisection_set_number(d, "bisect_scale", shorter / 2 / camera->half);
    bisection_set_number(d, "bisect_closed", mesh->body != SHAPE_BODY_none ? 3 : 0);
}

/* Sets a light's position, and as its extent a bounding box of the area light's parallelogram. */
static void set_light(const SceneLight *light, float at[4], float extent[3])
{
    const bool far = light_from(light) == LIGHT_FROM_afar;
    for (int k = 0; k < 3; k++) {
        at[k] = (float)(far ? -light->direction[k] : light->position[k]);
        for (int i = 0; i < 2 && light_from(light) == LIGHT_FROM_extent; i++) {
            at[k] += (float)(light->edges[i][k] / 2);
            extent[k] += (float)(fabs(light->edges[i][k]) / 2);
        }
    }
    at[3] = !far;
}

BisectionLights bisection_view_lights(const DisplacedView *view)
{
    const float anywhere = 1e30f;
    const Scene *scene = view->scene;
    BisectionLights found = {0};
    for (int i = 0; i < scene->light_count && found.count < BISECTION_LIGHTS_MAX; i++) {
        const SceneLight *light = &scene->lights[i];
        if (!bisection_casts(light))
            continue;
        set_light(light, found.each[found.count], found.extent[found.count]);
        found.count++;
    }
    for (int k = 0; k < 3; k++) {
        const bool ends = view->low[k] < view->high[k];
        found.box[0][k] = ends ? (float)view->low[k] : -anywhere;
        found.box[1][k] = ends ? (float)view->high[k] : anywhere;
    }
    return found;
}

static double distance(const double a[3], const double b[3])
{
    double square = 0;
    for (int i = 0; i < 3; i++)
        square += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(square);
}

/* Returns an upper bound of the distance from the eye to all queried points: points of the mesh,
 * and lights. */
static double farthest(const Bisection *b, const double eye[3])
{
    double far = 1, corner[3];
    for (int i = 0; i < 3; i++)
        corner[i] = eye[i] - b->box[0][i] > b->box[1][i] - eye[i] ? b->box[0][i] : b->box[1][i];
    far = fmax(far, distance(eye, corner));
    for (int i = 0; i < b->lights.count; i++) {
        const double light[3] = {(double)b->lights.each[i][0], (double)b->lights.each[i][1],
                                 (double)b->lights.each[i][2]};
        const double extent[3] = {(double)b->lights.extent[i][0], (double)b->lights.extent[i][1],
                                  (double)b->lights.extent[i][2]};
        far = b->lights.each[i][3] != 0
                  ? fmax(far, distance(eye, light) + sqrt(vec3_dot(extent, extent)))
                  : far;
    }
    return far;
}

void bisection_view_move(Displaced *d, const DisplacedView *view, const BisectionLights *lights)
{
    Bisection *b = d->own;
    const SceneCamera *was = &b->camera, *is = &view->scene->camera;
    const double rounded = 4e-6;
    double turned = 0, normals[2][5][3], far = farthest(b, is->position), most = far;
    if (was->kind != is->kind || was->half != is->half || was->near != is->near ||
        memcmp(b->size, view->size, sizeof b->size) || memcmp(&b->lights, lights, sizeof *lights))
        b->pixels = 0;
    find_sides(was, view->size, normals[0]);
    find_sides(is, view->size, normals[1]);
    for (int side = 0; side < 5; side++)
        turned = fmax(turned, distance(normals[0][side], normals[1][side]));
    b->gone += distance(was->position, is->position) * (1 + turned) + turned * far;
    for (int i = 0; i < 3; i++)
        most = fmax(most, fabs(is->position[i]));
    /* The rounding error stays below the slack as long as numbers are no larger. */
    if (b->gone > far)
        b->pixels = 0;
    bisection_set_number(d, "bisect_slack", rounded * most);
}
