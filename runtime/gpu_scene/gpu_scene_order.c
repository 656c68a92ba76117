/* Draw order of transparent objects into linked lists: far to near. A list begins with the
 * fragment appended last, so the lists of most pixels are sorted already, and pass_blend.glsl
 * only verifies their order. Any other order gives the same picture. */
#include "runtime/gpu_scene/gpu_scene.h"
#include <stdlib.h>

/* Returns the depth of the center of an object's box along the view; larger is nearer. */
static double nearness(const GpuSceneSource *source, const CullBox *box, int object)
{
    const double *eye = source->space->eye_from_world,
                 *world = source->scene->objects[object].world_from_local.m;
    double sum = eye[14];
    for (int row = 0; row < 3; row++) {
        double at = world[12 + row];
        for (int k = 0; k < 3; k++)
            at += world[4 * k + row] * (box->low[k] + box->high[k]) / 2;
        sum += eye[4 * row + 2] * at;
    }
    return sum;
}

static int farthest_first(const void *a, const void *b)
{
    const GpuSceneOrder *x = a, *y = b;
    if (x->nearness != y->nearness)
        return x->nearness < y->nearness ? -1 : 1;
    return x->place < y->place ? -1 : x->place > y->place;
}

void gpu_scene_order(const GpuSceneSource *source, GpuScene *gpu_scene, const Drawable *drawable,
                     uint32_t *list, int count)
{
    for (int i = 0; i < count; i++) {
        const int object = gpu_scene->places[list[i]].object;
        gpu_scene->order[i] =
            (GpuSceneOrder){nearness(source, &gpu_scene->boxes[drawable->mesh], object), list[i]};
    }
    qsort(gpu_scene->order, (size_t)count, sizeof *gpu_scene->order, farthest_first);
    for (int i = 0; i < count; i++)
        list[i] = gpu_scene->order[i].place;
}
