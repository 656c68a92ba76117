/* Adds the sun of a SunSkyLight as a directional light, if the sky gives light. */
#include "compiler/document.h"
#include "compiler/graph/graph_sky.h"
#include "runtime/scene_reader/scene_part.h"
#include <string.h>

#define PI 3.14159265358979323846

static void add_sun(SceneReader *r, const GraphSky *sky)
{
    Scene *scene = r->scene;
    const double direction[3] = {-sky->sun[0], -sky->sun[1], -sky->sun[2]};
    double sent[3]; /* light that a white surface reflects */
    size_t count = (size_t)scene->light_count;
    for (int i = 0; i < 3; i++)
        sent[i] = scene->sky_light[i] * sky->irradiance[i] / PI;
    SceneLight light = light_directional_new(direction, sent);
    light.shadows = SCENE_SHADOWS_PLAIN;
    ARENA_PUSH(r->session->arena, scene->lights, count, r->light_storage, light);
    scene->light_count = (int)count;
}

void scene_sun_add(SceneReader *r)
{
    Scene *scene = r->scene;
    GraphSky sky;
    const double *of = scene->sky_light;
    if (!r->fine || scene->sky < 0 || of[0] + of[1] + of[2] <= 0)
        return;
    const SceneMaterial *material = &scene->materials[scene->sky];
    const Graph *graph = material->document->graph;
    if (!graph || !graph_sky(graph->materials[material->index].node, &sky))
        return;
    if (sky.light && sky.disc && sky.sun[2] > 0)
        add_sun(r, &sky);
    if (!sky.light)
        memset(scene->sky_light, 0, sizeof scene->sky_light);
}
