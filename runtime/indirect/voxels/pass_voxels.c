/* The pass voxels: fills the slice map with all opaque objects except infinite planes. The map
 * is kept until objects move. Bodies flip bits by the driver's exclusive or, in waves of bodies
 * that do not overlap; surfaces set bits along each axis; both are merged, then coarser levels
 * and bricks are built. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include <stdio.h>
#include <stdlib.h>

/* Start offsets of rays (voxel_map.glsl). tests/renderer/indirect/test_frame_voxel_open.c has
 * the table from which they were chosen. */
#define OFF_BODIES   .5f
#define OFF_SURFACES .9f

enum { WITHIN_UNIT, SURFACE_UNIT, WORD = 32, LAYER = 128 };

bool pass_voxels_needed(const Renderer *renderer)
{
    return voxels_view_level(renderer->options.view) >= 0 || indirect_reads_voxels(renderer);
}

/* -- textures and programs */

static GLuint make_texture(Renderer *renderer, GLenum format, int layers, int levels)
{
    const GlContext *gl = renderer->gl;
    const int size = renderer->voxels->grid.size;
    const GLenum components = format == GL_R32UI ? GL_RED_INTEGER : GL_RGBA_INTEGER;
    GLuint made = 0;
    gl->GenTextures(1, &made);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, made);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER,
                      levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (int level = 0; level < levels; level++)
        gl->TexImage3D(GL_TEXTURE_2D_ARRAY, level, (GLint)format, size >> level, size >> level,
                       layers, 0, components, GL_UNSIGNED_INT, NULL);
    return made;
}

static bool make_textures(Renderer *renderer)
{
    FrameVoxels *voxels = renderer->voxels;
    const int size = voxels->grid.size;
    voxels->layers = (size + LAYER - 1) / LAYER;
    voxels->levels = 1;
    while (voxels_view_level(renderer->options.view) >= 0 && size >> voxels->levels > 0)
        voxels->levels++;
    voxels->within = make_texture(renderer, GL_RGBA32UI, voxels->layers, 1);
    voxels->surface = make_texture(renderer, GL_R32UI, size / WORD, 1);
    voxels->map = make_texture(renderer, GL_RGBA32UI, voxels->layers, voxels->levels);
    renderer->gl->GenFramebuffers(1, &voxels->framebuffer);
    return gl_check(renderer->gl, "making room for voxels");
}

/* Makes a program. With `casts` it draws objects, otherwise all texels. */
static bool make_program(Renderer *renderer, const char *text, bool casts, Material *made)
{
    const char *const version = renderer->gl->major * 10 + renderer->gl->minor >= 45
                                    ? "#version 450 core\n"
                                    : "#version 430 core\n";
    char defined[64];
    snprintf(defined, sizeof defined, "#define VOXEL_SIZE %d\n#define VOXEL_LAYERS %d\n",
             renderer->voxels->grid.size, renderer->voxels->layers);
    ProgramText program = {.fragment = {version, defined, text}, .vertex = {version}};
    program.vertex[1] = !casts                          ? screen_text
                        : renderer->gpu_scene.instances ? "#define INSTANCES\n"
                                                        : "";
    program.vertex[2] = casts ? render_text_shadow_depth : "";
    return material_make(renderer->store, NULL, &program, made);
}

static bool make_programs(Renderer *renderer)
{
    FrameVoxels *voxels = renderer->voxels;
    if (!make_program(renderer, render_text_voxel_flip, true, &voxels->flip) ||
        !make_program(renderer, render_text_voxel_touch, true, &voxels->touch) ||
        !make_program(renderer, render_text_voxel_merge, false, &voxels->merge) ||
        !make_program(renderer, render_text_voxel_above, false, &voxels->above))
        return false;
    material_set_number(&voxels->merge, "voxel_within", WITHIN_UNIT);
    material_set_number(&voxels->merge, "voxel_surface", SURFACE_UNIT);
    return true;
}

static bool pass_voxels_make(Renderer *renderer)
{
    FrameVoxels *voxels = renderer->voxels;
    if (!transparency_has_lists(renderer->gl))
        return gl_fail(renderer->gl, "voxels take OpenGL 4.3, and the driver has %d.%d",
                       renderer->gl->major, renderer->gl->minor);
    voxels->grid = voxel_grid(renderer->scene, &renderer->gpu_scene);
    if (!voxel_bodies_measure(renderer, voxels) || !voxel_bodies_sort(renderer, voxels))
        return gl_fail(renderer->gl, "out of memory");
    return make_textures(renderer) && make_programs(renderer) &&
           (!renderer->compute || voxel_fine_make(renderer)) && voxel_bricks_make(renderer);
}

/* -- drawing */

/* Attaches `count` layers of a texture's level, from `first` on, as draw buffers. */
static void use_layers(const Renderer *renderer, GLuint texture, int level, int first, int count)
{
    static const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                     GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};
    const GlContext *gl = renderer->gl;
    const int size = renderer->voxels->grid.size >> level;
    gl->BindFramebuffer(GL_FRAMEBUFFER, renderer->voxels->framebuffer);
    for (int i = 0; i < VOXELS_LAYERS_MAX; i++)
        gl->FramebufferTextureLayer(GL_FRAMEBUFFER, buffers[i], i < count ? texture : 0, level,
                                    i < count ? first + i : 0);
    gl->DrawBuffers(count, buffers);
    gl->Viewport(0, 0, size, size);
}

/* Draws the objects of a wave along an axis; with material NULL the alpha-tested ones, by their
 * own programs. */
static void cast(Renderer *renderer, int axis, int wave, Material *material)
{
    static const CullVolume all = {.count = 0};
    const GpuSceneSource source = frame_source(renderer);
    double clip[16];
    voxel_grid_clip(&renderer->voxels->grid, axis, renderer->zero_to_one, clip);
    gpu_scene_cast(renderer->gl, &source, &renderer->gpu_scene,
                   &(GpuSceneLight){.clip_from_world = clip,
                                    .volume = &all,
                                    .solid = material,
                                    .waves = renderer->voxels->waves,
                                    .wave = wave,
                                    .cut = !material},
                   false);
}

static void draw_within(Renderer *renderer, int wave)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    use_layers(renderer, voxels->within, 0, 0, voxels->layers);
    for (int layer = 0; layer < voxels->layers; layer++)
        gl->ClearBufferuiv(GL_COLOR, layer, (const GLuint[4]){0});
    if (!voxel_bodies_has(voxels, &renderer->gpu_scene, wave))
        return;
    gl->Enable(GL_COLOR_LOGIC_OP);
    gl->LogicOp(GL_XOR);
    cast(renderer, 2, wave, &voxels->flip);
    gl->LogicOp(GL_COPY);
    gl->Disable(GL_COLOR_LOGIC_OP);
}

static bool has_surfaces(const Renderer *renderer)
{
    return voxel_bodies_has(renderer->voxels, &renderer->gpu_scene, 0) ||
           voxel_bodies_has(renderer->voxels, &renderer->gpu_scene, VOXELS_FINE);
}

static void tell_cut(Renderer *renderer, int axis)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (gpu_scene->places[i].cut >= 0)
            material_set_number(&gpu_scene->casters[gpu_scene->places[i].cut].material,
                                "voxel_axis", (float)axis);
}

static void draw_surface(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    const int words = voxels->grid.size / WORD;
    for (int first = 0; first < words; first += VOXELS_LAYERS_MAX) {
        const int count = words - first < VOXELS_LAYERS_MAX ? words - first : VOXELS_LAYERS_MAX;
        use_layers(renderer, voxels->surface, 0, first, count);
        for (int layer = 0; layer < count; layer++)
            gl->ClearBufferuiv(GL_COLOR, layer, (const GLuint[4]){0});
    }
    if (!has_surfaces(renderer))
        return;
    /* the attached layer only defines the framebuffer's size */
    use_layers(renderer, voxels->within, 0, 0, 1);
    gl->DrawBuffers(1, (const GLenum[]){GL_NONE});
    gl->BindImageTexture(0, voxels->surface, 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
    for (int axis = 0; axis < 3; axis++) {
        material_set_number(&voxels->touch, "voxel_axis", (float)axis);
        cast(renderer, axis, 0, &voxels->touch);
        tell_cut(renderer, axis);
        cast(renderer, axis, 0, NULL);
    }
    voxel_fine_draw(renderer);
    gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

static void bind(const GlContext *gl, GLuint texture, int unit)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, texture);
}

/* Merges a wave into the map: the first wave replaces the map, with surfaces; later ones are
 * added by a bitwise or. */
static void merge(Renderer *renderer, int wave)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    use_layers(renderer, voxels->map, 0, 0, voxels->layers);
    bind(gl, voxels->within, WITHIN_UNIT);
    bind(gl, voxels->surface, SURFACE_UNIT);
    material_use(&voxels->merge);
    if (wave > 1) {
        gl->Enable(GL_COLOR_LOGIC_OP);
        gl->LogicOp(GL_OR);
    }
    screen_draw(gl, &renderer->screen);
    gl->LogicOp(GL_COPY);
    gl->Disable(GL_COLOR_LOGIC_OP);
}

/* Builds the coarser levels. Base and max level restrict reads to the level below the one drawn
 * to. */
static void draw_levels(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    bind(gl, voxels->map, 0);
    for (int level = 1; level < voxels->levels; level++) {
        gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level - 1);
        gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level - 1);
        use_layers(renderer, voxels->map, level, 0, voxels->layers);
        material_use(&voxels->above);
        screen_draw(gl, &renderer->screen);
    }
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, 0);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, voxels->levels - 1);
}

static void pass_voxels_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    if (renderer->voxels->drawn)
        return;
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    draw_surface(renderer);
    for (int wave = 1; wave == 1 || wave <= renderer->voxels->wave_count; wave++) {
        draw_within(renderer, wave);
        merge(renderer, wave);
    }
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    draw_levels(renderer);
    voxel_bricks_draw(renderer);
    renderer->voxels->drawn = true;
}

void pass_voxels_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    const SceneCamera *camera = &renderer->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    const VoxelGrid *grid = &renderer->voxels->grid;
    float matrix[16] = {0};
    for (int column = 0; column < 4; column++)
        for (int k = 0; k < 3; k++)
            matrix[4 * column + k] =
                (float)((column < 3 ? axes[column][k] : camera->position[k] - grid->low[k]) /
                        grid->edge);
    matrix[15] = 1;
    material_set_number(&pass->material, "voxel_off",
                        has_surfaces(renderer) ? OFF_SURFACES : OFF_BODIES);
    screen_pass_sampler(pass, "voxel_bricks", unit);
    material_set_number(&pass->material, "voxel_size", (float)grid->size);
    material_set(&pass->material, &(MaterialValue){"voxel_from_eye", 16, matrix});
}

void pass_voxels_forget(Renderer *renderer)
{
    for (int i = 0; i < renderer->gpu_scene.place_count; i++)
        renderer->voxels->drawn &= renderer->gpu_scene.places[i].cut < 0;
}

bool pass_voxels_by_time(const Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    bool is = false;
    for (int i = 0; i < gpu_scene->caster_count; i++)
        is |= spaces_by_time(&gpu_scene->casters[i].material);
    return is;
}

static void pass_voxels_forget_time(Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (gpu_scene->places[i].cut >= 0)
            renderer->voxels->drawn &=
                !spaces_by_time(&gpu_scene->casters[gpu_scene->places[i].cut].material);
}

/* Fits the grid to moved objects, which may lie outside it or be smaller than a voxel. */
static bool pass_voxels_change(Renderer *renderer)
{
    if (!renderer->voxels->map)
        return true;
    renderer->voxels->grid = voxel_grid(renderer->scene, &renderer->gpu_scene);
    if (!voxel_bodies_sort(renderer, renderer->voxels))
        return gl_fail(renderer->gl, "out of memory");
    renderer->voxels->drawn = false;
    return true;
}

static void pass_voxels_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    Material *materials[] = {&voxels->flip, &voxels->touch, &voxels->fine, &voxels->merge,
                             &voxels->above};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++)
        if (materials[i]->store)
            material_delete(materials[i]);
    voxel_bricks_delete(renderer);
    gl->DeleteFramebuffers(1, &voxels->framebuffer); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &voxels->fine_places);
    gl->DeleteTextures(1, &voxels->within);
    gl->DeleteTextures(1, &voxels->surface);
    gl->DeleteTextures(1, &voxels->map);
    free(voxels->shapes);
    free(voxels->waves);
    free(voxels->fine_rows);
    *voxels = (FrameVoxels){.layers = 0};
}

static bool pass_voxels_changed(Renderer *renderer, unsigned what)
{
    if (what & RENDERER_TIME)
        pass_voxels_forget_time(renderer);
    return true;
}

static bool pass_voxels_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    return pass_voxels_change(renderer);
}

const FramePass pass_voxels = {
    .plan = {"voxels", .fills = FRAME_BIT(voxels)},
    .when = "voxels are looked at; once, then they are kept",
    .needed = pass_voxels_needed,
    .make = pass_voxels_make,
    .draw = pass_voxels_draw,
    .changed = pass_voxels_changed,
    .moved = pass_voxels_moved,
    .forget = pass_voxels_delete,
};
