/* Fits views to lights and to the bounding boxes of shadow casters. */
#include "runtime/shadow/shadow_method.h"
#include "runtime/shadow/soft_views.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 8 };

/* Least near distance as a share of the distance to the farthest object; nearer objects cast no
 * shadow. */
static const double nearest = 1.0 / 4096;

static const double coarser = 4; /* maximum ratio of the depths at which successive cascades end */
static const double steps = 4;   /* number of texel sizes of cascades per octave */

typedef struct {
    const ShadowMethod *const *methods;
    const Scene *scene;
    ShadowViews *made;
    const int *size;      /* size of the picture in pixels */
    double (*corners)[3]; /* corners of the casters' bounding boxes, in world space */
    int count;
    bool varying; /* the transparency of some caster varies */
} Fit;

static void add_corners(Fit *fit, const CullBox *box, const SceneMatrix *world_from_local)
{
    const double *m = world_from_local->m, *const ends[2] = {box->low, box->high};
    for (int i = 0; i < CORNERS; i++, fit->count++) {
        const double at[3] = {ends[i & 1][0], ends[i >> 1 & 1][1], ends[i >> 2 & 1][2]};
        for (int component = 0; component < 3; component++)
            fit->corners[fit->count][component] = m[component] * at[0] + m[4 + component] * at[1] +
                                                  m[8 + component] * at[2] + m[12 + component];
    }
}

/* Sets a row of a view matrix: a scaled axis, 0 at `origin`. */
static void set_row(const double axis[3], double scale, const double origin[3], double row[4])
{
    for (int component = 0; component < 3; component++)
        row[component] = scale * axis[component];
    row[3] = -scale * vec3_dot(axis, origin);
}

/* -- point and spot */

/* Returns the near distance of a view: the distance to the nearest object's box, but at least a
 * share of the distance to the farthest. A smaller value would lose depth precision far away; a
 * greater one would lose objects. */
static double near_of(const Fit *fit, const double position[3])
{
    double least = INFINITY, most = 0;
    for (int object = 0; object < fit->count; object += CORNERS) {
        double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY},
               square = 0;
        for (int i = 0; i < CORNERS; i++) {
            const double *corner = fit->corners[object + i];
            double distance = 0;
            for (int component = 0; component < 3; component++) {
                low[component] = fmin(low[component], corner[component]);
                high[component] = fmax(high[component], corner[component]);
                distance = hypot(distance, corner[component] - position[component]);
            }
            most = fmax(most, distance);
        }
        for (int component = 0; component < 3; component++) {
            const double out = fmax(
                fmax(low[component] - position[component], position[component] - high[component]),
                0);
            square += out * out;
        }
        least = fmin(least, sqrt(square));
    }
    /* distance along an axis of a cube view's corner at distance `least` */
    const double along = least / sqrt(3);
    return fmax(fmax(along * 0.99, most * nearest), 1e-30);
}

/* Returns half the edge of a cube's face at distance 1: more than 1 if faces overlap by a
 * border. */
static double face_of(const Fit *fit, const SceneLight *light)
{
    /* texels of both sides: the border, and half a texel to the center of the next one */
    enum { BORDER = 4 };
    const double size = fit->scene->shadow_size;
    return shadow_method_of(fit->methods, light)->border ? size / (size - BORDER) : 1;
}

static void fit_cube(const Fit *fit, const SceneLight *light, ShadowView views[SHADOW_VIEWS_CUBE])
{
    const double half = face_of(fit, light);
    const double near = near_of(fit, light->position) / half;
    for (int face = 0; face < SHADOW_VIEWS_CUBE; face++) {
        const int axis = face / 2;
        double axes[3][3] = {{0}};
        axes[0][(axis + 1) % 3] = axes[1][(axis + 2) % 3] = axes[2][axis] = 1;
        for (int row = 0; row < 3; row++)
            set_row(axes[row],
                    row < 2    ? 1 / half
                    : face % 2 ? -1
                               : 1,
                    light->position, views[face].rows[row]);
        views[face].near = near;
        views[face].texel = 2 * half / fit->scene->shadow_size;
        /* x, y and z of a right-handed view: z points towards the light */
        views[face].mirrored = face % 2 == 0;
    }
}

/* Returns the factor that widens a cone by a margin for the filter's texels. */
static double widened(const Scene *scene)
{
    return 1 + 2.0 * (scene->shadow_filter + 2) / scene->shadow_size;
}

static void fit_cone(const Fit *fit, const SceneLight *light, ShadowView *view)
{
    const double cosine = fmax(light->outer_cosine, LIGHT_KIND_WIDEST);
    const double half =
        fmax(sqrt(1 - fmin(cosine * cosine, 1)) / cosine, 1e-6) * widened(fit->scene);
    double x[3], y[3];
    scene_vector_axes(light->direction, x, y);
    set_row(x, 1 / half, light->position, view->rows[0]);
    set_row(y, 1 / half, light->position, view->rows[1]);
    set_row(light->direction, 1, light->position, view->rows[2]);
    view->near = near_of(fit, light->position);
    view->texel = 2 * half / fit->scene->shadow_size;
    view->mirrored = true;
}

/* -- directional */

static void range_of(const Fit *fit, const double axis[3], double range[2])
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i < fit->count; i++) {
        const double along = vec3_dot(axis, fit->corners[i]);
        range[0] = fmin(range[0], along);
        range[1] = fmax(range[1], along);
    }
}

/* The center of a map along an axis, and half of its extent. */
typedef struct {
    double middle, half;
} Reach;

/* Stabilizes a cascade: its texels keep their positions when the camera moves a little. Their
 * size is one of a few, and their edges are at multiples of that size, so shadow edges do not
 * flicker. A map of 8 texels for 5.1 to 9.9, 4.8 wide: of the sizes 0.595, 0.707, 0.841, ...
 * seven texels of 0.707 cover the range, and one is for the shift; its center, 7.5, goes to 11
 * texels, 7.778. The map covers 4.950 to 10.606; the range 5.2 to 10 gives the same map. */
static void snap(int size, Reach *reach)
{
    const double least = 2 * reach->half / (size - 1);
    const double texel = exp2(ceil(steps * log2(least)) / steps);
    reach->middle = round(reach->middle / texel) * texel;
    reach->half = texel * size / 2;
}

/* Fits a view to the extent of a cascade along two axes, or to all shadow casters. */
static void fit_box(const Fit *fit, const SceneLight *light, const double (*shown)[2],
                    ShadowView *view)
{
    double axes[3][3], ranges[3][2], most = 1e-30;
    memcpy(axes[2], light->direction, sizeof axes[2]);
    scene_vector_axes(axes[2], axes[0], axes[1]);
    for (int i = 0; i < 3; i++) {
        range_of(fit, axes[i], ranges[i]);
        most = fmax(most, ranges[i][1] - ranges[i][0]);
    }
    for (int i = 0; i < 2; i++) {
        const double low = shown ? fmax(ranges[i][0], shown[i][0]) : ranges[i][0];
        const double high = shown ? fmin(ranges[i][1], shown[i][1]) : ranges[i][1];
        Reach reach = {(low + high) / 2, fmax((high - low) / 2, 1e-4 * most) * widened(fit->scene)};
        if (shown)
            snap(fit->scene->shadow_size, &reach);
        set_row(axes[i], 1 / reach.half, (double[]){0, 0, 0}, view->rows[i]);
        view->rows[i][3] = -reach.middle / reach.half;
        view->texel = fmax(view->texel, 2 * reach.half / fit->scene->shadow_size);
    }
    const double deep = 2 * fmax(ranges[2][1] - ranges[2][0], 1e-4 * most);
    set_row(axes[2], -1 / deep, (double[]){0, 0, 0}, view->rows[2]);
    view->rows[2][3] = 1 + ranges[2][0] / deep;
    view->mirrored = true;
}

/* Finds the nearest and farthest depth at which the camera can see a shadow caster. */
static void depths_of(const Fit *fit, double depths[2])
{
    const SceneCamera *camera = &fit->scene->camera;
    const double least = camera->kind == SCENE_Perspective ? camera->near : 0,
                 at = vec3_dot(camera->back, camera->position);
    depths[0] = INFINITY;
    depths[1] = -INFINITY;
    for (int i = 0; i < fit->count; i++) {
        const double depth = at - vec3_dot(camera->back, fit->corners[i]);
        depths[0] = fmin(depths[0], depth);
        depths[1] = fmax(depths[1], depth);
    }
    depths[0] = fmax(depths[0], fmax(least, 1e-6 * fabs(depths[1])));
    depths[1] = fmax(depths[1], depths[0] * (1 + 1e-6));
}

/* Sets a corner, 0 to 3, of the view frustum's section at a depth. */
static void corner_of(const Fit *fit, double depth, int number, double corner[3])
{
    const SceneCamera *camera = &fit->scene->camera;
    const double shorter = fmin(fit->size[0], fit->size[1]);
    const double reach = camera->half / shorter * (camera->kind == SCENE_Perspective ? depth : 1);
    const double right = (number & 1 ? 1 : -1) * reach * fit->size[0],
                 up = (number & 2 ? 1 : -1) * reach * fit->size[1];
    for (int i = 0; i < 3; i++)
        corner[i] = camera->position[i] - depth * camera->back[i] + right * camera->right[i] +
                    up * camera->up[i];
}

/* Finds the extent of the frustum between two depths along two axes perpendicular to the light. */
static void find_shown(const Fit *fit, const SceneLight *light, const double depths[2],
                       double shown[2][2])
{
    double axes[2][3], corner[3];
    scene_vector_axes(light->direction, axes[0], axes[1]);
    for (int axis = 0; axis < 2; axis++) {
        shown[axis][0] = INFINITY;
        shown[axis][1] = -INFINITY;
        for (int i = 0; i < CORNERS; i++) {
            corner_of(fit, depths[i / 4], i % 4, corner);
            const double along = vec3_dot(axes[axis], corner);
            shown[axis][0] = fmin(shown[axis][0], along);
            shown[axis][1] = fmax(shown[axis][1], along);
        }
    }
}

/* Fits cascades to the visible depth range. Four cascades of a visible depth range from 1 to 64
 * end at 4, 16, 64, and the last contains all objects. For a smaller range the ratio is smaller:
 * from 1 to 8 they end at 2, 4, 8. Points outside all of these use the last one. */
static void fit_cascades(const Fit *fit, const SceneLight *light, ShadowView *views)
{
    const int seen = fit->scene->shadow_cascades - 1;
    double depths[2], shown[2][2];
    depths_of(fit, depths);
    const double step = fmin(coarser, pow(depths[1] / depths[0], 1.0 / fmax(seen, 1)));
    for (int i = 0; i < seen; i++) {
        const double part[2] = {depths[0], fmax(depths[1] * pow(step, i + 1 - seen), depths[0])};
        find_shown(fit, light, part, shown);
        fit_box(fit, light, (const double(*)[2])shown, &views[i]);
    }
    fit_box(fit, light, NULL, &views[seen]);
}

/* -- area */

/* Fits the views of an area light's points, with one near distance. */
static void fit_area(Fit *fit, int number)
{
    const SceneLight *light = &fit->scene->lights[number];
    const int first = fit->made->count, count = soft_views_count(fit->scene, light);
    double near = INFINITY, position[3];
    for (int i = 0; i < count; i++) {
        soft_views_place(fit->scene, light, i, position);
        near = fmin(near, near_of(fit, position));
    }
    for (int i = 0; i < count; i++) {
        soft_views_make(fit->scene, light, i, near, &fit->made->views[first + i]);
        fit->made->views[first + i].method = shadow_method_of(fit->methods, light);
    }
    fit->made->lights[number] = (ShadowLight){first, count};
    fit->made->count += count;
}

static void fit_light(Fit *fit, int number)
{
    const SceneLight *light = &fit->scene->lights[number];
    ShadowView *views = fit->made->views + fit->made->count;
    const LightFrom from = light_from(light);
    const ShadowMethod *method = shadow_method_of(fit->methods, light);
    const bool cube = light_kind_is_wide(light);
    if (!method || (method->even && !fit->varying))
        return;
    if (from == LIGHT_FROM_extent) {
        fit_area(fit, number);
        return;
    }
    if (cube)
        fit_cube(fit, light, views);
    else if (from == LIGHT_FROM_point)
        fit_cone(fit, light, views);
    else if (method->single)
        fit_box(fit, light, NULL, views);
    else
        fit_cascades(fit, light, views);
    const int flat = from == LIGHT_FROM_point || method->single ? 1 : fit->scene->shadow_cascades;
    fit->made->lights[number] = (ShadowLight){fit->made->count, cube ? SHADOW_VIEWS_CUBE : flat};
    for (int i = 0; i < fit->made->lights[number].count; i++) {
        views[i].method = method;
        views[i].crossed = method->crossed && method->crossed(fit->scene);
    }
    fit->made->count += fit->made->lights[number].count;
}

/* Returns the max number of views. */
static size_t capacity_for(const Scene *scene)
{
    size_t capacity = 1;
    for (int i = 0; i < scene->light_count; i++)
        capacity += (size_t)soft_views_count(scene, &scene->lights[i]) + SHADOW_VIEWS_CUBE;
    return capacity;
}

int shadow_views_varying(const GpuScene *gpu_scene)
{
    int count = 0;
    for (int i = 0; i < gpu_scene->place_count; i++)
        count += gpu_scene->places[i].caster >= 0 && !gpu_scene->places[i].even;
    return count;
}

bool shadow_views_make(const ShadowMethod *const *methods, const Scene *scene,
                       const GpuScene *gpu_scene, const int size[2], ShadowViews *made)
{
    Fit fit = {.methods = methods,
               .scene = scene,
               .made = made,
               .size = size,
               .varying = shadow_views_varying(gpu_scene) > 0};
    const size_t lights = (size_t)scene->light_count + 1;
    made->count = 0;
    made->views = calloc(capacity_for(scene), sizeof *made->views);
    made->lights = calloc(lights, sizeof *made->lights);
    fit.corners = calloc((size_t)gpu_scene->place_count * CORNERS + 1, sizeof *fit.corners);
    const bool done = made->views && made->lights && fit.corners;
    for (int i = 0; done && i < gpu_scene->place_count; i++)
        add_corners(&fit, &gpu_scene->boxes[gpu_scene->places[i].mesh],
                    &scene->objects[gpu_scene->places[i].object].world_from_local);
    for (int i = 0; done && fit.count && i < scene->light_count; i++)
        fit_light(&fit, i);
    free(fit.corners);
    if (!done)
        shadow_views_free(made);
    return done;
}

void shadow_views_free(ShadowViews *views)
{
    free(views->views);
    free(views->lights);
    *views = (ShadowViews){0};
}

CullVolume shadow_views_volume(const ShadowView *view)
{
    CullVolume volume = {.count = 4};
    for (int i = 0; i < volume.count; i++) {
        double *plane = volume.planes[i];
        for (int k = 0; k < 4; k++) {
            const double far = view->near > 0 ? view->rows[2][k] : k == 3;
            plane[k] = far + (i % 2 ? 1 : -1) * view->rows[i / 2][k];
        }
        const double length = sqrt(vec3_dot(plane, plane));
        for (int k = 0; k < 4; k++)
            plane[k] /= length;
        volume.terms[i] = fabs(plane[3]);
    }
    return volume;
}
