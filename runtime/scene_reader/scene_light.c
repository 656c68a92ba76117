/* Reads lights: parameters that several kinds share here, the others by the row of the kind. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene_reader/scene_part.h"
#include <string.h>

/* Reads a Sky light. The sky's material was read before. */
static void read_sky(SceneReader *r, const SceneNodeDesc *desc, const double light[3])
{
    for (int i = 0; i < 3; i++)
        r->scene->sky_light[i] += light[i];
    if (r->scene->sky >= 0)
        return;
    diag_add(r->session, desc->tree->span, DIAG_scene_no_sky);
    r->fine = false;
}

/* Returns the index of a kind's parameter by name; -1 if it has none. */
static int find_param(SceneKind kind, const char *name)
{
    const SceneKindRow *row = &scene_kind_table[kind];
    for (int i = row->first; i < row->first + row->count; i++)
        if (!strcmp(scene_param_table[i].param.name, name))
            return i;
    return -1;
}

static LightParams params_of(const SceneNodeDesc *desc)
{
    const SceneKindRow *row = &scene_kind_table[desc->kind];
    LightParams params = {.kind = desc->kind};
    for (int i = 0; i < row->count; i++) {
        const SceneParamRow *param = &scene_param_table[row->first + i];
        if (param->value == SCENE_VALUE_plain && param->param.components == 3)
            scene_node_vector(desc, row->first + i, params.at[i]);
        else if (param->value == SCENE_VALUE_plain)
            params.at[i][0] = scene_node_number(desc, row->first + i);
    }
    return params;
}

static void fail(SceneReader *r, const SceneNodeDesc *desc, const LightFault *fault)
{
    diag_add(r->session, scene_node_span(desc, fault->param), fault->diag, fault->text);
    r->fine = false;
}

/* Reads the shared parameters, of which each kind has some. */
static void read_shared(SceneReader *r, const SceneNodeDesc *desc, const LightParams *params,
                        SceneLight *light)
{
    const int position = find_param(desc->kind, "position"),
              direction = find_param(desc->kind, "direction"),
              shadows = find_param(desc->kind, "shadows"), name = find_param(desc->kind, "name");
    const double *color = light_params_at(params, find_param(desc->kind, "color"));
    for (int i = 0; i < 3; i++)
        light->light[i] = color[i] * *light_params_at(params, find_param(desc->kind, "intensity"));
    if (name >= 0)
        light->name = scene_node_name(r, scene_node_given(desc, name));
    if (position >= 0)
        memcpy(light->position, light_params_at(params, position), sizeof light->position);
    if (direction >= 0)
        memcpy(light->direction, light_params_at(params, direction), sizeof light->direction);
    if (direction >= 0 && !vec3_normalize(light->direction))
        fail(r, desc, &(LightFault){DIAG_no_direction, direction, "direction"});
    if (shadows >= 0)
        light->shadows = (Keyword)*light_params_at(params, shadows);
    if (!scene_light_takes(light, light->shadows))
        fail(r, desc, &(LightFault){DIAG_scene_soft, shadows, scene_shadows_name(light->shadows)});
}

static void read_light(SceneReader *r, const SceneNodeDesc *desc)
{
    const LightParams params = params_of(desc);
    Scene *scene = r->scene;
    SceneLight light = {
        .kind = desc->kind, .direction = {0, 0, -1}, .shadows = KEYWORD_Shadows_none};
    const LightKind *row = light_kind_of(&light);
    LightFault fault;
    read_shared(r, desc, &params, &light);
    if (row->from == LIGHT_FROM_sky) {
        read_sky(r, desc, light.light);
        return;
    }
    if (row->read && !row->read(&params, &light, &fault))
        fail(r, desc, &fault);
    size_t count = (size_t)scene->light_count;
    ARENA_PUSH(r->session->arena, scene->lights, count, r->light_storage, light);
    scene->light_count = (int)count;
}

void scene_lights_read(SceneReader *r, const Tree *list)
{
    SceneNodeDesc desc;
    for (uint32_t i = 0; i < list->count; i++)
        if (scene_node_read(r, list->items[i], SCENE_SORT_light, &desc))
            read_light(r, &desc);
}
