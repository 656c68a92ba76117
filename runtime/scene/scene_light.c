/* Lights. What a kind has is in its rows; which of them mean what is here. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_part.h"
#include <math.h>
#include <string.h>

#define RADIANS (3.14159265358979323846 / 180)

/* Params of each kind; -1: it has none. */
typedef struct {
    int position, direction, color, intensity, shadows, name;
} LightRow;

static const LightRow rows[SCENE_KIND_COUNT] = {
    [SCENE_Point] = {S_Point_position, -1, S_Point_color, S_Point_intensity, S_Point_shadows,
                     S_Point_name},
    [SCENE_Spot] = {S_Spot_position, S_Spot_direction, S_Spot_color, S_Spot_intensity,
                    S_Spot_shadows, S_Spot_name},
    [SCENE_Directional] = {-1, S_Directional_direction, S_Directional_color,
                           S_Directional_intensity, S_Directional_shadows, S_Directional_name},
    [SCENE_Area] = {S_Area_position, -1, S_Area_color, S_Area_intensity, S_Area_shadows,
                    S_Area_name},
    [SCENE_Sky] = {-1, -1, S_Sky_color, S_Sky_intensity, -1, -1},
    [SCENE_Ambient] = {-1, -1, S_Ambient_color, S_Ambient_intensity, -1, S_Ambient_name},
    [SCENE_Hemisphere] = {-1, -1, S_Hemisphere_color, S_Hemisphere_intensity, -1,
                          S_Hemisphere_name},
};

static void read_cone(SceneReader *r, const SceneThing *thing, SceneLight *light)
{
    const double inner = scene_thing_number(thing, S_Spot_innerAngle);
    const double outer = scene_thing_number(thing, S_Spot_outerAngle);
    light->inner_cosine = cos(inner * RADIANS);
    light->outer_cosine = cos(outer * RADIANS);
    if (inner <= outer)
        return;
    diag_add(r->session, scene_thing_span(thing, S_Spot_innerAngle), DIAG_scene_cone);
    r->fine = false;
}

bool scene_casts(const Scene *scene)
{
    bool casts = false;
    for (int i = 0; i < scene->light_count; i++)
        casts |= scene_light_casts(&scene->lights[i]);
    return casts;
}

/* Shadows of an Area are soft, which maps alone can be. */
bool scene_light_takes(const SceneLight *light, Word method)
{
    return light->kind != SCENE_Area || method == WORD_Shadows_none || method == WORD_Shadows_map;
}

static void read_area(SceneReader *r, const SceneThing *thing, SceneLight *light)
{
    scene_thing_vector(thing, S_Area_u, light->edges[0]);
    scene_thing_vector(thing, S_Area_v, light->edges[1]);
    light->both_sides = scene_thing_number(thing, S_Area_bothSides) != 0;
    if (!scene_light_takes(light, light->shadows)) {
        diag_add(r->session, scene_thing_span(thing, S_Area_shadows), DIAG_scene_soft,
                 scene_shadows_name(light->shadows));
        r->fine = false;
    }
    if (scene_vector_span(light->edges[0], light->edges[1]))
        return;
    diag_add(r->session, scene_thing_span(thing, S_Area_v), DIAG_scene_flat,
             "u and v span nothing");
    r->fine = false;
}

static void read_hemisphere(const SceneThing *thing, SceneLight *light)
{
    scene_thing_vector(thing, S_Hemisphere_ground, light->ground);
    for (int i = 0; i < 3; i++)
        light->ground[i] *= scene_thing_number(thing, S_Hemisphere_intensity);
}

/* The sky is read already. */
static void read_sky(SceneReader *r, const SceneThing *thing, const double light[3])
{
    for (int i = 0; i < 3; i++)
        r->scene->sky_light[i] += light[i];
    if (r->scene->sky >= 0)
        return;
    diag_add(r->session, thing->tree->span, DIAG_scene_no_sky);
    r->fine = false;
}

static void read_light(SceneReader *r, const SceneThing *thing)
{
    const LightRow *row = &rows[thing->kind];
    Scene *scene = r->scene;
    SceneLight light = {.kind = thing->kind, .direction = {0, 0, -1}, .shadows = WORD_Shadows_none};
    scene_thing_vector(thing, row->color, light.light);
    for (int i = 0; i < 3; i++)
        light.light[i] *= scene_thing_number(thing, row->intensity);
    if (thing->kind == SCENE_Sky) {
        read_sky(r, thing, light.light);
        return;
    }
    light.name = scene_thing_name(r, scene_thing_given(thing, row->name));
    if (row->position >= 0)
        scene_thing_vector(thing, row->position, light.position);
    if (row->direction >= 0) {
        scene_thing_vector(thing, row->direction, light.direction);
        if (!scene_vector_normalize(light.direction)) {
            diag_add(r->session, scene_thing_span(thing, row->direction), DIAG_no_direction,
                     "direction");
            r->fine = false;
        }
    }
    if (row->shadows >= 0)
        light.shadows = (Word)scene_thing_number(thing, row->shadows);
    if (thing->kind == SCENE_Spot)
        read_cone(r, thing, &light);
    if (thing->kind == SCENE_Area)
        read_area(r, thing, &light);
    if (thing->kind == SCENE_Hemisphere)
        read_hemisphere(thing, &light);
    size_t count = (size_t)scene->light_count;
    ARENA_PUSH(r->session->arena, scene->lights, count, r->light_room, light);
    scene->light_count = (int)count;
}

void scene_lights_read(SceneReader *r, const Tree *list)
{
    SceneThing thing;
    for (uint32_t i = 0; i < list->count; i++)
        if (scene_thing_read(r, list->items[i], SCENE_SORT_light, &thing))
            read_light(r, &thing);
}

const char *scene_shadows_name(Word word)
{
    return word_table[word].list == PARAM_Shadows ? word_table[word].name : NULL;
}

const char *scene_volume_name(Word word)
{
    return word_table[word].list == PARAM_Volume ? word_table[word].name : NULL;
}

bool scene_shadows_find(const char *name, Word *method)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (word_table[i].list == PARAM_Shadows && !strcmp(word_table[i].name, name)) {
            *method = (Word)i;
            return true;
        }
    return false;
}

void scene_lights_shadow(Scene *scene, Word method)
{
    for (int i = 0; i < scene->light_count; i++)
        if (scene_light_casts(&scene->lights[i]) && scene_light_takes(&scene->lights[i], method))
            scene->lights[i].shadows = method;
}
