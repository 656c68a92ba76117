/* A document with spheres at the casters' places, which are then replaced by the mesh. Each
 * pixel is judged at the hit point of its ray, in double. */
#include "tests/frame_reference/shadow_ends.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame_reference/boundary.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char *const shadow_ends_receivers[SHADOW_ENDS_RECEIVERS] = {"plane", "itself", "second",
                                                                  "overlapping"};

/* The light's direction is (0.6, 0.25, -1); the camera looks along it, from behind the casters,
 * except for "itself". */
#define HEAD                                                                                       \
    "image: { width: 320, height: 320 }\nmaterials: { m: { material: Phong, diffuse: .8 } }\n"     \
    "shadowMaps: { size: 256 }\nlights: [{ light: Directional, direction: [.6, .25, -1], "         \
    "shadows: %s }]\n"
#define CASTER(place) "- { object: Sphere, material: m, transform: { translation: [" place "] } }\n"
#define PLANE         "- { object: Plane, material: m }\n"

static const struct {
    const char *text;
    int casters; /* number of casters, which are the first objects */
} documents[SHADOW_ENDS_RECEIVERS] = {
    {HEAD "camera: { camera: Orthographic, position: [.9, .375, 1.2], target: [1.8, .75, 0], size: "
          "2.6 }\n"
          "objects:\n" CASTER("0, 0, 3") PLANE,
     1},
    {HEAD "camera: { camera: Orthographic, position: [-2, 2, 4], target: [0, 0, 0], size: 2.4 "
          "}\nobjects:\n" CASTER("0, 0, "
                                 "0"),
     1},
    {HEAD "camera: { camera: Orthographic, position: [.9, .375, -1.5], target: [1.8, .75, -3], "
          "size: 2.4 }\n"
          "objects:\n" CASTER(
              "0, 0, 0") "- { object: Sphere, radius: 1.3, material: m, transform: { translation: "
                         "[1.8, .75, -3] } }\n",
     1},
    {HEAD "camera: { camera: Orthographic, position: [.9, .375, 1.2], target: [1.8, .75, 0], size: "
          "3.4 }\n"
          "objects:\n" CASTER("-.5, -.4, 3") CASTER("-1, 0, 5") PLANE,
     2},
};

/* Data of a picture's pixels: their position in the light's map, in texels; 1 if the pixel is
 * judged; true light. */
typedef struct {
    double (*places)[2];
    float *light, *truth;
} Seen;

static void see_pixel(const Tracer *tracer, const ShadowView *view, int pixel, bool all,
                      const Seen *seen)
{
    const Scene *scene = tracer->scene;
    const int wide = scene->width;
    const Ray ray = reference_ray(scene, pixel % wide + .5, pixel / wide + .5);
    const Hit hit = reference_hit(tracer, &ray, 0);
    const bool same = hit.object >= 0 && shadow_sides_agree(&scene->lights[0], &hit);
    seen->light[pixel] = hit.object >= 0 && (all || same);
    if (seen->light[pixel] <= 0)
        return;
    for (int i = 0; i < 2; i++)
        seen->places[pixel][i] =
            (reference_dot(view->rows[i], hit.world) + view->rows[i][3]) * scene->shadow_size / 2;
    /* a face of a closed mesh that faces away from the light is in its own shadow */
    seen->truth[pixel] =
        same && shadow_is_lit(tracer, &scene->lights[0], hit.world, hit.microfacet);
}

static double distance_of(const Scene *scene, const ShadowView *view, const float *shares, bool all)
{
    const size_t count = (size_t)scene->width * (size_t)scene->height;
    Seen seen = {calloc(count, sizeof *seen.places), calloc(count, sizeof *seen.light),
                 calloc(count, sizeof *seen.truth)};
    Tracer tracer = reference_open(scene);
    for (size_t i = 0; seen.places && seen.light && seen.truth && i < count; i++)
        if (shares[i] >= 0)
            see_pixel(&tracer, view, (int)i, all, &seen);
    const Boundary boundary = {scene->width, (const double(*)[2])seen.places, seen.light,
                               seen.truth, 8};
    const double length = boundary_length(&boundary), area = boundary_area(&boundary, shares);
    reference_close(&tracer);
    free(seen.places);
    free(seen.truth);
    free(seen.light);
    return length > 100 ? area / length : INFINITY;
}

/* The light's view of its shadow map; exact shadows have no map, and are measured in texels of
 * an equivalent one. */
static ShadowView view_of(const ShadowPair *pair, Scene *scene)
{
    const Keyword method = scene->lights[0].shadows;
    scene->lights[0].shadows = KEYWORD_Shadows_map;
    free(shadow_pair_draw(pair, 0, scene));
    scene->lights[0].shadows = method;
    return pair->renders[0]->shadows->views.views[0];
}

double shadow_ends_distance(const ShadowPair *pair, const ShadowEnds *ends)
{
    MatcDocument *document;
    SceneMesh mesh = {.shape = *ends->mesh};
    char text[2048];
    snprintf(text, sizeof text, documents[ends->receiver].text, ends->method);
    Scene *scene = frame_scene(text, &pair->options, &document);
    scene->meshes = &mesh;
    scene->mesh_count = 1;
    if (ends->volume)
        scene->shadow_volume = ends->volume;
    if (ends->pixels)
        scene->width = scene->height = ends->pixels;
    for (int i = 0; i < documents[ends->receiver].casters; i++) {
        scene->objects[i].kind = SCENE_Mesh;
        scene->objects[i].mesh = 0;
    }
    const ShadowView view = view_of(pair, scene);
    float *shares = shadow_pair_shares(pair, scene);
    const double distance = distance_of(scene, &view, shares, ends->all);
    free(shares);
    scene->mesh_count = 0; /* the mesh does not belong to the scene */
    frame_forget(scene, document);
    return distance;
}
