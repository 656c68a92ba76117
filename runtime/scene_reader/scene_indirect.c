/* Reads a scene's settings of indirect light. */
#include "runtime/scene_reader/scene_part.h"

static Keyword keyword_of(const SceneNodeDesc *desc, int param)
{
    return (Keyword)scene_node_number(desc, param);
}
static int whole_of(const SceneNodeDesc *desc, int param)
{
    return (int)scene_node_number(desc, param);
}
static bool is_so(const SceneNodeDesc *desc, int param)
{
    return scene_node_number(desc, param) != 0;
}

/* A missing `indirect:` gets all defaults but no method: --indirect may select one. */
void scene_indirect_read(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    if (!tree)
        scene_node_default(r, SCENE_SORT_indirect, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_indirect, &desc))
        return;
    scene_node_preset(&desc, S_Indirect_quality);
    scene_node_preset(&desc, S_Indirect_preset);
    r->scene->indirect = (SceneIndirect){
        .method = tree ? keyword_of(&desc, S_Indirect_method) : KEYWORD_Indirect_none,
        .rays = whole_of(&desc, S_Indirect_rays),
        .samples = whole_of(&desc, S_Indirect_samples),
        .history = whole_of(&desc, S_Indirect_history),
        .error = scene_node_number(&desc, S_Indirect_error),
        .steps = whole_of(&desc, S_Indirect_steps),
        .radius = scene_node_number(&desc, S_Indirect_radius),
        .offset = scene_node_number(&desc, S_Indirect_offset),
        .thickness = scene_node_number(&desc, S_Indirect_thickness),
        .filter = keyword_of(&desc, S_Indirect_filter),
        .filter_size = whole_of(&desc, S_Indirect_filterSize),
        .coarse = 1 << (keyword_of(&desc, S_Indirect_resolution) - KEYWORD_Resolution_full),
        .moving = 1 << (keyword_of(&desc, S_Indirect_moving) - KEYWORD_Resolution_full),
        .contrast = scene_node_number(&desc, S_Indirect_contrast),
        .weight = keyword_of(&desc, S_Indirect_weight),
        .distribution = keyword_of(&desc, S_Indirect_distribution),
        .sequence = keyword_of(&desc, S_Indirect_sequence),
        .rotation = keyword_of(&desc, S_Indirect_rotation),
        .march = keyword_of(&desc, S_Indirect_march),
        .jitter = is_so(&desc, S_Indirect_jitter),
        .checked = is_so(&desc, S_Indirect_checked),
        .directional = is_so(&desc, S_Indirect_directional),
        .dims_direct = is_so(&desc, S_Indirect_dimsDirect),
        .bounces = whole_of(&desc, S_Indirect_bounces),
        .gain = scene_node_number(&desc, S_Indirect_gain)};
}
