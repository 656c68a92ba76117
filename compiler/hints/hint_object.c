/* Hints for objects and lists in the place of a map or material without the key of their kind,
 * or with another name for the key. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include "grammar/foreign_table.h"
#include "grammar/scene_tables.h"
#include <string.h>

static bool is_material(Kind kind) { return kind_table[kind].lowering == LOWERING_MATERIAL; }

static const char *scalar_of(const Tree *object, const char *const names[2])
{
    for (int i = 0; i < 2; i++) {
        const Member *member = tree_find(object, names[i]);
        if (member && member->value->kind == TREE_scalar)
            return member->value->text;
    }
    return NULL;
}

/* Reports { r: 1, g: .5, b: 0 }, with or without `a:`. */
static bool hint_components(Resolver *r, const Tree *object)
{
    static const char *const names[4][2] = {
        {"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}};
    Text list = text_new(r->session->arena);
    uint32_t found = 0;
    for (int i = 0; i < 4; i++) {
        const char *component = scalar_of(object, names[i]);
        if (!component && i < 3)
            return false;
        if (component)
            text_format(&list, "%s%s", found++ ? ", " : "[", component);
    }
    text_put(&list, "]");
    if (found != object->count)
        return false;
    diag_add(r->session, object->span, DIAG_color_object, list.at);
    return true;
}

/* Returns the kind with this name, alias, preset name or name in another tool; KIND_COUNT: none. */
static Kind kind_called(const char *name, bool material, const char **written)
{
    const char *here = foreign_name(material ? FOREIGN_MATERIAL : FOREIGN_MAP, KIND_COUNT, name);
    const size_t size = here ? strcspn(here, " ,:") : 0;
    for (int i = 0; i < KIND_COUNT; i++) {
        *written = kind_table[i].name;
        if (is_material((Kind)i) == material &&
            (foreign_is_alike(*written, name) ||
             (strlen(*written) == size && !strncmp(*written, here, size))))
            return (Kind)i;
    }
    for (int i = 0; i < alias_count + preset_count; i++) {
        const int preset = i - alias_count;
        const Kind kind = preset < 0 ? alias_table[i].kind : preset_table[preset].kind;
        *written = preset < 0 ? alias_table[i].alias : preset_table[preset].name;
        if (is_material(kind) == material && foreign_is_alike(*written, name))
            return kind;
    }
    return KIND_COUNT;
}

/* Reports { type: Checker }. */
static bool hint_type(Session *session, const Tree *object, bool material)
{
    const char *written;
    for (uint32_t i = 0; i < object->count; i++) {
        const Member *member = &object->members[i];
        if (!foreign_name(FOREIGN_TYPE, KIND_COUNT, member->key) ||
            member->value->kind != TREE_scalar ||
            kind_called(member->value->text, material, &written) == KIND_COUNT)
            continue;
        diag_add(session, member->span, DIAG_kind_key, member->key, material ? "material" : "map",
                 written);
        return true;
    }
    return false;
}

/* Returns the parameter of a map with this name, or with this name in another tool; NULL: none. */
static const char *param_called(Kind kind, const char *name)
{
    const KindRow *row = &kind_table[kind];
    for (int i = row->first; i < row->first + row->count; i++)
        if (!strcmp(param_table[i].name, name))
            return param_table[i].name;
    const char *here = foreign_name(FOREIGN_PARAM, kind, name);
    for (int i = row->first; here && i < row->first + row->count; i++)
        if (!strcmp(param_table[i].name, here))
            return param_table[i].name;
    return NULL;
}

/* Reports { image: f.png }: the first map that has all these parameters, of which at least one
 * is not `input`. */
static bool hint_kindless(Resolver *r, const Tree *object)
{
    for (int kind = 0; kind < KIND_COUNT && object->count; kind++) {
        const char *own = NULL;
        uint32_t known = 0;
        for (uint32_t i = 0; i < object->count && !is_material((Kind)kind); i++) {
            const char *name = param_called((Kind)kind, object->members[i].key);
            known += name != NULL;
            if (name && !own && strcmp(name, "input") != 0)
                own = name;
        }
        if (!own || known != object->count)
            continue;
        Text hint = text_new(r->session->arena);
        text_format(&hint, "; did you mean `{ map: %s, %s: ... }`?", kind_table[kind].name, own);
        diag_add(r->session, object->span, DIAG_missing_kind, hint.at);
        return true;
    }
    return false;
}

bool hint_object(Resolver *r, const Tree *object, bool material)
{
    if (hint_type(r->session, object, material))
        return true;
    return !material && (hint_components(r, object) || hint_kindless(r, object));
}

bool hint_document(Session *session, const Tree *document)
{
    return hint_type(session, document, true);
}

/* Reports a list in the place of a map or material: - map: Checker */
bool hint_listed(Session *session, const Tree *list)
{
    const Tree *first = list->kind == TREE_list && list->count ? list->items[0] : NULL;
    if (!first || first->kind != TREE_object)
        return false;
    diag_add(session, first->span, DIAG_listed, tree_find(first, "material") ? "material" : "map");
    return true;
}
