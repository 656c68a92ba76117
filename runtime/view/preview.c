/* Builds the scene by hand: lamps stand in the eye's space, so that every shape is lit alike; a sky is looked at where it is brightest. */
#include "runtime/view/preview.h"
#include "compiler/evaluate.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

/* Towards the lamps, to the right, up and back: a warm key light, a cool fill, a rim from behind. */
static const struct {
    double way[3], light[3];
} lamps[PREVIEW_LAMPS] = {{{-.4968, .6211, .6062}, {.88, .84, .77}},
                          {{.8729, .0970, .4783}, {.15, .19, .25}},
                          {{.3651, .5477, -.7528}, {.42, .45, .5}}};

static const double above[3] = {.42, .44, .48}, below[3] = {.11, .104, .098};

/* The azimuth at which the material is brightest a little above the horizon, by the C reference. A direction that takes too long is no number, and
 * never the brightest. */
static double find_azimuth(const SceneMaterial *material, const MatcOptions *options)
{
    enum { STEPS = 72 };
    const double step = 6.283185307179586 / STEPS, height = 0.3;
    Surface surfaces[STEPS];
    SlotValues values[STEPS];
    double best = 0, azimuth = 0;
    for (int i = 0; i < STEPS; i++) {
        oracle_surface_default(&surfaces[i]);
        double *position = &surfaces[i].root[channel_id(GROUP_X, 0)];
        position[0] = cos(i * step);
        position[1] = sin(i * step);
        position[2] = height;
    }
    evaluate_material(material->document, material->index, options, (SurfacePoints){surfaces, STEPS}, values);
    for (int i = 0; i < STEPS; i++) {
        const double *rgb = values[i].lane[SLOT_emissive], bright = rgb[0] + rgb[1] + rgb[2];
        azimuth = bright > best ? i * step : azimuth;
        best = bright > best ? bright : best;
    }
    return azimuth;
}

static void add_lamp(const SceneCamera *camera, int lamp, SceneLight *light)
{
    const double *way = lamps[lamp].way;
    *light = (SceneLight){.kind = SCENE_Directional, .shadows = WORD_Shadows_none};
    memcpy(light->light, lamps[lamp].light, sizeof light->light);
    for (int i = 0; i < 3; i++)
        light->direction[i] = -(camera->right[i] * way[0] + camera->up[i] * way[1] + camera->back[i] * way[2]);
}

static void add_lights(Preview *p)
{
    SceneLight *around = &p->lights[PREVIEW_LAMPS];
    for (int i = 0; i < PREVIEW_LAMPS; i++)
        add_lamp(&p->scene.camera, i, &p->lights[i]);
    *around = (SceneLight){.kind = SCENE_Hemisphere, .direction = {0, 0, -1}, .shadows = WORD_Shadows_none};
    memcpy(around->light, above, sizeof above);
    memcpy(around->ground, below, sizeof below);
    p->scene.lights = p->lights;
    p->scene.light_count = PREVIEW_LAMPS + 1;
}

/* The shape stands where it is, so local space is the world. */
static bool add_object(const PreviewOptions *o, Preview *p)
{
    p->owns_mesh = !o->mesh;
    if (o->mesh)
        p->mesh.shape = *o->mesh;
    else if (!shape_make(o->shape, &p->mesh.shape))
        return false;
    p->mesh.path = o->mesh ? "" : shape_name(o->shape);
    p->object = (SceneObject){.kind = SCENE_Mesh, .world_from_local = scene_matrix_identity()};
    p->scene.objects = &p->object;
    p->scene.meshes = &p->mesh;
    p->scene.object_count = p->scene.mesh_count = 1;
    return true;
}

/* What is all around has no upper end; film has. */
static void be_sky(const MatcOptions *compile, Preview *p)
{
    p->scene.sky = 0;
    p->scene.tone = SCENE_Exponential;
    p->scene.exposure = .9;
    p->scene.camera = camera_for_sky(find_azimuth(&p->material, compile));
}

static bool be_object(const PreviewOptions *o, Preview *p)
{
    const double knee = .7;
    const Viewpoint viewpoint = o->camera ? *o->camera : camera_viewpoint_for(o->shape);
    p->scene.sky = -1;
    p->scene.tone = SCENE_Shoulder;
    p->scene.exposure = 1;
    p->scene.tone_numbers[0] = knee;
    p->scene.glow = p->scene.tiles = true;
    p->scene.camera = camera_at(&viewpoint);
    add_lights(p);
    return add_object(o, p);
}

bool preview_make(const PreviewOptions *options, SceneMaterial material, const MatcOptions *compile, Preview *made)
{
    *made = (Preview){.material = material};
    made->scene = (Scene){.time = compile->time,
                          .width = options->width,
                          .height = options->height,
                          .materials = &made->material,
                          .material_count = 1,
                          .shadow_size = 16,
                          .shadow_cascades = 1,
                          .tools = {.grid_cells = 10, .grid_step = 1, .axes_length = 1.5, .light_size = .5}};
    if (!options->sky)
        return be_object(options, made);
    be_sky(compile, made);
    return true;
}

void preview_free(Preview *preview)
{
    if (preview->owns_mesh)
        shape_free(&preview->mesh.shape);
    *preview = (Preview){0};
}
