/* Builds the preview scene directly. Lamps are fixed in view space, so every shape is lit alike.
 * A sky is viewed toward its brightest azimuth. For Phong materials the lamps are directional
 * lights. Microfacet materials reflect the lamp's shape, so each lamp is a square area light
 * with the same irradiance at the object's center. */
#include "runtime/viewer/preview.h"
#include "compiler/evaluate.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

/* Lamps: `way` points to the lamp in view space (right, up, back). A warm key light, a cool fill
 * light, and a rim light from behind. */
static const struct {
    double way[3], light[3], half; /* half the edge length of the square */
} lamps[PREVIEW_LAMPS] = {{{-.4968, .6211, .6062}, {.88, .84, .77}, 3.2},
                          {{.8729, .0970, .4783}, {.15, .19, .25}, 3.2},
                          {{.3651, .5477, -.7528}, {.42, .45, .5}, 2.4}};

static const double away = 4; /* distance of the squares' centers; the object's size is about 1 */
static const double above[3] = {.42, .44, .48}, below[3] = {.11, .104, .098};

/* Returns the azimuth at which the material is brightest slightly above the horizon, evaluated
 * by the C reference. A direction that exceeds the operation limit gives NaN and is never
 * chosen. */
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
    evaluate_material(material->document, material->index, options,
                      (SurfacePoints){surfaces, STEPS}, values);
    for (int i = 0; i < STEPS; i++) {
        const double *rgb = values[i].component[SLOT_emissive], bright = rgb[0] + rgb[1] + rgb[2];
        azimuth = bright > best ? i * step : azimuth;
        best = bright > best ? bright : best;
    }
    return azimuth;
}

static void add_lamp(int lamp, const double way[3], SceneLight *light)
{
    const double direction[3] = {-way[0], -way[1], -way[2]};
    *light = light_directional_new(direction, lamps[lamp].light);
}

/* Sets a square area light perpendicular to the direction `way`, with horizontal edges. From a
 * uniform sphere of radiance, a square of half edge a at distance d receives the share 4 / pi s
 * atan(s), s = a / sqrt(a^2 + d^2). */
static void add_square(int lamp, const double way[3], const double up[3], SceneLight *light)
{
    const double half = lamps[lamp].half, sine = half / hypot(half, away),
                 share = 4 / 3.141592653589793 * sine * atan(sine);
    const double rise = vec3_dot(way, up);
    double high[3];
    *light = light_area_new();
    for (int i = 0; i < 3; i++)
        high[i] = (up[i] - rise * way[i]) / sqrt(1 - rise * rise);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double wide = way[j] * high[k] - way[k] * high[j];
        light->edges[0][i] = 2 * half * wide;
        light->edges[1][i] = 2 * half * high[i];
        light->position[i] = away * way[i] - half * (wide + high[i]);
        light->light[i] = lamps[lamp].light[i] / share;
    }
}

static void add_lights(Preview *p)
{
    const SceneCamera *camera = &p->scene.camera;
    const bool mirrors = (scene_models(&p->scene) >> MODEL_Principled & 1) != 0;
    for (int i = 0; i < PREVIEW_LAMPS; i++) {
        const double *of = lamps[i].way;
        double way[3];
        for (int k = 0; k < 3; k++)
            way[k] = camera->right[k] * of[0] + camera->up[k] * of[1] + camera->back[k] * of[2];
        if (mirrors)
            add_square(i, way, camera->up, &p->lights[i]);
        else
            add_lamp(i, way, &p->lights[i]);
    }
    p->lights[PREVIEW_LAMPS] = light_hemisphere_new(above, below);
    p->scene.lights = p->lights;
    p->scene.light_count = PREVIEW_LAMPS + 1;
}

/* Adds the object with an identity transform: local space is world space. */
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

/* Sets up a sky scene. Sky radiance is unbounded, so the tone curve is exponential, as film
 * responds. */
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
    if (!add_object(o, p))
        return false;
    add_lights(p);
    return true;
}

bool preview_make(const PreviewOptions *options, SceneMaterial material, const MatcOptions *compile,
                  Preview *made)
{
    *made = (Preview){.material = material};
    made->scene =
        (Scene){.time = compile->time,
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
