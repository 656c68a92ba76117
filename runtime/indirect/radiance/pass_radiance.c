/* The pass radiance: fills the radiance cache (radiance.h) with direct light, by voxel and side.
 * Objects that fill voxels are drawn from six sides by their own programs, three times each: to
 * find nodes, to find the nearest fragment of each, to store that fragment's surface. Then all
 * nodes are lit. */
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/lighting.h"
#include "runtime/shadow/shadow.h"

enum { FACES_BINDING = 2, NODES_BINDING = 4, KEPT_BINDING = 5, GROUP = 64, GROUPS_ACROSS = 4096 };
enum { STEP_sides, STEP_nearest, STEP_keep };

/* -- surfaces */

/* Clip space of a side: depth is reversed when the scene is viewed from the axis's upper end. */
static void clip_of(const Renderer *renderer, int side, double clip[16])
{
    voxel_grid_clip(&renderer->voxels->grid, side / 2, renderer->zero_to_one, clip);
    for (int column = 0; column < 4 && side % 2; column++)
        clip[4 * column + 2] = (column == 3 && renderer->zero_to_one) - clip[4 * column + 2];
}

/* Draws one kind of places from a side. Cyclic axes with depth away from the eye form a mirrored
 * basis. */
static void cast(Renderer *renderer, int side, RadianceCast kind, bool cut)
{
    static const CullVolume all = {.count = 0};
    const GpuSceneSource source = frame_source(renderer);
    double clip[16];
    clip_of(renderer, side, clip);
    gpu_scene_cast(renderer->gl, &source, &renderer->gpu_scene,
                   &(GpuSceneLight){.clip_from_world = clip,
                                    .volume = &all,
                                    .mirrored = side % 2 == 0,
                                    .kept = renderer->radiance->keepers,
                                    .waves = renderer->radiance->casts,
                                    .wave = kind,
                                    .cut = cut},
                   false);
}

static void tell(Renderer *renderer, const char *name, int number)
{
    FrameRadiance *radiance = renderer->radiance;
    for (int i = 0; i < radiance->keeper_count; i++)
        if (radiance->keepers[i].store)
            material_set_number(&radiance->keepers[i], name, (float)number);
}

static void wait(const Renderer *renderer)
{
    renderer->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                                GL_TEXTURE_FETCH_BARRIER_BIT);
}

/* Draws all nodes' surfaces. Only front faces of closed meshes count: a back face would send
 * light inside, and let its rays leave through a thin wall. The map's texture defines the
 * framebuffer's size. */
static void draw_surfaces(Renderer *renderer, int step)
{
    const GlContext *gl = renderer->gl;
    const FrameRadiance *radiance = renderer->radiance;
    gl->BindFramebuffer(GL_FRAMEBUFFER, radiance->framebuffer);
    gl->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, renderer->voxels->within, 0,
                                0);
    gl->DrawBuffers(1, (const GLenum[]){GL_NONE});
    gl->Viewport(0, 0, radiance->size, radiance->size);
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    tell(renderer, "radiance_step", step);
    for (int side = 0; side < RADIANCE_SIDES; side++) {
        tell(renderer, "radiance_side", side);
        for (int kind = 0; kind < RADIANCE_CASTS; kind++) {
            tell(renderer, "radiance_body", kind == RADIANCE_body);
            (kind == RADIANCE_surface ? gl->Disable : gl->Enable)(GL_CULL_FACE);
            cast(renderer, side, kind, false);
            if (kind == RADIANCE_surface)
                cast(renderer, side, kind, true);
        }
    }
    gl->Disable(GL_CULL_FACE);
    if (renderer->zero_to_one)
        gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    wait(renderer);
}

static void clear(const Renderer *renderer, size_t from, size_t words)
{
    const GlContext *gl = renderer->gl;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, renderer->radiance->faces);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, (GLintptr)(from * sizeof(GLuint)),
                           (GLsizeiptr)(words * sizeof(GLuint)), GL_RED_INTEGER, GL_UNSIGNED_INT,
                           NULL);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

static void bind(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, FACES_BINDING, renderer->radiance->faces);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, NODES_BINDING, renderer->radiance->nodes);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, KEPT_BINDING, renderer->radiance->kept);
}

/* Runs at least `count` invocations, in a rectangle of groups. */
static void dispatch(const Renderer *renderer, size_t count)
{
    const size_t groups = (count + GROUP - 1) / GROUP,
                 across = groups < GROUPS_ACROSS ? groups : GROUPS_ACROSS;
    if (groups)
        renderer->gl->DispatchCompute((GLuint)across, (GLuint)((groups + across - 1) / across), 1);
    wait(renderer);
}

/* Numbers the nodes and returns how many there are. */
static GLuint number_nodes(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameRadiance *radiance = renderer->radiance;
    const size_t size = (size_t)radiance->size;
    const GLuint head[RADIANCE_HEAD] = {[RADIANCE_CAPACITY] = radiance->capacity};
    GLuint counted[RADIANCE_HEAD] = {0};
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, radiance->faces);
    gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof head, head);
    bind(renderer);
    material_set_number(&radiance->number, "radiance_size", (float)size);
    material_use(&radiance->number);
    dispatch(renderer, size * size * size);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, radiance->faces);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof counted, counted);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return counted[RADIANCE_COUNT];
}

/* Finds and numbers the nodes. While they do not fit, voxels are doubled in size, which have
 * fewer nodes. */
static void find_nodes(Renderer *renderer)
{
    FrameRadiance *radiance = renderer->radiance;
    for (;; radiance->size /= 2) {
        const size_t size = (size_t)radiance->size;
        tell(renderer, "radiance_size", radiance->size);
        clear(renderer, 0, RADIANCE_HEAD + size * size * size);
        bind(renderer);
        draw_surfaces(renderer, STEP_sides);
        radiance->count = number_nodes(renderer);
        if (radiance->count <= radiance->capacity)
            return;
        if (radiance_make_capacity(renderer, radiance->count)) {
            number_nodes(renderer);
            return;
        }
    }
}

/* -- light */

static void set_eye(Renderer *renderer)
{
    const VoxelGrid *grid = &renderer->voxels->grid;
    const double *eye = renderer->space.eye_from_world;
    const double edge = grid->edge * grid->size / renderer->radiance->size;
    float matrix[16];
    for (int row = 0; row < 4; row++) {
        double last = eye[12 + row];
        for (int column = 0; column < 3; column++) {
            matrix[4 * column + row] = (float)(eye[4 * column + row] * edge);
            last += eye[4 * column + row] * grid->low[column];
        }
        matrix[12 + row] = (float)last;
    }
    material_set(&renderer->radiance->light.material, &(MaterialValue){"radiance_eye", 16, matrix});
}

static void light_nodes(Renderer *renderer)
{
    ScreenPass *light = &renderer->radiance->light;
    set_eye(renderer);
    radiance_set(renderer, 0, light);
    pass_voxels_set(renderer, LIGHTING_FREE_UNIT, light);
    for (int part = 0; part < shadow_parts_number(renderer); part++) {
        shadow_parts_load(renderer, part);
        lighting_bind(renderer, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
        voxel_bricks_bind(renderer, LIGHTING_FREE_UNIT);
        bind(renderer);
        material_use(&light->material);
        dispatch(renderer, renderer->radiance->count);
    }
}

/* Traces further bounces. The textures are on the first units. */
static void bounce_nodes(Renderer *renderer)
{
    enum { VOXEL_UNIT, RADIANCE_UNIT };
    ScreenPass *bounce = &renderer->radiance->bounce;
    const double radius = voxel_grid_radius(renderer->scene, &renderer->gpu_scene);
    if (!bounce->material.store)
        return;
    pass_voxels_set(renderer, VOXEL_UNIT, bounce);
    radiance_set(renderer, RADIANCE_UNIT, bounce);
    material_set_number(&bounce->material, "bounce_far",
                        (float)(radius / renderer->voxels->grid.edge));
    voxel_bricks_bind(renderer, VOXEL_UNIT);
    radiance_bind(renderer, RADIANCE_UNIT);
    bind(renderer);
    for (int i = 1; i < renderer->scene->indirect.bounces; i++)
        for (int step = 0; step < 2; step++) {
            material_set_number(&bounce->material, "bounce_step", (float)step);
            material_use(&bounce->material);
            dispatch(renderer, renderer->radiance->count);
        }
}

/* -- */

static bool pass_radiance_make(Renderer *renderer) { return radiance_make(renderer); }

static void pass_radiance_draw(Renderer *renderer)
{
    FrameRadiance *radiance = renderer->radiance;
    if (radiance->drawn)
        return;
    radiance_sort(renderer);
    find_nodes(renderer);
    bind(renderer);
    draw_surfaces(renderer, STEP_nearest);
    draw_surfaces(renderer, STEP_keep);
    light_nodes(renderer);
    bounce_nodes(renderer);
    indirect_forget(renderer);
    radiance->drawn = true;
}

static bool pass_radiance_changed(Renderer *renderer, unsigned what)
{
    renderer->radiance->drawn &=
        !(what & RENDERER_LIGHTS) &&
        !(what & RENDERER_TIME && (pass_voxels_by_time(renderer) || radiance_by_time(renderer)));
    return lighting_changed(renderer, what, &renderer->radiance->light);
}

static bool pass_radiance_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    renderer->radiance->drawn = false;
    return true;
}

const FramePass pass_radiance = {
    .plan = {"radiance", .reads = FRAME_BIT(voxels) | FRAME_BIT(shadow),
             .fills = FRAME_BIT(radiance)},
    .when = "indirect light uses off-screen surfaces; computed once, then cached",
    .needed = radiance_needed,
    .make = pass_radiance_make,
    .draw = pass_radiance_draw,
    .changed = pass_radiance_changed,
    .moved = pass_radiance_moved,
    .forget = radiance_delete,
};
