/* The pass cubes: a view of the voxels. Its GLSL is pass_cubes.glsl, after voxel_map.glsl and
 * voxel_walk.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/voxels/voxels.h"

static bool pass_cubes_needed(const Renderer *renderer)
{
    return voxels_view_level(renderer->options.view) >= 0;
}

static void set(Renderer *renderer, const char *name, const float values[4])
{
    material_set(&renderer->voxels->view.material, &(MaterialValue){name, 4, values});
}

static void pass_cubes_place(Renderer *renderer)
{
    static const char *const names[4] = {"cubes_right", "cubes_up", "cubes_back", "cubes_eye"};
    const SceneCamera *camera = &renderer->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    const VoxelGrid *grid = &renderer->voxels->grid;
    if (!renderer->voxels->view.material.store)
        return;
    screen_pass_sampler(&renderer->voxels->view, "voxel_slices", 0);
    material_set_number(&renderer->voxels->view.material, "voxel_size", (float)grid->size);
    for (int i = 0; i < 4; i++) {
        float components[4] = {0};
        for (int k = 0; k < 3; k++)
            components[k] =
                (float)((i < 3 ? axes[i][k] : camera->position[k] - grid->low[k]) / grid->edge);
        set(renderer, names[i], components);
    }
    set(renderer, "cubes_ray", renderer->space.ray);
    set(renderer, "cubes_view", renderer->space.depth);
}

static bool pass_cubes_make(Renderer *renderer)
{
    const int level = voxels_view_level(renderer->options.view);
    const ScreenPassText text = {
        .body = {render_text_voxel_map, render_text_voxel_walk, render_text_pass_cubes},
        .format = frame_format(renderer, FRAME_TARGET_cubes, 0),
        .compute = renderer->compute};
    if (level >= renderer->voxels->levels)
        return gl_fail(renderer->gl, "unknown view '%s': the last of %d voxels is voxels%d",
                       renderer->options.view, renderer->voxels->grid.size,
                       renderer->voxels->levels - 1);
    if (!screen_pass_make(renderer->store, &text, &renderer->voxels->view))
        return false;
    material_set_number(&renderer->voxels->view.material, "cubes_level", (float)level);
    pass_cubes_place(renderer);
    return true;
}

static void pass_cubes_draw(Renderer *renderer)
{
    renderer->gl->ActiveTexture(GL_TEXTURE0);
    renderer->gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->voxels->map);
    screen_pass_run(&renderer->voxels->view, &renderer->targets.draws[FRAME_DRAW_cubes],
                    &renderer->screen);
}

static void pass_cubes_delete(Renderer *renderer) { screen_pass_delete(&renderer->voxels->view); }

static bool pass_cubes_changed(Renderer *renderer, unsigned what)
{
    (void)what;
    pass_cubes_place(renderer);
    return true;
}

static bool pass_cubes_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    pass_cubes_place(renderer);
    return true;
}

const FramePass pass_cubes = {
    .plan = {"cubes", .reads = FRAME_BIT(voxels), .fills = FRAME_BIT(cubes)},
    .when = "voxels are looked at",
    .needed = pass_cubes_needed,
    .make = pass_cubes_make,
    .draw = pass_cubes_draw,
    .place = pass_cubes_place,
    .changed = pass_cubes_changed,
    .moved = pass_cubes_moved,
    .forget = pass_cubes_delete,
};
