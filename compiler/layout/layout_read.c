/* Tree -> LayoutRow: the keys of a layout file, their types, and the names in them.
 * layout_check.c checks their consistency. */
#include "compiler/layout/layout_read.h"
#include "compiler/resolve/resolve.h"
#include <math.h>
#include <string.h>

typedef struct {
    Session *session;
    LayoutRow *row;
    Tree *const **trees; /* per case: the YAML trees of the fields */
    bool fine;
} Reader;

static const char *format_name(const void *user, int i)
{
    return (void)user, format_table[i + 1].name;
}
static const char *encoding_name(const void *user, int i)
{
    return (void)user, encoding_table[i].name;
}
static const char *slot_name(const void *user, int i) { return (void)user, slot_table[i].name; }
static const char *key_name(const void *user, int i) { return ((const char *const *)user)[i]; }

/* The valid names of a value, and the diagnostic for others. */
typedef struct {
    const char *(*name)(const void *user, int i);
    int count;
    DiagKind unknown;
} NameList;

static const NameList format_names = {format_name, FORMAT_COUNT - 1, DIAG_unknown_format};
static const NameList encoding_names = {encoding_name, ENCODING_COUNT, DIAG_unknown_encoding};
static const NameList slot_names = {slot_name, SLOT_COUNT, DIAG_unknown_slot};

/* A list of a file, such as "cases" of "a layout", and its max number of items. */
typedef struct {
    const char *owner, *key;
    int most;
} ListKey;

static void *fail(Reader *r)
{
    r->fine = false;
    return NULL;
}

static void wrong_type(Reader *r, const Tree *tree, const char *what, const char *wants)
{
    diag_add(r->session, tree->span, DIAG_wrong_type, what, wants, tree_describe(r->session, tree));
    fail(r);
}

/* Reports keys that are not in the list. */
static void check_keys(Reader *r, const Tree *object, const char *what, const char *const *keys,
                       int count)
{
    for (uint32_t i = 0; i < object->count; i++) {
        int k = 0;
        while (k < count && strcmp(keys[k], object->members[i].key) != 0)
            k++;
        if (k < count)
            continue;
        const char *near = diag_suggest(r->session, object->members[i].key, key_name, keys, count);
        diag_add(r->session, object->members[i].span, DIAG_layout_key, what, object->members[i].key,
                 near);
        fail(r);
    }
}

/* Returns the value of a key, or NULL; reports a missing mandatory key. */
static Tree *member(Reader *r, const Tree *object, const char *what, const char *key, bool must)
{
    const Member *found = tree_find(object, key);
    if (found && !tree_is_null(found->value))
        return found->value;
    if (must) {
        diag_add(r->session, object->span, DIAG_missing_key, what, key);
        fail(r);
    }
    return NULL;
}

static const char *text_of(Reader *r, const Tree *object, const char *what, const char *key,
                           bool must)
{
    const Tree *tree = member(r, object, what, key, must);
    if (!tree)
        return "";
    if (tree->kind == TREE_scalar)
        return tree->text;
    wrong_type(r, tree, key, "a string");
    return "";
}

/* Returns the items of a non-empty list; reports other values. */
static Tree **items_of(Reader *r, const Tree *object, ListKey key, int *count)
{
    const Tree *list = member(r, object, key.owner, key.key, true);
    *count = 0;
    if (!list)
        return NULL;
    if (list->kind != TREE_list || !list->count) {
        wrong_type(r, list, key.key, list->kind == TREE_list ? "at least one item" : "a list");
        return NULL;
    }
    if (list->count > (uint32_t)key.most) {
        diag_add(r->session, list->span, DIAG_layout_length, key.key, (int)list->count, key.most);
        return fail(r);
    }
    *count = (int)list->count;
    return list->items;
}

/* Returns the row of a name in the list, or -1 after reporting an unknown name. */
static int row_of(Reader *r, const Tree *tree, const char *what, const NameList *names)
{
    if (tree->kind != TREE_scalar) {
        wrong_type(r, tree, what, "a name");
        return -1;
    }
    for (int i = 0; i < names->count; i++)
        if (!strcmp(names->name(NULL, i), tree->text))
            return i;
    const char *near = diag_suggest(r->session, tree->text, names->name, NULL, names->count);
    diag_add(r->session, tree->span, names->unknown, tree->text, near);
    fail(r);
    return -1;
}

/* Adds the components of "diffuse" or "diffuse.rg" to the field. */
static void read_components(Reader *r, const Tree *tree, FieldRow *field)
{
    if (tree->kind != TREE_scalar) {
        wrong_type(r, tree, "slot", "a slot, such as diffuse or diffuse.rg");
        return;
    }
    size_t size = strcspn(tree->text, ".");
    Tree name = *tree;
    name.text = arena_string(r->session->arena, tree->text, size);
    int slot = row_of(r, &name, "slot", &slot_names);
    if (slot < 0)
        return;
    const int components = type_table[slot_table[slot].type].components;
    const char *all = arena_string(r->session->arena, "rgba", (size_t)components);
    const char *letters = tree->text[size] ? tree->text + size + 1 : all;
    if (!*letters)
        letters = "?";
    for (; *letters; letters++) {
        const char *rgba = strchr(all, *letters), *at = strchr("xyzw", *letters);
        int component = rgba ? (int)(rgba - all) : at ? (int)(at - "xyzw") : FIELD_COMPONENTS;
        if (component >= components || field->count == FIELD_COMPONENTS) {
            diag_add(r->session, tree->span, DIAG_layout_components, tree->text,
                     slot_table[slot].name, all);
            fail(r);
            return;
        }
        field->source[field->count++] = (SlotComponent){(Slot)slot, component};
    }
}

static void read_slots(Reader *r, const Tree *object, FieldRow *field)
{
    const Tree *tree = member(r, object, "a field", "slot", true);
    if (tree && tree->kind == TREE_list)
        for (uint32_t i = 0; i < tree->count; i++)
            read_components(r, tree->items[i], field);
    else if (tree)
        read_components(r, tree, field);
    if (tree && tree->kind == TREE_list && !tree->count)
        wrong_type(r, tree, "slot", "a slot or a list of them");
}

static void read_bits(Reader *r, const Tree *object, FieldRow *field)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    const Tree *tree = member(r, object, encoding->name, "bits", encoding->least != encoding->most);
    double bits = encoding->least;
    if (tree && (!tree_number(tree, &bits) || bits != floor(bits))) {
        wrong_type(r, tree, "bits", "an integer");
    } else if (bits < encoding->least || bits > encoding->most) {
        Text least = text_new(r->session->arena), most = text_new(r->session->arena);
        text_int(&least, encoding->least);
        text_int(&most, encoding->most);
        diag_add(r->session, tree->span, DIAG_out_of_range, "bits", tree->text, least.at, most.at);
        fail(r);
    }
    field->bits = r->fine ? (int)bits : encoding->least;
}

static void read_range(Reader *r, const Tree *object, FieldRow *field)
{
    const Tree *tree = member(r, object, "a field", "range", false);
    if (!tree)
        return;
    if (tree->kind != TREE_list || tree->count != 2 || !tree_number(tree->items[0], &field->low) ||
        !tree_number(tree->items[1], &field->high)) {
        wrong_type(r, tree, "range", "two numbers");
        return;
    }
    const double least = 1e-6, most = 3.4e38; /* limits of the precision and range of floats */
    bool reported = fabs(field->low) < most && fabs(field->high) < most &&
                    field->high - field->low > least * fmax(fabs(field->low), fabs(field->high));
    if (!reported || !encoding_takes_range(field->encoding)) {
        diag_add(r->session, tree->span, reported ? DIAG_field_range : DIAG_bad_range,
                 encoding_table[field->encoding].name);
        fail(r);
    }
}

static void read_gray(Reader *r, const Tree *object, FieldRow *field)
{
    const Tree *tree = member(r, object, "a field", "gray", false);
    if (!tree)
        return;
    bool yes = tree->kind == TREE_scalar && !strcmp(tree->text, "true");
    if (!yes && (tree->kind != TREE_scalar || strcmp(tree->text, "false") != 0)) {
        wrong_type(r, tree, "gray", "true or false");
        return;
    }
    bool whole = field->count > 1 &&
                 field->count == type_table[slot_table[field->source[0].slot].type].components;
    for (int i = 0; i < field->count; i++)
        whole &= field->source[i].slot == field->source[0].slot && field->source[i].component == i;
    if (yes && (!whole || encoding_table[field->encoding].takes > 1)) {
        diag_add(r->session, tree->span, DIAG_field_gray);
        fail(r);
    }
    field->gray = yes;
    field->count = yes ? 1 : field->count;
}

static void read_field(Reader *r, const Tree *tree, FieldRow *field)
{
    static const char *const keys[] = {"slot", "encoding", "bits", "range", "gray"};
    if (tree->kind != TREE_object) {
        wrong_type(r, tree, "a field", "an object");
        return;
    }
    check_keys(r, tree, "a field", keys, sizeof keys / sizeof *keys);
    read_slots(r, tree, field);
    const Tree *name = member(r, tree, "a field", "encoding", true);
    int encoding = name ? row_of(r, name, "encoding", &encoding_names) : -1;
    if (encoding < 0)
        return;
    field->encoding = (Encoding)encoding;
    read_bits(r, tree, field);
    read_range(r, tree, field);
    read_gray(r, tree, field);
}

static CaseRow read_case(Reader *r, const Tree *object, const char *what, int number)
{
    int count;
    Tree **items = items_of(r, object, (ListKey){what, "fields", LIMIT_LAYOUT_FIELDS}, &count);
    FieldRow *fields = ARENA_ARRAY(r->session->arena, FieldRow, count + 1);
    r->trees[number] = items;
    for (int i = 0; i < count; i++)
        read_field(r, items[i], &fields[i]);
    return (CaseRow){
        .fields = fields, .field_count = count, .doc = text_of(r, object, what, "doc", false)};
}

/* Further cases must follow all others, and need a bit of a word target. */
static void read_further(Reader *r, const Tree *object)
{
    const Tree *tree = member(r, object, "a case", "further", false);
    const int targets = layout_targets(r->row);
    const bool yes = tree && tree->kind == TREE_scalar && !strcmp(tree->text, "true");
    if (tree && !yes && (tree->kind != TREE_scalar || strcmp(tree->text, "false") != 0))
        wrong_type(r, tree, "further", "true or false");
    else if (tree && yes && (!targets || !format_table[r->row->formats[targets - 1]].words))
        wrong_type(r, tree, "further", "false: the last target has no integer format");
    else if (!yes && r->row->further_count)
        wrong_type(r, object, "a case after later cases", "to be a further one");
    r->row->further_count += yes;
}

/* Reads a number for all components, or one per component. */
static void read_constant(Reader *r, const Member *from, FixedRow *fixed)
{
    const int components = type_table[slot_table[fixed->slot].type].components;
    const Tree *value = from->value;
    bool fine = value->kind == TREE_list ? value->count == (uint32_t)components
                                         : value->kind == TREE_scalar;
    for (int component = 0; component < components && fine; component++)
        fine = tree_number(value->kind == TREE_list ? value->items[component] : value,
                           &fixed->value[component]);
    if (!fine)
        wrong_type(r, value, from->key, components == 1 ? "a number" : "a number or three");
}

/* The cases whose constants are read. */
typedef struct {
    const CaseRow *cases;
    int count;
} ConstantOf;

static int read_constants(Reader *r, const Tree *from, const char *owner, ConstantOf of,
                          const FixedRow **rows)
{
    const Tree *object = member(r, from, owner, "constants", false);
    int found = 0;
    if (!object)
        return 0;
    if (object->kind != TREE_object) {
        wrong_type(r, object, "constants", "an object");
        return 0;
    }
    FixedRow *fixed = ARENA_ARRAY(r->session->arena, FixedRow, object->count + 1);
    for (uint32_t i = 0; i < object->count; i++) {
        Tree key = {
            .kind = TREE_scalar, .span = object->members[i].span, .text = object->members[i].key};
        int slot = row_of(r, &key, "constants", &slot_names);
        if (slot < 0)
            continue;
        fixed[found].slot = (Slot)slot;
        read_constant(r, &object->members[i], &fixed[found++]);
        for (int number = 0; number < of.count; number++)
            if (layout_case_has_slot(&of.cases[number], (Slot)slot)) {
                diag_add(r->session, key.span, DIAG_fixed_stored, slot_table[slot].name);
                fail(r);
            }
    }
    *rows = fixed;
    return found;
}

/* Reads the top-level fields, then those of `cases`. */
static void read_cases(Reader *r, const Tree *file)
{
    static const char *const keys[] = {"doc", "further", "fields", "constants"};
    int more = 0;
    const ListKey list = {"a layout", "cases", LIMIT_LAYOUT_CASES - 1};
    Tree **items =
        member(r, file, list.owner, list.key, false) ? items_of(r, file, list, &more) : NULL;
    CaseRow *cases = ARENA_ARRAY(r->session->arena, CaseRow, 1 + more);
    r->trees = ARENA_ARRAY(r->session->arena, Tree *const *, 1 + more);
    cases[0] = read_case(r, file, "a layout", 0);
    for (int i = 0; i < more; i++) {
        if (items[i]->kind != TREE_object) {
            wrong_type(r, items[i], "a case", "an object");
            continue;
        }
        check_keys(r, items[i], "a case", keys, sizeof keys / sizeof *keys);
        read_further(r, items[i]);
        CaseRow *own = &cases[1 + i];
        *own = read_case(r, items[i], "a case", 1 + i);
        own->fixed_count = read_constants(r, items[i], "a case", (ConstantOf){own, 1}, &own->fixed);
    }
    r->row->cases = cases;
    r->row->case_count = 1 + more;
}

static void read_targets(Reader *r, const Tree *file)
{
    int count;
    Tree **items = items_of(r, file, (ListKey){"a layout", "targets", LAYOUT_TARGETS}, &count);
    for (int i = 0; i < count; i++) {
        int format = row_of(r, items[i], "targets", &format_names);
        r->row->formats[i] = (Format)(format + 1);
    }
}

const LayoutRow *layout_read(Session *session, const Tree *tree)
{
    static const char *const keys[] = {"layout", "doc", "targets", "fields", "cases", "constants"};
    Reader r = {.session = session, .row = ARENA_NEW(session->arena, LayoutRow), .fine = true};
    if (tree->kind != TREE_object || !tree_find(tree, "layout"))
        return diag_add(session, tree->span, DIAG_layout_not_object);
    check_keys(&r, tree, "a layout", keys, sizeof keys / sizeof *keys);
    r.row->name = text_of(&r, tree, "a layout", "layout", true);
    r.row->doc = text_of(&r, tree, "a layout", "doc", false);
    if (r.fine && !resolve_is_name(r.row->name)) {
        diag_add(session, tree_find(tree, "layout")->value->span, DIAG_bad_name, r.row->name,
                 LIMIT_NAME);
        fail(&r);
    }
    read_targets(&r, tree);
    read_cases(&r, tree);
    const ConstantOf all = {r.row->cases, r.row->case_count};
    r.row->fixed_count = read_constants(&r, tree, "a layout", all, &r.row->fixed);
    return r.fine && layout_check(session, r.row, tree, r.trees) ? r.row : NULL;
}
