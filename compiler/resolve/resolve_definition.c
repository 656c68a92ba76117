/* Instantiates definitions with parameters: `{ ref: bricks, rows: 12 }`. The definition's tree
 * is copied only along the paths to a `{ param: rows }`, which is replaced by the argument's
 * tree; the rest is shared. Equal arguments share a copy, which is therefore resolved once.
 *
 *     defs:
 *       stripes:
 *         doc: "Stripes along z."
 *         params: { count: 8, dark: black }
 *         map: Blend
 *         blend: [{ value: 0, input: { param: dark } }, { value: 1, input: white }]
 *         input: { map: Gradient, direction: [0, 0, 1], waveForm: Ramp,
 *                  frequency: { param: count } }
 *     diffuse: { ref: stripes, count: 12 }     the Blend, with 12 for { param: count } and
 *                                              black for { param: dark }
 *
 * A fault is reported at its text, with a note at the other place: the use, for a fault in the
 * definition; the parameter, for a fault in an argument. */
#include "compiler/base/text.h"
#include "compiler/resolve/resolve_definition.h"
#include "compiler/resolve/resolve_parameter.h"
#include <stdlib.h>
#include <string.h>

/* A definition with arguments substituted, and the arguments in the order of the parameters. */
struct Expansion {
    const Tree *definition;
    Tree **arguments;
    Tree *tree;
};

typedef struct {
    Resolver *r;
    const Member *definition;
    Parameter *parameters;
    Tree **arguments;
    size_t count;
    const Tree **shared; /* targets of aliases, and their copies */
    Tree **copies;
    size_t shared_count, shared_capacity, copies_count, copies_capacity;
    HashIndex index;
} Copy;

bool resolve_is_definition(const Tree *tree)
{
    return tree->kind == TREE_object && (tree_find(tree, "params") || tree_find(tree, "doc"));
}

static bool read_parameters(Copy *c)
{
    Resolver *r = c->r;
    const Member *params = tree_find(c->definition->value, "params");
    if (!params || tree_is_null(params->value))
        return true;
    if (params->value->kind != TREE_object) {
        diag_add(r->session, params->value->span, DIAG_wrong_type, "params",
                 "an object, `{ name: default }`", tree_describe(r->session, params->value));
        return false;
    }
    if (params->value->count > LIMIT_DEFINITION_PARAMS) {
        diag_add(r->session, params->span, DIAG_many_parameters, LIMIT_DEFINITION_PARAMS);
        return false;
    }
    c->count = params->value->count;
    c->parameters = ARENA_ARRAY(r->session->arena, Parameter, c->count);
    c->arguments = ARENA_ARRAY(r->session->arena, Tree *, c->count);
    for (size_t i = 0; i < c->count; i++)
        if (!resolve_parameter(r, &params->value->members[i], &c->parameters[i]))
            return false;
    return true;
}

static const char *parameter_name(const void *user, int i)
{
    return ((const Copy *)user)->parameters[i].member->key;
}

static int find_parameter(const Copy *c, const char *name)
{
    for (size_t i = 0; i < c->count; i++)
        if (!strcmp(c->parameters[i].member->key, name))
            return (int)i;
    return -1;
}

/* Reads the arguments of a use. For a NULL use, placeholders replace mandatory arguments. */
static bool read_arguments(Copy *c, const Tree *use)
{
    Session *session = c->r->session;
    bool fine = true;
    for (uint32_t i = 0; use && i < use->count; i++) {
        const Member *member = &use->members[i];
        const int at = strcmp(member->key, "ref") ? find_parameter(c, member->key) : -1;
        if (at >= 0) {
            fine &= tree_is_null(member->value) ||
                    resolve_argument(c->r, c->definition, &c->parameters[at], member->value);
            c->arguments[at] = tree_is_null(member->value) ? NULL : member->value;
        } else if (strcmp(member->key, "ref") != 0) {
            const NameChoice names = {parameter_name, c, (int)c->count};
            diag_add(session, member->span, DIAG_unknown_argument, c->definition->key, member->key,
                     diag_suggest_or_list(session, member->key, &names, "; it has "));
            fine = false;
        }
    }
    for (size_t i = 0; i < c->count; i++) {
        const Parameter *p = &c->parameters[i];
        static char one[] = "1", null[] = "null";
        if (c->arguments[i])
            continue;
        c->arguments[i] = p->init;
        if (p->init)
            continue;
        if (use) {
            diag_add(session, use->span, DIAG_missing_argument, c->definition->key, p->member->key);
            resolve_report_parameter(c->r, c->definition, p);
            fine = false;
        }
        c->arguments[i] = ARENA_NEW(session->arena, Tree);
        *c->arguments[i] = (Tree){.kind = TREE_scalar, .plain = true, .span = p->member->span};
        c->arguments[i]->text = p->type == PARAMETER_number ? one : null;
        c->arguments[i]->count = (uint32_t)strlen(c->arguments[i]->text);
    }
    return fine;
}

static Tree *copy_of(Copy *c, Tree *tree);

/* Returns the end of the name that starts at `at`. */
static uint32_t name_end(const Tree *text, uint32_t at)
{
    while (at < text->count && (text_is_alphanumeric(text->text[at]) || text->text[at] == '_'))
        at++;
    return at;
}

static bool is_for_formulas(ParameterType type)
{
    return type == PARAMETER_number || type == PARAMETER_color || type == PARAMETER_map;
}

/* Sets `named` for the parameters that a formula names. Returns whether there are any. */
static bool find_named(Copy *c, const Tree *formula, bool named[LIMIT_DEFINITION_PARAMS])
{
    bool any = false;
    for (uint32_t at = 0, end; at < formula->count; at = (end > at) ? end : at + 1) {
        char name[LIMIT_NAME + 1] = {0};
        end = name_end(formula, at);
        if (end == at || end - at > LIMIT_NAME)
            continue;
        memcpy(name, formula->text + at, end - at);
        const int found = find_parameter(c, name);
        if (found < 0 || !is_for_formulas(c->parameters[found].type))
            continue;
        any = named[found] = true;
    }
    /* counts the formula's steps, since a long text costs as much as many values */
    c->r->copied += formula->count / sizeof(Tree);
    return any;
}

/* Attaches to a formula the arguments of the parameters that it names; returns a formula without
 * such names unchanged. */
static Tree *copy_formula(Copy *c, Tree *formula)
{
    Arena *arena = c->r->session->arena;
    bool named[LIMIT_DEFINITION_PARAMS] = {0};
    if (!c->count || c->r->copied > LIMIT_COPIES || !find_named(c, formula, named))
        return formula;
    Member *members = ARENA_ARRAY(arena, Member, c->count);
    size_t count = 0;
    for (size_t i = 0; i < c->count; i++)
        if (named[i])
            members[count++] = (Member){.key = c->parameters[i].member->key,
                                        .size = c->parameters[i].member->size,
                                        .value = c->arguments[i],
                                        .span = c->parameters[i].member->span};
    Tree *arguments = ARENA_NEW(arena, Tree);
    *arguments = (Tree){.kind = TREE_object, .span = formula->span};
    tree_set_members(c->r->session, arguments, members, count);
    ScopedTree *copy = ARENA_NEW(arena, ScopedTree);
    *copy = (ScopedTree){*formula, arguments};
    copy->tree.scoped = true;
    copy->tree.made = MADE_nothing;
    copy->tree.failed = copy->tree.shared = false;
    copy->tree.name = NULL;
    c->r->copied += 1 + count;
    return &copy->tree;
}

/* Copies a member; the value of `is:` is a formula without '='. */
static Tree *copy_member(Copy *c, const Member *member)
{
    Tree *tree = member->value;
    return tree->kind == TREE_scalar && !strcmp(member->key, "is") ? copy_formula(c, tree)
                                                                   : copy_of(c, tree);
}

/* Copies a list or object if any of its parts changes; otherwise returns the tree itself. */
static Tree *copy_parts(Copy *c, Tree *tree)
{
    Arena *arena = c->r->session->arena;
    const bool list = tree->kind == TREE_list;
    Tree **parts = ARENA_ARRAY(arena, Tree *, tree->count);
    bool changed = false;
    for (uint32_t i = 0; i < tree->count; i++) {
        Tree *part = list ? tree->items[i] : tree->members[i].value;
        parts[i] = list ? copy_of(c, part) : copy_member(c, &tree->members[i]);
        changed |= parts[i] != part;
    }
    if (!changed)
        return tree;
    c->r->copied += 1 + tree->count;
    Tree *copy = ARENA_NEW(arena, Tree);
    *copy = (Tree){.kind = tree->kind, .span = tree->span, .count = tree->count};
    if (tree->made == MADE_nothing)
        copy->name = tree->name;
    if (list) {
        copy->items = parts;
        return copy;
    }
    Member *members = ARENA_ARRAY(arena, Member, tree->count);
    for (uint32_t i = 0; i < tree->count; i++) {
        members[i] = tree->members[i];
        members[i].value = parts[i];
    }
    tree_set_members(c->r->session, copy, members, tree->count);
    return copy;
}

/* Returns the index of the parameter that `{ param: name }` refers to, -1 for other trees. */
static int argument_of(const Copy *c, const Tree *tree)
{
    const Member *name = tree_find(tree, "param");
    if (!name || name->value->kind != TREE_scalar)
        return -1;
    const int at = find_parameter(c, name->value->text);
    if (at >= 0 && tree->count > 1)
        diag_add(c->r->session, tree->span, DIAG_parameter_default, name->value->text);
    return at;
}

/* Copies the target of an alias once. */
static Tree *copy_shared(Copy *c, Tree *tree)
{
    for (HashProbe probe = hash_probe(&c->index, hash_pointer(tree)); hash_probe_next(&probe);)
        if (c->shared[probe.number] == tree)
            return c->copies[probe.number];
    Arena *arena = c->r->session->arena;
    Tree *copy = copy_parts(c, tree);
    hash_index_add(arena, &c->index, hash_pointer(tree), (uint32_t)c->shared_count);
    ARENA_PUSH(arena, c->shared, c->shared_count, c->shared_capacity, tree);
    ARENA_PUSH(arena, c->copies, c->copies_count, c->copies_capacity, copy);
    return copy;
}

static Tree *copy_of(Copy *c, Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return resolve_is_formula(tree) ? copy_formula(c, tree) : tree;
    const int at = tree->kind == TREE_object ? argument_of(c, tree) : -1;
    if (at >= 0)
        return c->arguments[at];
    return tree->shared ? copy_shared(c, tree) : copy_parts(c, tree);
}

/* Returns true for equal scalars of one file, or the same tree. */
static bool alike(const Tree *a, const Tree *b)
{
    if (a == b)
        return true;
    return a->kind == TREE_scalar && b->kind == TREE_scalar && a->plain == b->plain &&
           a->span.file == b->span.file && !strcmp(a->text, b->text);
}

static uint32_t expansion_hash(const Copy *c)
{
    uint32_t hash = hash_pointer(c->definition->value);
    for (size_t i = 0; i < c->count; i++)
        hash = hash * 31 + (c->arguments[i]->kind == TREE_scalar
                                ? tree_hash(c->arguments[i]->text, c->arguments[i]->count)
                                : hash_pointer(c->arguments[i]));
    return hash;
}

static Expansion *find_expansion(const Copy *c, uint32_t hash)
{
    for (HashProbe probe = hash_probe(&c->r->expansion_index, hash); hash_probe_next(&probe);) {
        Expansion *e = c->r->expansions[probe.number];
        bool same = e->definition == c->definition->value;
        for (size_t i = 0; same && i < c->count; i++)
            same = alike(e->arguments[i], c->arguments[i]);
        if (same)
            return e;
    }
    return NULL;
}

/* Builds the definition with arguments substituted, without its keys `params:` and `doc:`. */
static Tree *expand(Copy *c)
{
    Session *session = c->r->session;
    const Tree *definition = c->definition->value;
    Member *members = ARENA_ARRAY(session->arena, Member, definition->count);
    size_t count = 0;
    for (uint32_t i = 0; i < definition->count; i++) {
        members[count] = definition->members[i];
        if (!strcmp(members[count].key, "params") || !strcmp(members[count].key, "doc"))
            continue;
        members[count].value = copy_member(c, &members[count]);
        count++;
    }
    Tree *tree = ARENA_NEW(session->arena, Tree);
    *tree = (Tree){.kind = TREE_object, .span = definition->span};
    tree->name = c->definition->key;
    tree_set_members(session, tree, members, count);
    c->r->copied += 1 + count;
    return tree;
}

Tree *resolve_definition(Resolver *r, const Member *definition, const Tree *use)
{
    Copy c = {.r = r, .definition = definition};
    if (definition->value->failed) /* the definition's parameters have a fault that was reported */
        return NULL;
    if (!read_parameters(&c)) {
        definition->value->failed = true;
        return NULL;
    }
    if (!read_arguments(&c, use))
        return NULL;
    if (r->copied > LIMIT_COPIES) {
        if (!r->overgrown)
            diag_add(r->session, use ? use->span : definition->span, DIAG_many_expansions,
                     LIMIT_COPIES);
        r->overgrown = true;
        return NULL;
    }
    const uint32_t hash = expansion_hash(&c);
    const Expansion *known = find_expansion(&c, hash);
    if (known)
        return known->tree;
    Expansion *e = ARENA_NEW(r->session->arena, Expansion);
    *e = (Expansion){definition->value, c.arguments, expand(&c)};
    hash_index_add(r->session->arena, &r->expansion_index, hash, (uint32_t)r->expansion_count);
    ARENA_PUSH(r->session->arena, r->expansions, r->expansion_count, r->expansion_capacity, e);
    return e->tree;
}

void resolve_report_use(Resolver *r, const Member *definition, const Tree *use)
{
    const DiagList *diags = &r->session->diags;
    if (!diags->count || diags->at[diags->count - 1].severity == SEVERITY_note)
        return;
    const Span at = diags->at[diags->count - 1].span;
    const bool argument =
        at.file == use->span.file && at.start >= use->span.start && at.end <= use->span.end;
    if (argument)
        diag_add(r->session, definition->span, DIAG_definition_here, definition->key);
    else
        diag_add(r->session, use->span, DIAG_used_here, definition->key);
}
