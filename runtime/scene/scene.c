/* Queries of a scene: its lights, its materials, and the names of its methods. */
#include "runtime/scene/scene.h"
#include "compiler/document.h"
#include <stdio.h>
#include <string.h>

bool scene_casts(const Scene *scene)
{
    bool casts = false;
    for (int i = 0; i < scene->light_count; i++)
        casts |= scene_light_casts(&scene->lights[i]);
    return casts;
}

/* Area lights have soft shadows, which only plain maps support. */
bool scene_light_takes(const SceneLight *light, Keyword method)
{
    return light_from(light) != LIGHT_FROM_extent || method == KEYWORD_Shadows_none ||
           method == SCENE_SHADOWS_PLAIN;
}

void scene_lights_shadow(Scene *scene, Keyword method)
{
    for (int i = 0; i < scene->light_count; i++)
        if (scene_light_casts(&scene->lights[i]) && scene_light_takes(&scene->lights[i], method))
            scene->lights[i].shadows = method;
}

const char *scene_shadows_name(Keyword word)
{
    return keyword_table[word].list == PARAM_Shadows ? keyword_table[word].name : NULL;
}

bool scene_shadows_find(const char *name, Keyword *method)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (keyword_table[i].list == PARAM_Shadows && !strcmp(keyword_table[i].name, name)) {
            *method = (Keyword)i;
            return true;
        }
    return false;
}

const char *scene_volume_name(Keyword word)
{
    return keyword_table[word].list == PARAM_Volume ? keyword_table[word].name : NULL;
}

bool scene_indirect_is(const Scene *scene)
{
    return scene->indirect.rays > 0 && scene->indirect.method != KEYWORD_Indirect_none;
}

const char *scene_indirect_name(Keyword word)
{
    return keyword_table[word].list == PARAM_Indirect ? keyword_table[word].name : NULL;
}

bool scene_indirect_find(const char *name, Keyword *method)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (scene_indirect_name((Keyword)i) && !strcmp(keyword_table[i].name, name)) {
            *method = (Keyword)i;
            return true;
        }
    return false;
}

const char *scene_displace_name(Keyword word)
{
    return keyword_table[word].list == PARAM_Displacing ? keyword_table[word].name : NULL;
}

unsigned scene_models(const Scene *scene)
{
    unsigned models = 0;
    for (int i = 0; i < scene->object_count; i++) {
        const SceneMaterial *of = &scene->materials[scene->objects[i].material];
        const Graph *graph = of->document->graph;
        models |= graph->models[graph->materials[of->index].node->index];
    }
    return models;
}

void scene_material_place(const SceneMaterial *material, char place[SCENE_PLACE])
{
    const MatcDocument *document = material->document;
    const Span span = document->graph->materials[material->index].node->span;
    const Source *source = &document->session.sources[span.file];
    const SourcePosition at = source_position(source, span.start);
    snprintf(place, SCENE_PLACE, "%s:%d:%d", source->name, at.line, at.column);
}
