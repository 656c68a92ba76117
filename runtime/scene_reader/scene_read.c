/* Reads a scene from text: the top level of its document. */
#include "compiler/document.h"
#include "compiler/base/memory.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene_reader/scene_part.h"
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/scene/scene_origin.h"
#include "runtime/scene_reader/scene_read.h"
#include "runtime/scene_reader/scene_stand.h"
#include <math.h>
#include <stdlib.h>

static void read_image(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_image, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_image, &desc))
        return;
    r->scene->width = (int)scene_node_number(&desc, S_Image_width);
    r->scene->height = (int)scene_node_number(&desc, S_Image_height);
    r->scene->glow = scene_node_number(&desc, S_Image_glow) != 0;
    r->scene->tiles = scene_node_number(&desc, S_Image_tiles) != 0;
}

static void read_tone(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_toneMapping, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_toneMapping, &desc))
        return;
    static const int first[SCENE_KIND_COUNT] = {[SCENE_ReinhardDevlin] = S_ReinhardDevlin_intensity,
                                                [SCENE_Drago] = S_Drago_bias,
                                                [SCENE_Shoulder] = S_Shoulder_knee};
    static const int numbers[SCENE_KIND_COUNT] = {
        [SCENE_ReinhardDevlin] = 4, [SCENE_Drago] = 1, [SCENE_Shoulder] = 1};
    static const int exposures[SCENE_KIND_COUNT] = {
        [SCENE_Clamp] = S_Clamp_exposure,       [SCENE_Filmic] = S_Filmic_exposure,
        [SCENE_Shoulder] = S_Shoulder_exposure, [SCENE_Exponential] = S_Exponential_exposure,
        [SCENE_Linear] = S_Linear_exposure,     [SCENE_Drago] = S_Drago_exposure};
    Scene *scene = r->scene;
    scene->tone = desc.kind;
    scene->exposure =
        exposures[desc.kind] ? exp2(scene_node_number(&desc, exposures[desc.kind])) : 1;
    for (int i = 0; i < numbers[desc.kind]; i++)
        scene->tone_numbers[i] = scene_node_number(&desc, first[desc.kind] + i);
}

static void read_shadow_maps(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_shadowMaps, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_shadowMaps, &desc))
        return;
    r->scene->shadow_size = (int)scene_node_number(&desc, S_ShadowMaps_size);
    r->scene->shadow_filter = (int)scene_node_number(&desc, S_ShadowMaps_filter);
    r->scene->shadow_cascades = (int)scene_node_number(&desc, S_ShadowMaps_cascades);
    r->scene->shadow_points = (int)scene_node_number(&desc, S_ShadowMaps_areaPoints);
    r->scene->shadow_colored = scene_node_number(&desc, S_ShadowMaps_colored) != 0;
    r->scene->shadow_volume = (Keyword)scene_node_number(&desc, S_ShadowMaps_volume);
    r->scene->shadow_path = (Keyword)scene_node_number(&desc, S_ShadowMaps_path);
    r->scene->shadow_offset = scene_node_number(&desc, S_ShadowMaps_offset);
    r->scene->shadow_stretched = scene_node_number(&desc, S_ShadowMaps_stretched) != 0;
}

static bool sees_planes(const SceneReader *r, const SceneCamera *camera)
{
    size_t i = 0;
    while (i < r->plane_count &&
           scene_camera_sees_plane(r->scene, camera,
                                   &r->scene->objects[r->planes[i]].world_from_local))
        i++;
    return i == r->plane_count;
}

static void read_voxels(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_voxels, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_voxels, &desc))
        return;
    const int size = (int)scene_node_number(&desc, S_Voxels_size);
    r->scene->voxel_size = size;
    if (!(size & (size - 1)))
        return;
    diag_add(r->session, scene_node_span(&desc, S_Voxels_size), DIAG_scene_voxels, size);
    r->fine = false;
}

static bool has_skirts(Keyword method, Keyword skirts)
{
    switch (skirts) {
    case KEYWORD_Skirts_auto:
        return true;
    case KEYWORD_Skirts_outline:
        return method == KEYWORD_Displacing_geometry;
    case KEYWORD_Skirts_borders:
    case KEYWORD_Skirts_early:
        return method == KEYWORD_Displacing_feedback;
    default:
        return method == KEYWORD_Displacing_geometry || method == KEYWORD_Displacing_feedback;
    }
}

static void read_displacement(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_displacement, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_displacement, &desc))
        return;
    r->scene->displaced_by = (Keyword)scene_node_number(&desc, S_Displacement_method);
    r->scene->displaced_pixels = scene_node_number(&desc, S_Displacement_pixels);
    r->scene->displaced_triangles = (int)scene_node_number(&desc, S_Displacement_triangles);
    r->scene->displaced_level = (int)scene_node_number(&desc, S_Displacement_level);
    const Keyword method = r->scene->displaced_by;
    SceneDividing *dividing = &r->scene->dividing;
    dividing->skirts = (Keyword)scene_node_number(&desc, S_Displacement_skirts);
    dividing->near = scene_node_number(&desc, S_Displacement_near);
    dividing->detail = scene_node_number(&desc, S_Displacement_detail);
    dividing->steps = (int)scene_node_number(&desc, S_Displacement_steps);
    dividing->push = scene_node_number(&desc, S_Displacement_push);
    dividing->bulge = scene_node_number(&desc, S_Displacement_bulge);
    dividing->spread = scene_node_number(&desc, S_Displacement_spread);
    dividing->symbol = (Keyword)scene_node_number(&desc, S_Displacement_symbol);
    if ((method == KEYWORD_Displacing_mesh || scene_displaced_traced(method)) &&
        r->scene->displaced_pixels > 0)
        diag_add(r->session, scene_node_span(&desc, S_Displacement_pixels), DIAG_scene_pixels,
                 keyword_table[method].name);
    else if (method == KEYWORD_Displacing_bisection && r->scene->displaced_level)
        diag_add(r->session, scene_node_span(&desc, S_Displacement_level), DIAG_scene_level);
    else if ((dividing->push != 0 || dividing->bulge > 0) &&
             !scene_displaced_by_driver(method, r->scene->displaced_pixels))
        diag_add(r->session,
                 scene_node_span(&desc,
                                 dividing->push != 0 ? S_Displacement_push : S_Displacement_bulge),
                 DIAG_scene_rounded, keyword_table[method].name);
    else if (!has_skirts(method, dividing->skirts))
        diag_add(r->session, scene_node_span(&desc, S_Displacement_skirts), DIAG_scene_skirts,
                 keyword_table[method].name, keyword_table[dividing->skirts].name);
    else
        return;
    r->fine = false;
}

static void read_tools(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_tools, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_tools, &desc))
        return;
    r->scene->tools = (SceneTools){.grid = scene_node_number(&desc, S_Tools_grid) != 0,
                                   .axes = scene_node_number(&desc, S_Tools_axes) != 0,
                                   .lights = scene_node_number(&desc, S_Tools_lights) != 0,
                                   .grid_cells = (int)scene_node_number(&desc, S_Tools_gridCells),
                                   .grid_step = scene_node_number(&desc, S_Tools_gridStep),
                                   .axes_length = scene_node_number(&desc, S_Tools_axesLength),
                                   .light_size = scene_node_number(&desc, S_Tools_lightSize)};
}

/* Rejects planes that lie partly behind an orthographic camera, where they would be clipped. */
static void check_rays(SceneReader *r, const SceneNodeDesc *document)
{
    const Scene *scene = r->scene;
    SceneCamera camera = scene->camera;
    if (!r->fine || camera.kind != SCENE_Orthographic || !r->plane_count)
        return;
    bool fine = sees_planes(r, &camera);
    for (int frame = 0; fine && frame < scene->motion.frames; frame++)
        fine = scene_motion_camera(scene, frame, scene->motion.frames, &camera) &&
               sees_planes(r, &camera);
    if (fine)
        return;
    diag_add(r->session, scene_node_span(document, S_Scene_camera), DIAG_scene_rays);
    r->fine = false;
}

/* Reports whether a material emits light at some of a few sample points. */
static bool emits(const SceneMaterial *material)
{
    static const char *const points[] = {"u=0.5 v=0.5", "u=0.13 v=0.71 x=1 y=2 z=3",
                                         "u=0.87 v=0.29 x=-2 y=0.3 z=-1"};
    MatcOptions options;
    bool any = false;
    matc_options_init(&options);
    options.slot = "emissive";
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
        const MatcNumbers light =
            matc_eval_slot(material->document, material->index, points[i], &options);
        for (int k = 0; k < light.components; k++)
            any |= light.component[k] > 0;
    }
    return any;
}

static void warn_of_darkness(SceneReader *r, const SceneNodeDesc *desc)
{
    const Scene *scene = r->scene;
    const Tree *objects = scene_node_given(desc, S_Scene_objects);
    if (!r->fine || !scene->object_count || scene_node_given(desc, S_Scene_lights))
        return;
    for (int i = 0; i < scene->material_count; i++)
        if (i != scene->sky && emits(&scene->materials[i]))
            return;
    diag_add(r->session, objects->span, DIAG_no_light);
}

static void read_scene(SceneReader *r, Tree *document)
{
    SceneNodeDesc desc;
    if (!resolve_color_space(&r->resolver, document)) {
        r->fine = false;
        return;
    }
    scene_node_read_document(r, document, &desc);
    scene_material_open(r, document);
    scene_definition_open(r, document);
    read_image(r, scene_node_given(&desc, S_Scene_image));
    scene_camera_read(r, scene_node_given(&desc, S_Scene_camera));
    if (scene_node_given(&desc, S_Scene_motion) && r->fine)
        scene_motion_read(r, scene_node_given(&desc, S_Scene_motion));
    read_tone(r, scene_node_given(&desc, S_Scene_toneMapping));
    read_shadow_maps(r, scene_node_given(&desc, S_Scene_shadowMaps));
    read_displacement(r, scene_node_given(&desc, S_Scene_displacement));
    read_voxels(r, scene_node_given(&desc, S_Scene_voxels));
    scene_indirect_read(r, scene_node_given(&desc, S_Scene_indirect));
    read_tools(r, scene_node_given(&desc, S_Scene_tools));
    if (scene_node_given(&desc, S_Scene_objects))
        scene_objects_read(r, scene_node_given(&desc, S_Scene_objects));
    scene_objects_check_unused(r);
    Tree *sky = scene_node_given(&desc, S_Scene_sky);
    r->scene->sky = sky ? scene_material_read(r, sky) : -1;
    if (scene_node_given(&desc, S_Scene_lights))
        scene_lights_read(r, scene_node_given(&desc, S_Scene_lights));
    check_rays(r, &desc);
    scene_material_resolve(r, document);
    scene_sun_add(r);
    if (!r->session->diags.errors)
        warn_of_darkness(r, &desc);
}

MatcDocument *scene_read(const char *name, const char *text, size_t size,
                         const MatcOptions *options, Scene **made)
{
    MatcDocument *document = document_read(name, text, size, options);
    Tree *tree = document->tree;
    *made = NULL;
    if (!tree || !resolve_is_scene(tree)) {
        document_resolve(document, tree);
        return document;
    }
    SceneReader r = {.session = &document->session, .document = document, .fine = true};
    r.resolver.session = r.session;
    r.scene = calloc(1, sizeof *r.scene);
    if (!r.scene)
        memory_exhausted();
    r.scene->time = document->options.time;
    ARENA_PUSH(r.session->arena, r.asides, r.aside_count, r.aside_capacity,
               ((SceneMaterial){NULL, 0}));
    read_scene(&r, tree);
    r.fine = r.fine && !document->session.diags.errors && scene_stand(&r, options);
    if (r.fine)
        scene_origin_find(r.scene);
    if (r.fine && scene_displace(r.scene, r.session, options)) {
        scene_triangles_warn(&r);
        *made = r.scene;
    } else
        scene_free(r.scene);
    return document;
}

void scene_free(Scene *scene)
{
    if (!scene)
        return;
    scene_displace_free(scene);
    for (int i = 0; i < scene->mesh_count; i++)
        scene_mesh_free(&scene->meshes[i]);
    for (int i = 0; i < scene->document_count; i++)
        matc_document_free(scene->documents[i]);
    free(scene);
}
