/* Values of parameters: numbers, params, waves, transformations, items. */
#include "compiler/front/mistake.h"
#include "compiler/front/reserved.h"
#include "compiler/base/text.h"
#include <float.h>
#include <math.h>
#include <string.h>

static const LaneCount one_lane = {1, 1};
static const Type type_of_lanes[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};

static bool fits_float(Resolver *r, const char *what, const Tree *tree, double number)
{
    if (fabs(number) <= FLT_MAX)
        return true;
    diag_add(r->session, tree->span, DIAG_too_large_number, what, tree->text);
    return false;
}

static bool number_list(Resolver *r, const char *what, const Tree *tree, LaneCount lanes, Value *value)
{
    if (tree->count < 2 || (int)tree->count < lanes.least || (int)tree->count > lanes.most) {
        Text wanted = text_new(r->session->arena);
        if (lanes.most == 1)
            text_put(&wanted, "a number");
        else if (lanes.least == lanes.most)
            text_format(&wanted, "%d numbers", lanes.least);
        else
            text_format(&wanted, "%d to %d numbers", lanes.least > 2 ? lanes.least : 2, lanes.most);
        diag_add(r->session, tree->span, DIAG_wrong_count, what, wanted.at, (int)tree->count);
        return false;
    }
    for (uint32_t i = 0; i < tree->count; i++) {
        const Tree *item = tree->items[i];
        if (!tree_number(item, &value->number[i])) {
            diag_add(r->session, item->span, DIAG_not_number, what, tree_describe(r->session, item));
            return false;
        }
        if (!fits_float(r, what, item, value->number[i]))
            return false;
    }
    value->type = type_of_lanes[tree->count];
    return true;
}

static bool is_identifier(const char *name)
{
    if (!text_is_letter(name[0]))
        return false;
    for (; *name; name++)
        if (!text_is_alphanumeric(*name) && *name != '_')
            return false;
    return true;
}

static bool same_default(const Uniform *uniform, const Value *value)
{
    return uniform->type == value->type &&
           !memcmp(uniform->initial, value->number, sizeof(double) * (size_t)type_table[value->type].lanes);
}

/* The uniform of that name, made on first use. */
static bool name_uniform(Resolver *r, const Tree *name, Value *value)
{
    int found = names_find(&r->uniform_names, name->text);
    if (found >= 0) {
        const Uniform *known = r->uniforms[found];
        if (!same_default(known, value)) {
            diag_add(r->session, name->span, DIAG_param_conflict, name->text);
            diag_add(r->session, known->span, DIAG_first_given);
            return false;
        }
        value->uniform = known;
        return true;
    }
    if (r->uniform_count >= LIMIT_PARAMS) {
        diag_add(r->session, name->span, DIAG_too_many_params, LIMIT_PARAMS);
        return false;
    }
    Uniform *uniform = ARENA_NEW(r->session->arena, Uniform);
    *uniform = (Uniform){.name = name->text, .type = value->type, .span = name->span, .index = (int)r->uniform_count};
    memcpy(uniform->initial, value->number, sizeof value->number);
    const Uniform *kept = uniform;
    ARENA_PUSH(r->session->arena, r->uniforms, r->uniform_count, r->uniform_room, kept);
    names_add(r->session->arena, &r->uniform_names, uniform->name);
    value->uniform = uniform;
    return true;
}

/* { param: name, default: number, list or colour } */
static bool param(Resolver *r, const char *what, Tree *tree, LaneCount lanes, Value *value)
{
    const Member *initial = tree_find(tree, "default");
    const Tree *name = tree_find(tree, "param")->value;
    for (uint32_t i = 0; i < tree->count; i++) {
        const char *key = tree->members[i].key;
        if (strcmp(key, "param") != 0 && strcmp(key, "default") != 0) {
            diag_add(r->session, tree->members[i].span, DIAG_param_keys, key);
            return false;
        }
    }
    if (name->kind != TREE_scalar || !is_identifier(name->text)) {
        diag_add(r->session, name->span, DIAG_param_name, tree_describe(r->session, name));
        return false;
    }
    if (reserved_has(name->text)) {
        diag_add(r->session, name->span, DIAG_param_reserved, name->text);
        return false;
    }
    if (!initial) {
        diag_add(r->session, tree->span, DIAG_missing_key, "a param", "default");
        return false;
    }
    if (initial->value->kind == TREE_object) {
        diag_add(r->session, initial->value->span, DIAG_wrong_type, "the default of a param",
                 "a number, a list or a colour", "an object");
        return false;
    }
    if (!resolve_number(r, what, initial->value, lanes, value) || !name_uniform(r, name, value))
        return false;
    value->kind = VALUE_uniform;
    value->span = tree->span;
    return true;
}

bool resolve_number(Resolver *r, const char *what, Tree *tree, LaneCount lanes, Value *value)
{
    *value = (Value){.kind = VALUE_number, .given = true, .span = tree->span};
    double number;
    if (tree->kind == TREE_object && tree_find(tree, "param"))
        return param(r, what, tree, lanes, value);
    if (tree->kind == TREE_list)
        return number_list(r, what, tree, lanes, value);
    if (tree_number(tree, &number)) {
        value->type = TYPE_float;
        value->number[0] = number;
        return fits_float(r, what, tree, number);
    }
    if (lanes.most >= 3 && tree->kind == TREE_scalar && !tree->plain && strlen(tree->text) >= 6 &&
        mistake_hex(r, tree, tree->text))
        return false;
    if (mistake_number(r, tree))
        return false;
    if (tree->kind == TREE_scalar && tree->plain && tree->count && strchr("+-.0123456789", tree->text[0])) {
        diag_add(r->session, tree->span, DIAG_bad_number, tree->text);
        return false;
    }
    if (tree->kind == TREE_scalar && lanes.most >= 3 && !tree_is_null(tree))
        return resolve_color(r, tree, value);
    diag_add(r->session, tree->span, DIAG_wrong_type, what,
             lanes.most == 1 ? "a number" : "a number, a list of numbers or a colour", tree_describe(r->session, tree));
    return false;
}

static const char *wave_name(const void *user, int i)
{
    (void)user;
    return i == WAVE_COUNT ? "Chain" : wave_table[i].name;
}

static bool wave_kind(Resolver *r, const Tree *name, WaveKind *kind)
{
    for (int i = 0; name->kind == TREE_scalar && i <= WAVE_COUNT; i++)
        if (!strcmp(wave_name(NULL, i), name->text)) {
            *kind = (WaveKind)i;
            return true;
        }
    if (name->kind != TREE_scalar)
        diag_add(r->session, name->span, DIAG_wrong_type, "a wave", "a name or `{ wave: name }`",
                 tree_describe(r->session, name));
    else
        diag_add(r->session, name->span, DIAG_unknown_wave, name->text,
                 diag_suggest(r->session, name->text, wave_name, NULL, WAVE_COUNT + 1));
    return false;
}

static bool chain_member(Resolver *r, const Member *member, Wave *wave)
{
    if (!strcmp(member->key, "first"))
        return resolve_wave(r, member->value, &wave->first);
    if (!strcmp(member->key, "second"))
        return resolve_wave(r, member->value, &wave->second);
    if (!strcmp(member->key, "factor"))
        return resolve_number(r, "factor", member->value, one_lane, &wave->factor);
    if (!strcmp(member->key, "shift"))
        return resolve_number(r, "shift", member->value, one_lane, &wave->shift);
    diag_add(r->session, member->span, DIAG_unknown_key, "Chain", member->key, "");
    return false;
}

static bool chain(Resolver *r, const Tree *tree, Wave *wave)
{
    bool fine = true;
    for (uint32_t i = 0; i < tree->count; i++)
        if (strcmp(tree->members[i].key, "wave") != 0)
            fine &= chain_member(r, &tree->members[i], wave);
    return fine;
}

static int wave_length(const Wave *wave) { return wave ? wave->length : 0; }

/* wave: name | { wave: name } | { wave: Chain, first: wave, factor: number, shift: number, second: wave } */
bool resolve_wave(Resolver *r, Tree *tree, const Wave **result)
{
    *result = tree->made == MADE_wave ? tree->wave : NULL;
    if (tree_is_null(tree) || *result)
        return true;
    if (tree->failed)
        return false;
    if (++r->depth > LIMIT_DEPTH) {
        diag_add(r->session, tree->span, DIAG_too_deep, LIMIT_DEPTH);
        return false;
    }
    Wave *wave = ARENA_NEW(r->session->arena, Wave);
    wave->factor = (Value){.kind = VALUE_number, .type = TYPE_float, .number = {1}};
    wave->shift = (Value){.kind = VALUE_number, .type = TYPE_float};
    const Member *name = tree_find(tree, "wave");
    bool fine = wave_kind(r, name ? name->value : tree, &wave->kind);
    if (fine && name && wave->kind == WAVE_Chain)
        fine = chain(r, tree, wave);
    else if (fine && name && tree->count > 1) {
        const Member *extra = &tree->members[&tree->members[0] == name];
        diag_add(r->session, extra->span, DIAG_unknown_key, wave_name(NULL, (int)wave->kind), extra->key, "");
        fine = false;
    }
    r->depth--;
    wave->length = wave->kind == WAVE_Chain ? wave_length(wave->first) + wave_length(wave->second) : 1;
    if (wave->length > LIMIT_WAVES) {
        diag_add(r->session, tree->span, DIAG_wave_too_long, LIMIT_WAVES);
        fine = false;
    }
    tree->failed = !fine;
    *result = fine ? wave : NULL;
    if (fine) {
        tree->wave = wave;
        tree->made = MADE_wave;
    }
    return fine;
}

static bool matrix(Resolver *r, const Tree *tree, Transform *transform)
{
    if (tree->kind == TREE_list && tree->count != 16) {
        diag_add(r->session, tree->span, DIAG_wrong_count, "matrix", "16 numbers, by rows", (int)tree->count);
        return false;
    }
    if (tree->kind != TREE_list) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "matrix", "a list of 16 numbers, by rows",
                 tree_describe(r->session, tree));
        return false;
    }
    for (int i = 0; i < 16; i++) {
        if (!tree_number(tree->items[i], &transform->matrix[i])) {
            diag_add(r->session, tree->items[i]->span, DIAG_not_number, "matrix",
                     tree_describe(r->session, tree->items[i]));
            return false;
        }
        if (!fits_float(r, "matrix", tree->items[i], transform->matrix[i]))
            return false;
    }
    const double *last = transform->matrix + 12;
    if (last[0] == 0 && last[1] == 0 && last[2] == 0 && last[3] == 1)
        return true;
    diag_add(r->session, tree->span, DIAG_bad_matrix);
    return false;
}

static const char *transform_key(const void *user, int i)
{
    (void)user;
    static const char *const keys[] = {"translation", "rotation", "scale", "shear", "matrix"};
    return keys[i];
}

/* transform: { scale: s } | { translation: v } | { matrix: [16] } | any of translation, rotation, scale, shear */
bool resolve_transform(Resolver *r, Tree *tree, Transform *transform)
{
    if (tree->kind != TREE_object || !tree->count) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "transform",
                 "an object with scale, translation, rotation, shear or matrix", tree_describe(r->session, tree));
        return false;
    }
    const Value zero = {.kind = VALUE_number, .type = TYPE_vec3};
    transform->translation = transform->rotation = transform->shear = zero;
    transform->scale = (Value){.kind = VALUE_number, .type = TYPE_float, .number = {1}};
    Value *const parts[] = {&transform->translation, &transform->rotation, &transform->scale, &transform->shear};
    bool fine = true;
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        int key = 0;
        while (key < 5 && strcmp(transform_key(NULL, key), member->key) != 0)
            key++;
        if (key == 5) {
            diag_add(r->session, member->span, DIAG_unknown_key, "a transform", member->key,
                     diag_suggest(r->session, member->key, transform_key, NULL, 5));
            fine = false;
        } else if (key == 4) {
            fine &= matrix(r, member->value, transform);
            transform->kind = TRANSFORM_matrix;
            if (tree->count > 1) {
                diag_add(r->session, tree->members[i == 0].span, DIAG_unknown_key, "a transform with a matrix",
                         tree->members[i == 0].key, "");
                fine = false;
            }
        } else {
            /* a lone number is meant for scale only; a param may have one lane or three */
            bool list = member->value->kind == TREE_list, one = key == 2 && !list;
            bool param = member->value->kind == TREE_object;
            const LaneCount lanes = {one ? 1 : 3, one && !param ? 1 : 3};
            fine &= resolve_number(r, member->key, member->value, lanes, parts[key]);
            transform->kind = tree->count > 1   ? TRANSFORM_components
                              : key == 0        ? TRANSFORM_translation
                              : key == 2 && one ? TRANSFORM_scale
                                                : TRANSFORM_components;
        }
    }
    return fine;
}
