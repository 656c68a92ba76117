/* Table of the views that need a mapping to [0, 1]. */
#include "runtime/viewer/view_look.h"
#include "runtime/viewer/slot.h"
#include <math.h>
#include <string.h>

typedef void Show(const SceneCamera *camera, float rgba[4]);

struct ViewLook {
    const char *view;
    bool color;
    Show *show; /* maps one pixel */
};

/* Returns the distance along the view axis from the stored depth: near / distance for a
 * perspective camera, 1 - distance / depth for an orthographic one. The background, stored as 0,
 * is infinitely far. */
static double distance_of(const SceneCamera *camera, double stored)
{
    if (!(stored > 0))
        return INFINITY;
    return camera->kind == SCENE_Orthographic ? camera->depth * (1 - stored)
                                              : camera->near / stored;
}

/* Shows depth as T^2 / (T^2 + d^2), with T the distance from the camera to its target: white at
 * the camera, 0.5 at the target (where the slope over ln d is steepest), black at infinity. The
 * result depends on no other pixel, so tiles match and frames of a motion do not flicker. */
static void show_depth(const SceneCamera *camera, float rgba[4])
{
    double way[3], square = 0;
    for (int i = 0; i < 3; i++) {
        way[i] = camera->target[i] - camera->position[i];
        square += way[i] * way[i];
    }
    const double distance = distance_of(camera, rgba[0]);
    const double shown = isinf(distance) ? 0 : square / (square + distance * distance);
    for (int component = 0; component < 3; component++)
        rgba[component] = (float)shown;
}

/* Shows radiance as sRGB, clamped at 1. */
static void show_light(const SceneCamera *camera, float rgba[4])
{
    (void)camera;
    for (int component = 0; component < 3; component++)
        rgba[component] = (float)slot_encoded(rgba[component]);
}

static void show_direction(const SceneCamera *camera, float rgba[4])
{
    (void)camera;
    for (int component = 0; component < 3; component++)
        rgba[component] = .5f + .5f * rgba[component];
}

static const ViewLook looks[] = {{"depth", false, show_depth},
                                 {"light", true, show_light},
                                 {"indirect", true, show_light},
                                 {"bent", false, show_direction}};

const ViewLook *view_look_find(const char *view)
{
    for (size_t i = 0; view && i < sizeof looks / sizeof *looks; i++)
        if (!strcmp(looks[i].view, view))
            return &looks[i];
    return NULL;
}

bool view_look_is_color(const ViewLook *look) { return look->color; }

void view_look_show(const ViewLook *look, const SceneCamera *camera, float *rgba, size_t pixels)
{
    for (size_t i = 0; i < pixels; i++)
        look->show(camera, rgba + 4 * i);
}
