/* Transforms of space: given by components, or as a matrix. */
#include "compiler/hints/lint.h"
#include "compiler/resolve/resolve.h"
#include <string.h>

typedef enum { TRANSLATION, ROTATION, SCALE, SHEAR, MATRIX, KEY_COUNT } Key;

static const char *key_name(const void *user, int key)
{
    static const char *const names[KEY_COUNT] = {"translation", "rotation", "scale", "shear",
                                                 "matrix"};
    (void)user;
    return names[key];
}

/* Returns the key, or KEY_COUNT after reporting an unknown key. */
static Key find_key(Resolver *r, const Member *member)
{
    int key = 0;
    while (key < KEY_COUNT && strcmp(key_name(NULL, key), member->key) != 0)
        key++;
    if (key == KEY_COUNT)
        diag_add(r->session, member->span, DIAG_unknown_key, "a transform", member->key,
                 diag_suggest(r->session, member->key, key_name, NULL, KEY_COUNT));
    return (Key)key;
}

static bool resolve_matrix(Resolver *r, const Tree *tree, Transform *transform)
{
    if (tree->kind == TREE_list && tree->count != 16) {
        diag_add(r->session, tree->span, DIAG_wrong_count, "matrix", "16 numbers, by rows",
                 (int)tree->count);
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
        if (!resolve_fits_float(r, "matrix", tree->items[i], transform->matrix[i]))
            return false;
    }
    const double *last = transform->matrix + 12;
    if (last[0] == 0 && last[1] == 0 && last[2] == 0 && last[3] == 1)
        return true;
    diag_add(r->session, tree->span, DIAG_bad_matrix);
    return false;
}

/* Checks that a matrix is the only key; otherwise reports the other key. */
static bool stands_alone(Resolver *r, const Tree *tree, const Member *matrix)
{
    if (tree->count == 1)
        return true;
    const Member *other = &tree->members[matrix == &tree->members[0]];
    diag_add(r->session, other->span, DIAG_unknown_key, "a transform with a matrix", other->key,
             "");
    return false;
}

/* A single number is allowed for scale only; a param may have one or three components. */
static bool is_one_number(Key key, const Tree *value)
{
    return key == SCALE && value->kind != TREE_list;
}

static ComponentCount components_of(Key key, const Tree *value)
{
    if (!is_one_number(key, value))
        return (ComponentCount){3, 3};
    return (ComponentCount){1, value->kind == TREE_object ? 3 : 1};
}

static TransformKind kind_of(const Tree *tree, Key key, const Tree *value)
{
    if (key == MATRIX)
        return TRANSFORM_matrix;
    if (tree->count > 1)
        return TRANSFORM_components;
    if (key == TRANSLATION)
        return TRANSFORM_translation;
    return is_one_number(key, value) ? TRANSFORM_scale : TRANSFORM_components;
}

static bool resolve_component(Resolver *r, const Tree *tree, const Member *member,
                              Transform *transform)
{
    Value *const parts[] = {&transform->translation, &transform->rotation, &transform->scale,
                            &transform->shear};
    const Key key = find_key(r, member);
    if (key == KEY_COUNT)
        return false;
    transform->kind = kind_of(tree, key, member->value);
    if (key != MATRIX) {
        const bool fine = resolve_number(r, member->key, member->value,
                                         components_of(key, member->value), parts[key]);
        if (fine && key == ROTATION)
            lint_unit(r->session, member->key, &unit_table[UNIT_radians], parts[key]);
        return fine;
    }
    const bool fine = resolve_matrix(r, member->value, transform);
    return stands_alone(r, tree, member) && fine;
}

/* Resolves transform: { scale: s } | { translation: v } | { matrix: [16] } | any of translation,
 * rotation, scale, shear */
bool resolve_transform(Resolver *r, Tree *tree, Transform *transform)
{
    if (tree->kind != TREE_object || !tree->count) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "transform",
                 "an object with scale, translation, rotation, shear or matrix",
                 tree_describe(r->session, tree));
        return false;
    }
    const Value zero = {.kind = VALUE_number, .type = TYPE_vec3};
    transform->translation = transform->rotation = transform->shear = zero;
    transform->scale = (Value){.kind = VALUE_number, .type = TYPE_float, .number = {1}};
    bool fine = true;
    for (uint32_t i = 0; i < tree->count; i++)
        fine &= resolve_component(r, tree, &tree->members[i], transform);
    return fine;
}
