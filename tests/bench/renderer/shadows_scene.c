/* Documents with balls at the places of the casters; the balls are then replaced by the mesh. */
#include "runtime/scene_reader/scene_read.h"
#include "shadows_scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const shadows_receivers[SHADOWS_RECEIVERS] = {"plane", "itself", "second",
                                                          "overlapping"};

/* -- methods */

static const ShadowsMethod known[] = {
    {{"no", "shadows"}, KEYWORD_Shadows_none, 1, KEYWORD_Volume_perfect, false, KEYWORD_Path_auto},
    {{"map", "hard"}, KEYWORD_Shadows_map, 0, KEYWORD_Volume_perfect, false, KEYWORD_Path_auto},
    {{"map", "default"}, KEYWORD_Shadows_map, 1, KEYWORD_Volume_perfect, false, KEYWORD_Path_auto},
    {{"PCF", "3x3"}, KEYWORD_Shadows_map, 2, KEYWORD_Volume_perfect, false, KEYWORD_Path_auto},
    {{"hybrid", "plain"},
     KEYWORD_Shadows_hybrid,
     1,
     KEYWORD_Volume_plain,
     false,
     KEYWORD_Path_auto},
    {{"hybrid", "blurred"},
     KEYWORD_Shadows_hybrid,
     1,
     KEYWORD_Volume_blurred,
     false,
     KEYWORD_Path_auto},
    {{"hybrid", "perfect"},
     KEYWORD_Shadows_hybrid,
     1,
     KEYWORD_Volume_perfect,
     false,
     KEYWORD_Path_auto},
    {{"hybrid", "silhouette"},
     KEYWORD_Shadows_hybrid,
     1,
     KEYWORD_Volume_silhouette,
     false,
     KEYWORD_Path_auto},
    {{"hybrid", "stretched"},
     KEYWORD_Shadows_hybrid,
     1,
     KEYWORD_Volume_perfect,
     true,
     KEYWORD_Path_auto},
};
enum { KNOWN = sizeof known / sizeof *known, PCF = 3 };

int shadows_methods(ShadowsMethod methods[SHADOWS_METHODS_MAX], int *pcf)
{
    int count = KNOWN;
    memcpy(methods, known, sizeof known);
    *pcf = PCF;
    for (int word = 0; word < WORD_COUNT && count < SHADOWS_METHODS_MAX; word++) {
        int row = 0;
        while (row < KNOWN && known[row].shadows != (Keyword)word)
            row++;
        if (row == KNOWN && scene_shadows_name((Keyword)word))
            methods[count++] = (ShadowsMethod){{scene_shadows_name((Keyword)word), "default"},
                                               (Keyword)word,
                                               1,
                                               KEYWORD_Volume_perfect,
                                               false,
                                               KEYWORD_Path_auto};
    }
    return count;
}

void shadows_use(Scene *scene, const ShadowsMethod *method, int map_size)
{
    scene->lights[0].shadows = method->shadows;
    scene->shadow_size = map_size;
    scene->shadow_filter = method->filter;
    scene->shadow_volume = method->volume;
    scene->shadow_stretched = method->stretched;
    scene->shadow_path = method->path;
}

/* -- the mesh */

/* r = 0.8 + f, f = 0.15 sin 6x sin 6y sin 6z of the direction (x, y, z); the normal is parallel
 * to r times the direction minus the tangential gradient of f. */
static void bump(ShapeVertex *vertex)
{
    const double high = .15, often = 6;
    double s[3], c[3], slope[3], along = 0, length = 0, normal[3];
    for (int i = 0; i < 3; i++) {
        s[i] = sin(often * (double)vertex->position[i]);
        c[i] = cos(often * (double)vertex->position[i]);
    }
    const double r = .8 + high * s[0] * s[1] * s[2];
    for (int i = 0; i < 3; i++) {
        slope[i] = high * often * c[i] * s[(i + 1) % 3] * s[(i + 2) % 3];
        along += slope[i] * (double)vertex->position[i];
    }
    for (int i = 0; i < 3; i++) {
        normal[i] = (r + along) * (double)vertex->position[i] - slope[i];
        length = hypot(length, normal[i]);
    }
    for (int i = 0; i < 3; i++) {
        vertex->normal[i] = (float)(normal[i] / length);
        vertex->position[i] = (float)(r * (double)vertex->position[i]);
    }
}

bool shadows_ball(int triangles, Shape *made)
{
    const int around = (int)lround(sqrt(triangles));
    if (!shape_make_detailed(SHAPE_sphere, (int[]){around, around / 2}, made))
        return false;
    for (int i = 0; i < made->vertex_count; i++)
        bump(&made->vertices[i]);
    return true;
}

/* -- documents */

/* The light's direction is (0.6, 0.25, -1) / 1.193; the camera looks along it, or, for the
 * caster itself, 40 degrees away from it. */
#define HEAD                                                                                       \
    "image: { width: 512, height: 512 }\nmaterials: { m: { material: Phong, diffuse: .8 } }\n"     \
    "lights: [{ light: Directional, direction: [.6, .25, -1] }]\n"
#define CASTER(place) "- { object: Sphere, material: m, transform: { translation: [" place "] } }\n"
#define PLANE         "- { object: Plane, material: m }\n"

static const struct {
    const char *text;
    int casters;
} documents[SHADOWS_SCENES] = {
    [SHADOWS_plane] = {HEAD "camera: { camera: Orthographic, position: [.9, .375, 1.5], target: "
                            "[1.8, .75, 0], size: 2.4 }\n"
                            "objects:\n" CASTER("0, 0, 3") PLANE,
                       1},
    [SHADOWS_itself] =
        {HEAD
         "camera: { camera: Orthographic, position: [-2, 2, 4], target: [0, 0, 0], size: 2.2 }\n"
         "objects:\n" CASTER("0, 0, 0"),
         1},
    [SHADOWS_second] = {HEAD "camera: { camera: Orthographic, position: [.9, .375, -1.5], target: "
                             "[1.8, .75, -3], size: 2.4 }\n"
                             "objects:\n" CASTER(
                                 "0, 0, 0") "- { object: Sphere, radius: 1.3, material: m, "
                                            "transform: { translation: [1.8, .75, -3] } }\n",
                        1},
    [SHADOWS_overlapping] = {HEAD "camera: { camera: Orthographic, position: [.9, .375, 1.5], "
                                  "target: [1.8, .75, 0], size: 4 }\n"
                                  "objects:\n" CASTER("-.5, -.4, 3") CASTER("-1, 0, 5") PLANE,
                             2},
    [SHADOWS_frame] =
        {HEAD
         "camera: { camera: Perspective, position: [2, -5, 4], target: [.3, 0, .4], angle: 40 }\n"
         "objects:\n" CASTER("0, 0, 1.2") PLANE,
         1},
};

bool shadows_open(ShadowsScene which, const Shape *mesh, const MatcOptions *compile,
                  ShadowsPlace *made)
{
    const char *text = documents[which].text;
    *made = (ShadowsPlace){0};
    made->document = scene_read("shadows.yaml", text, strlen(text), compile, &made->scene);
    if (!made->scene)
        return fprintf(stderr, "matbench: %s\n", matc_diagnostics(made->document, MATC_TEXT)) < 0;
    made->mesh.shape = *mesh;
    made->scene->meshes = &made->mesh;
    made->scene->mesh_count = 1;
    for (int i = 0; i < documents[which].casters; i++) {
        made->scene->objects[i].kind = SCENE_Mesh;
        made->scene->objects[i].mesh = 0;
    }
    return true;
}

void shadows_close(ShadowsPlace *place)
{
    if (place->scene)
        place->scene->mesh_count = 0; /* the mesh does not belong to the scene */
    scene_free(place->scene);
    matc_document_free(place->document);
    *place = (ShadowsPlace){0};
}
