/* The pass cubes: a view of the voxels. Its GLSL is pass_cubes.glsl, after voxel_map.glsl and
 * voxel_walk.glsl. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
#include "runtime/indirect/voxels/voxels.h"

static bool pass_cubes_needed(const Render *render)
{
    return voxels_view_level(render->options.view) >= 0;
}

static void set(Render *render, const char *name, const float values[4])
{
    material_set(&render->voxels->view.material, &(MaterialValue){name, 4, values});
}

static void pass_cubes_place(Render *render)
{
    static const char *const names[4] = {"cubes_right", "cubes_up", "cubes_back", "cubes_eye"};
    const SceneCamera *camera = &render->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    const VoxelGrid *grid = &render->voxels->grid;
    if (!render->voxels->view.material.store)
        return;
    screen_pass_sampler(&render->voxels->view, "voxel_slices", 0);
    material_set_number(&render->voxels->view.material, "voxel_size", (float)grid->size);
    for (int i = 0; i < 4; i++) {
        float lanes[4] = {0};
        for (int k = 0; k < 3; k++)
            lanes[k] =
                (float)((i < 3 ? axes[i][k] : camera->position[k] - grid->low[k]) / grid->edge);
        set(render, names[i], lanes);
    }
    set(render, "cubes_ray", render->space.ray);
    set(render, "cubes_view", render->space.depth);
}

static bool pass_cubes_make(Render *render)
{
    const int level = voxels_view_level(render->options.view);
    const ScreenPassText text = {
        .body = {render_text_voxel_map, render_text_voxel_walk, render_text_pass_cubes},
        .format = frame_format(render, FRAME_TARGET_cubes, 0),
        .compute = render->compute};
    if (level >= render->voxels->levels)
        return gl_fail(render->gl, "there is no view '%s': of %d voxels the last is voxels%d",
                       render->options.view, render->voxels->grid.size, render->voxels->levels - 1);
    if (!screen_pass_make(render->store, &text, &render->voxels->view))
        return false;
    material_set_number(&render->voxels->view.material, "cubes_level", (float)level);
    pass_cubes_place(render);
    return true;
}

static void pass_cubes_draw(Render *render)
{
    render->gl->ActiveTexture(GL_TEXTURE0);
    render->gl->BindTexture(GL_TEXTURE_2D_ARRAY, render->voxels->map);
    screen_pass_run(&render->voxels->view, &render->targets.draws[FRAME_DRAW_cubes],
                    &render->screen);
}

static void pass_cubes_delete(Render *render) { screen_pass_delete(&render->voxels->view); }

static bool pass_cubes_changed(Render *render, unsigned what)
{
    (void)what;
    pass_cubes_place(render);
    return true;
}

static bool pass_cubes_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    pass_cubes_place(render);
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
