/* Motion vectors of objects since the last accumulated frame. A scene that accumulates frames
 * stores each object's matrix; visible objects that moved are drawn once more, as motion ids. If
 * nothing moves, none of this code runs. */
#include "runtime/indirect/filter/indirect_motion.h"
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_UNIT = 0 /* texture unit of samplers that are not set */ };

static bool make_number(Renderer *renderer, IndirectMotion *motion)
{
    const char *head = renderer->gl->major * 10 + renderer->gl->minor >= 45 ? "#version 450 core\n"
                                                                            : "#version 330 core\n";
    const ProgramText text = {.vertex = {head, render_text_shadow_depth},
                              .fragment = {head, render_text_indirect_motion}};
    return material_make(renderer->store, NULL, &text, &motion->number);
}

bool indirect_motion_make(Renderer *renderer)
{
    IndirectMotion *motion = &renderer->indirect->motion;
    const Scene *scene = renderer->scene;
    if (!scene->indirect.history)
        return true;
    motion->kept = malloc((size_t)scene->object_count * sizeof *motion->kept + 1);
    if (!motion->kept)
        return gl_fail(renderer->gl, "out of memory");
    motion->first = 0;
    motion->end = scene->object_count;
    indirect_motion_end(renderer);
    return true;
}

void indirect_motion_delete(Renderer *renderer)
{
    IndirectMotion *motion = &renderer->indirect->motion;
    free(motion->kept);
    material_delete(&motion->number);
    framebuffer_delete(renderer->gl, &motion->seen);
    *motion = (IndirectMotion){.kept = NULL};
}

void indirect_motion_add(Renderer *renderer, int first, int count)
{
    IndirectMotion *motion = &renderer->indirect->motion;
    if (!motion->kept || !count)
        return;
    const bool none = motion->first >= motion->end;
    motion->first = none || first < motion->first ? first : motion->first;
    motion->end = none || first + count > motion->end ? first + count : motion->end;
}

void indirect_motion_end(Renderer *renderer)
{
    IndirectMotion *motion = &renderer->indirect->motion;
    for (int i = motion->first; motion->kept && i < motion->end; i++)
        motion->kept[i] = renderer->scene->objects[i].world_from_local;
    motion->first = motion->end = 0;
}

/* -- boxes */

static const VoxelRange everywhere = {{-INFINITY, -INFINITY, -INFINITY},
                                      {INFINITY, INFINITY, INFINITY}};

static bool meet(const VoxelRange *a, const VoxelRange *b)
{
    for (int k = 0; k < 3; k++)
        if (a->low[k] > b->high[k] || b->low[k] > a->high[k])
            return false;
    return true;
}

/* Merges a box into the first box that overlaps it, or appends it; into the last box if the
 * array is full. */
static void add_box(const VoxelRange *added, VoxelRange *boxes, int *count)
{
    int i = 0;
    while (i < *count && !meet(added, &boxes[i]))
        i++;
    if (i == *count && *count < TEMPORAL_BOXES_MAX) {
        boxes[(*count)++] = *added;
        return;
    }
    VoxelRange *box = &boxes[i < *count ? i : *count - 1];
    for (int k = 0; k < 3; k++) {
        box->low[k] = fmin(box->low[k], added->low[k]);
        box->high[k] = fmax(box->high[k], added->high[k]);
    }
}

/* Returns the bounding box of an object in world space; that of a plane is infinite. */
static VoxelRange range_of(const Renderer *renderer, int object, const SceneMatrix *matrix)
{
    const int place = renderer->gpu_scene.place_of[object];
    VoxelRange range = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    if (place < 0)
        return everywhere;
    voxel_grid_add(&renderer->gpu_scene.boxes[renderer->gpu_scene.places[place].mesh], matrix,
                   &range);
    return range;
}

static void put_boxes(const VoxelRange *boxes, int count, float (*block)[4])
{
    block[TEMPORAL_COUNTS][0] = (float)count;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            block[TEMPORAL_BOXES + 2 * i][k] = (float)fmax(boxes[i].low[k], -1e30);
            block[TEMPORAL_BOXES + 2 * i + 1][k] = (float)fmin(boxes[i].high[k], 1e30);
        }
}

/* -- motions */

/* Translation of a box's center from one matrix to another, rotated into eye space. */
static void put_step(const double eye[16], const CullBox *box, const SceneMatrix *from,
                     const SceneMatrix *to, float step[4])
{
    double world[3];
    for (int k = 0; k < 3; k++) {
        world[k] = to->m[12 + k] - from->m[12 + k];
        for (int i = 0; i < 3; i++)
            world[k] += (to->m[4 * i + k] - from->m[4 * i + k]) * (box->low[i] + box->high[i]) / 2;
    }
    for (int k = 0; k < 3; k++)
        step[k] = (float)(eye[k] * world[0] + eye[4 + k] * world[1] + eye[8 + k] * world[2]);
}

/* columns = was_eye_from_world * was_world_from_local * local_from_world * world_from_eye.
 * Returns false if a matrix has no inverse. */
static bool find_motion(const Renderer *renderer, const double was[16], int object,
                        float (*columns)[4])
{
    SceneMatrix before, eye, local_from_world, world_from_eye;
    memcpy(before.m, was, sizeof before.m);
    memcpy(eye.m, renderer->space.eye_from_world, sizeof eye.m);
    if (!scene_matrix_invert(&renderer->scene->objects[object].world_from_local,
                             &local_from_world) ||
        !scene_matrix_invert(&eye, &world_from_eye))
        return false;
    const SceneMatrix left =
        scene_matrix_multiply(&before, &renderer->indirect->motion.kept[object]);
    const SceneMatrix right = scene_matrix_multiply(&local_from_world, &world_from_eye);
    const SceneMatrix all = scene_matrix_multiply(&left, &right);
    for (int i = 0; i < 16; i++)
        columns[i / 4][i % 4] = (float)all.m[i];
    return true;
}

static void draw_number(Renderer *renderer, int object, int number)
{
    Material *material = &renderer->indirect->motion.number;
    const SceneMatrix *world_from_local = &renderer->scene->objects[object].world_from_local;
    const GpuScenePlace *place = &renderer->gpu_scene.places[renderer->gpu_scene.place_of[object]];
    Spaces spaces = renderer->space.spaces;
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)world_from_local->m[i];
    spaces_set(&spaces, material);
    material_set_number(material, "motion_number", (float)number);
    material_use(material);
    mesh_draw(renderer->gl, &renderer->gpu_scene.meshes[place->mesh]);
}

/* Draws a visible object's motion id: the next one, or, if its motion cannot be stored, the id
 * one past the last, which marks an unknown motion. */
static void number_object(Renderer *renderer, const double was[16], int object, float (*block)[4])
{
    const int next = (int)block[TEMPORAL_COUNTS][1], place = renderer->gpu_scene.place_of[object];
    const SceneMatrix *matrix = &renderer->scene->objects[object].world_from_local;
    if (place < 0 || renderer->gpu_scene.places[place].transparent)
        return;
    const CullBox *box = &renderer->gpu_scene.boxes[renderer->gpu_scene.places[place].mesh];
    if (!cull_sees(&renderer->volume, box, matrix))
        return;
    const bool known = next < TEMPORAL_MOTIONS_MAX &&
                       find_motion(renderer, was, object, block + TEMPORAL_MOTIONS + 4 * next);
    if (known)
        put_step(was, box, matrix, &renderer->indirect->motion.kept[object],
                 block[TEMPORAL_STEPS + next]);
    block[TEMPORAL_COUNTS][1] += known;
    draw_number(renderer, object, known ? next + 1 : TEMPORAL_MOTIONS_MAX + 1);
}

static bool has_moved(const Renderer *renderer, int object)
{
    return memcmp(&renderer->indirect->motion.kept[object],
                  &renderer->scene->objects[object].world_from_local, sizeof(SceneMatrix)) != 0;
}

/* Makes the target of motion ids on first use, and clears it. */
static bool begin(Renderer *renderer, IndirectMotion *motion)
{
    static const GLuint none[4];
    const FramebufferSpec spec = {
        .width = renderer->size[0], .height = renderer->size[1], .color_count = 1};
    if (!motion->seen.name &&
        (!make_number(renderer, motion) ||
         !framebuffer_make_named(renderer->gl, &spec, (const char *const[]){"R32UI"},
                                 &motion->seen)))
        return false;
    surface_draw_begin(renderer, &motion->seen, GL_ALWAYS);
    renderer->gl->ClearBufferuiv(GL_COLOR, 0, none);
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_depth, 0), DEPTH_UNIT);
    return true;
}

bool indirect_motion_draw(Renderer *renderer, const double was[16], float (*block)[4])
{
    IndirectMotion *motion = &renderer->indirect->motion;
    VoxelRange boxes[TEMPORAL_BOXES_MAX];
    int count = 0;
    memset(block[TEMPORAL_COUNTS], 0, sizeof *block);
    for (int i = motion->first; motion->kept && i < motion->end; i++) {
        if (!has_moved(renderer, i))
            continue;
        if (!count && !begin(renderer, motion)) {
            /* without motion ids, the history of all pixels is suspect */
            boxes[count++] = everywhere;
            break;
        }
        const VoxelRange then = range_of(renderer, i, &motion->kept[i]);
        const VoxelRange now = range_of(renderer, i, &renderer->scene->objects[i].world_from_local);
        add_box(&then, boxes, &count);
        add_box(&now, boxes, &count);
        number_object(renderer, was, i, block);
    }
    if (count)
        surface_draw_end(renderer);
    put_boxes(boxes, count, block);
    return count > 0;
}
