/* Waves: a name, or a Chain of two waves, which forms a binary tree. */
#include "compiler/resolve/resolve.h"
#include <string.h>

static const ComponentCount one_component = {1, 1};

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
        return resolve_number(r, "factor", member->value, one_component, &wave->factor);
    if (!strcmp(member->key, "shift"))
        return resolve_number(r, "shift", member->value, one_component, &wave->shift);
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

/* Checks the keys of a wave: only a Chain has keys other than `wave:`. */
static bool stands_alone(Resolver *r, const Tree *tree, const Member *name, WaveKind kind)
{
    if (tree->count == 1)
        return true;
    const Member *extra = &tree->members[&tree->members[0] == name];
    diag_add(r->session, extra->span, DIAG_unknown_key, wave_name(NULL, (int)kind), extra->key, "");
    return false;
}

static int wave_length(const Wave *wave) { return wave ? wave->length : 0; }

static bool has_length(Resolver *r, const Tree *tree, Wave *wave)
{
    wave->length =
        wave->kind == WAVE_Chain ? wave_length(wave->first) + wave_length(wave->second) : 1;
    if (wave->length <= LIMIT_WAVES)
        return true;
    diag_add(r->session, tree->span, DIAG_wave_too_long, LIMIT_WAVES);
    return false;
}

/* Resolves wave: name | { wave: name } | { wave: Chain, first: wave, factor: number, shift:
 * number, second: wave } */
static bool make_wave(Resolver *r, const Tree *tree, Wave *wave)
{
    const Member *name = tree_find(tree, "wave");
    wave->factor = (Value){.kind = VALUE_number, .type = TYPE_float, .number = {1}};
    wave->shift = (Value){.kind = VALUE_number, .type = TYPE_float};
    bool fine = wave_kind(r, name ? name->value : tree, &wave->kind);
    if (fine && name)
        fine = wave->kind == WAVE_Chain ? chain(r, tree, wave)
                                        : stands_alone(r, tree, name, wave->kind);
    return has_length(r, tree, wave) && fine;
}

bool resolve_wave(Resolver *r, Tree *tree, const Wave **result)
{
    *result = tree->made == MADE_wave ? tree->wave : NULL;
    if (tree_is_null(tree) || *result)
        return true;
    if (tree->failed)
        return false;
    if (r->wave_depth >= LIMIT_DEPTH) {
        diag_add(r->session, tree->span, DIAG_too_deep, LIMIT_DEPTH);
        return false;
    }
    Wave *wave = ARENA_NEW(r->session->arena, Wave);
    r->wave_depth++;
    const bool fine = make_wave(r, tree, wave);
    r->wave_depth--;
    tree->failed = !fine;
    if (!fine)
        return false;
    *result = tree->wave = wave;
    tree->made = MADE_wave;
    return true;
}
