/* Walks a material for the subjects of tests/bounds.def. */
#include "bounds.h"
#include <string.h>

const Bound bound_table[SUBJECT_COUNT] = {
#define KIND(name)                   KIND_##name
#define WAVE(name)                   SUBJECT_WAVES + (int)WAVE_##name
#define SLOT(name)                   SUBJECT_SLOTS + (int)SLOT_##name
#define KEYWORD_OF(list, name)       SUBJECT_WORDS + (int)KEYWORD_##list##_##name
#define DEFAULT                      SUBJECT_DEFAULT
#define BOUND(subject, bound, why)   [subject] = {bound, false, why},
#define DRIVERS(subject, bound, why) [subject] = {bound, true, why},
#include "tests/bounds.def"
#undef KIND
#undef WAVE
#undef SLOT
#undef KEYWORD_OF
#undef DEFAULT
#undef BOUND
#undef DRIVERS
};

const char *subject_name(int subject)
{
    if (subject < SUBJECT_WAVES)
        return kind_table[subject].name;
    if (subject < SUBJECT_SLOTS)
        return subject - SUBJECT_WAVES < WAVE_COUNT ? wave_table[subject - SUBJECT_WAVES].name
                                                    : "Chain";
    if (subject < SUBJECT_WORDS)
        return slot_table[subject - SUBJECT_SLOTS].name;
    return subject < SUBJECT_DEFAULT ? keyword_table[subject - SUBJECT_WORDS].name : "default";
}

static void walk(const Node *node, Subjects *subjects);

static void walk_wave(const Wave *wave, Subjects *subjects)
{
    if (!wave)
        return;
    subjects->has[SUBJECT_WAVES + (int)wave->kind] = true;
    walk_wave(wave->first, subjects);
    walk_wave(wave->second, subjects);
}

static void walk_value(const Value *value, Subjects *subjects)
{
    if (value->kind == VALUE_node)
        walk(value->node, subjects);
    else if (value->kind == VALUE_wave)
        walk_wave(value->wave, subjects);
    else if (value->kind == VALUE_items)
        for (int i = 0; i < value->items->count; i++)
            walk(value->items->item[i].input, subjects);
}

static void walk(const Node *node, Subjects *subjects)
{
    if (!node)
        return;
    subjects->has[SUBJECT_KINDS + (int)node->kind] = true;
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        walk_value(value, subjects);
        if (param_is_word(&param_table[kind_table[node->kind].first + i]) &&
            value->kind == VALUE_number)
            subjects->has[SUBJECT_WORDS + (int)value->number[0]] = true;
    }
}

static void walk_phong(const Node *phong, Slot slot, Subjects *subjects)
{
    static const int params[SLOT_COUNT][2] = {
        [SLOT_normal] = {P_Phong_input},
        [SLOT_diffuse] = {P_Phong_diffuse},
        [SLOT_alpha] = {P_Phong_diffuse},
        [SLOT_specular] = {P_Phong_specular},
        [SLOT_shininess] = {P_Phong_shininess},
        [SLOT_transparency] = {P_Phong_transparency, P_Phong_diffuse},
        [SLOT_transparencyShininess] = {P_Phong_transparencyShininess},
        [SLOT_interpolatedTransparency] = {P_Phong_interpolatedTransparency},
        [SLOT_diffuseTransparency] = {P_Phong_diffuseTransparency},
        [SLOT_ambient] = {P_Phong_ambient},
        [SLOT_emissive] = {P_Phong_emissive},
        [SLOT_ior] = {P_Phong_input},
    };
    walk_value(&phong->params[params[slot][0] - kind_table[KIND_Phong].first], subjects);
    if (slot == SLOT_transparency)
        walk_value(&phong->params[params[slot][1] - kind_table[KIND_Phong].first], subjects);
}

/* Walks through material switches; the subjects of all their materials count. */
static void walk_material(const Node *material, Slot slot, Subjects *subjects)
{
    subjects->has[SUBJECT_KINDS + (int)material->kind] = true;
    if (slot == SLOT_normal && graph_displaces(material)) {
        const Displacement d = graph_displacement(material);
        subjects->displaced = true;
        walk_value(d.height, subjects);
        walk_value(d.vector, subjects);
        walk_value(d.volume, subjects);
    }
    if (material->kind == KIND_Principled)
        walk(material, subjects);
    if (material->kind == KIND_MixMaterial)
        walk_value(node_param(material, P_MixMaterial_mask), subjects);
    if (material->kind == KIND_Phong)
        walk_phong(material, slot, subjects);
    else
        for (int i = 0; i < kind_table[material->kind].count; i++)
            if (param_table[kind_table[material->kind].first + i].type == PARAM_Material &&
                material->params[i].kind == VALUE_node)
                walk_material(material->params[i].node, slot, subjects);
}

void subjects_of(const Node *material, Slot slot, Subjects *subjects)
{
    memset(subjects, 0, sizeof *subjects);
    subjects->has[SUBJECT_DEFAULT] = subjects->has[SUBJECT_SLOTS + (int)slot] = true;
    walk_material(material, slot, subjects);
}

int subject_governing(const Subjects *subjects, Choice trigonometry)
{
    const bool own = trigonometry == CHOICE_trigonometry_bounded;
    int best = SUBJECT_DEFAULT;
    for (int i = 0; i < SUBJECT_COUNT; i++)
        if (subjects->has[i] && !(own && bound_table[i].drivers) &&
            bound_table[i].bound > bound_table[best].bound)
            best = i;
    return best;
}

bool subjects_slopes(const Subjects *subjects, Choice derivatives)
{
    return subjects->displaced ||
           (subjects->has[KIND_BumpMap] && derivatives != CHOICE_derivatives_finite);
}

bool subjects_noise(const Subjects *subjects)
{
    return subjects->has[KIND_Turbulence] || subjects->has[KIND_VolumeTurbulence] ||
           subjects->has[KIND_Granite];
}
