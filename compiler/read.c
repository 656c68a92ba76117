/* Text -> Tree. libyaml reads YAML and JSON alike and gives the places; for a .json file cJSON first decides whether the
 * text is strict JSON. Depth and size are bounded; an alias shares its anchor's node, so nothing is ever expanded. */
#include "tree.h"
#include <cjson/cJSON.h>
#include <string.h>
#include <yaml.h>

typedef struct {
    const char *name;
    Tree *tree;
} Anchor;

typedef struct {
    Compile *c;
    yaml_parser_t parser;
    uint32_t file;
    const uint32_t *bytes; /* character -> byte offset; NULL for ASCII, where they are the same */
    size_t characters;
    uint32_t start; /* of the text behind a byte order mark */
    Anchor *anchors;
    size_t anchor_count, anchor_room;
    uint32_t *anchor_table; /* hash table of the newest anchor of each name, from 1 */
    uint32_t anchor_mask;
    int nodes;
} Reader;

/* libyaml counts characters, a Span bytes. Fills the table between them; false where the text is not UTF-8. */
static bool map_characters(Reader *r, const Source *source)
{
    const unsigned char *text = (const unsigned char *)source->text, *end = text + source->size;
    const unsigned char *at = text + r->start;
    while (at < end && *at < 0x80)
        at++;
    if (at == end)
        return true;
    uint32_t *bytes = arena_alloc(r->c->arena, (source->size + 1) * sizeof *bytes);
    for (at = text + r->start; at < end;) {
        int length = utf8_length(at, end);
        uint32_t offset = (uint32_t)(at - text);
        if (!length) {
            diag_add(r->c, (Span){offset, offset + 1, r->file}, DIAG_bad_utf8);
            return false;
        }
        bytes[r->characters++] = offset;
        at += length;
    }
    bytes[r->characters] = (uint32_t)source->size;
    r->bytes = bytes;
    return true;
}

static uint32_t offset_of(const Reader *r, yaml_mark_t mark)
{
    size_t size = r->c->sources[r->file].size;
    if (!r->bytes)
        return (uint32_t)(r->start + mark.index < size ? r->start + mark.index : size);
    return r->bytes[mark.index < r->characters ? mark.index : r->characters];
}

static Span span_of(const Reader *r, const yaml_event_t *event)
{
    return (Span){offset_of(r, event->start_mark), offset_of(r, event->end_mark), r->file};
}

static bool next_event(Reader *r, yaml_event_t *event)
{
    if (yaml_parser_parse(&r->parser, event))
        return true;
    const char *problem = r->parser.problem ? r->parser.problem : "not YAML";
    yaml_mark_t mark = r->parser.problem_mark;
    uint32_t at = offset_of(r, mark);
    if (r->parser.error == YAML_READER_ERROR)
        at = r->start + (uint32_t)r->parser.problem_offset; /* in bytes, and without a mark */
    diag_add(r->c, (Span){at, at + 1, r->file}, DIAG_syntax, problem);
    if (r->parser.context && r->parser.context_mark.line != mark.line) {
        uint32_t context = offset_of(r, r->parser.context_mark);
        diag_add(r->c, (Span){context, context + 1, r->file}, DIAG_syntax_in, r->parser.context);
    }
    return false;
}

static Tree *new_tree(Reader *r, TreeKind kind, Span span)
{
    if (++r->nodes > LIMIT_TREE_NODES)
        return diag_add(r->c, span, DIAG_too_many, LIMIT_TREE_NODES);
    Tree *tree = ARENA_NEW(r->c->arena, Tree);
    tree->kind = kind;
    tree->span = span;
    return tree;
}

static uint32_t *anchor_slot(const Reader *r, const char *name)
{
    uint32_t at = tree_hash(name) & r->anchor_mask;
    while (r->anchor_table[at] && strcmp(r->anchors[r->anchor_table[at] - 1].name, name) != 0)
        at = (at + 1) & r->anchor_mask;
    return &r->anchor_table[at];
}

static void grow_anchor_table(Reader *r)
{
    r->anchor_mask = r->anchor_mask ? 2 * r->anchor_mask + 1 : 63;
    r->anchor_table = ARENA_ARRAY(r->c->arena, uint32_t, r->anchor_mask + 1);
    for (uint32_t i = 0; i < r->anchor_count; i++)
        *anchor_slot(r, r->anchors[i].name) = i + 1;
}

static void keep_anchor(Reader *r, const yaml_char_t *name, Tree *tree)
{
    if (!name)
        return;
    Anchor anchor = {arena_string(r->c->arena, (const char *)name, strlen((const char *)name)), tree};
    ARENA_PUSH(r->c->arena, r->anchors, r->anchor_count, r->anchor_room, anchor);
    if (2 * r->anchor_count > r->anchor_mask)
        grow_anchor_table(r);
    *anchor_slot(r, anchor.name) = (uint32_t)r->anchor_count; /* a name may be given anew */
}

static Tree *find_anchor(Reader *r, const char *name, Span span)
{
    uint32_t found = r->anchor_table ? *anchor_slot(r, name) : 0;
    if (!found)
        return diag_add(r->c, span, DIAG_unknown_anchor, name);
    Tree *tree = r->anchors[found - 1].tree;
    if (tree->open)
        return diag_add(r->c, span, DIAG_anchor_cycle, name);
    tree->shared = true;
    return tree;
}

static Tree *read_value(Reader *r, yaml_event_t *event, int depth);

/* list: [ value, ... ] */
static bool read_list(Reader *r, Tree *list, int depth)
{
    size_t count = 0, room = 0;
    for (yaml_event_t event;;) {
        if (!next_event(r, &event))
            return false;
        if (event.type == YAML_SEQUENCE_END_EVENT) {
            list->span.end = offset_of(r, event.end_mark);
            yaml_event_delete(&event);
            break;
        }
        Tree *item = read_value(r, &event, depth + 1);
        if (!item)
            return false;
        ARENA_PUSH(r->c->arena, list->items, count, room, item);
    }
    list->count = (uint32_t)count;
    return true;
}

/* `<<: *base` brings the members of base that the object lacks; of `<<: [*a, *b]` the first counts. */
static bool merge_members(Reader *r, Tree *object, const Tree *base, size_t *room)
{
    if (base->kind != TREE_object)
        return diag_add(r->c, base->span, DIAG_bad_merge, tree_describe(r->c, base));
    r->nodes += (int)base->count; /* merging is the one thing that copies */
    if (r->nodes > LIMIT_TREE_NODES)
        return diag_add(r->c, object->span, DIAG_too_many, LIMIT_TREE_NODES);
    const Tree own = *object; /* its members stay where they are while the object's list grows */
    for (uint32_t i = 0; i < base->count; i++) {
        if (tree_find(&own, base->members[i].key))
            continue;
        size_t count = object->count;
        ARENA_PUSH(r->c->arena, object->members, count, *room, base->members[i]);
        object->count = (uint32_t)count;
    }
    tree_index(r->c, object);
    return true;
}

/* tree_find gives the first member of a key: any other that has it stands there twice. */
static void check_duplicates(Reader *r, const Tree *object)
{
    for (uint32_t i = 0; i < object->count; i++) {
        const Member *member = &object->members[i], *first = tree_find(object, member->key);
        if (first == member)
            continue;
        diag_add(r->c, member->span, DIAG_duplicate_key, member->key);
        diag_add(r->c, first->span, DIAG_first_given);
    }
}

/* object: { name: value, ... } */
static bool read_object(Reader *r, Tree *object, int depth)
{
    size_t room = 0;
    const Tree *base = NULL;
    for (yaml_event_t event;;) {
        if (!next_event(r, &event))
            return false;
        if (event.type == YAML_MAPPING_END_EVENT) {
            object->span.end = offset_of(r, event.end_mark);
            yaml_event_delete(&event);
            break;
        }
        Member member = {.span = span_of(r, &event)};
        if (event.type != YAML_SCALAR_EVENT) {
            yaml_event_delete(&event);
            diag_add(r->c, member.span, DIAG_key_not_name);
            return false;
        }
        member.key = arena_string(r->c->arena, (char *)event.data.scalar.value, event.data.scalar.length);
        bool merge = !strcmp(member.key, "<<") && event.data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
        yaml_event_delete(&event);
        if (!next_event(r, &event) || !(member.value = read_value(r, &event, depth + 1)))
            return false;
        if (merge && base)
            return diag_add(r->c, member.span, DIAG_duplicate_key, member.key);
        if (merge) {
            base = member.value;
            continue;
        }
        size_t count = object->count;
        ARENA_PUSH(r->c->arena, object->members, count, room, member);
        object->count = (uint32_t)count;
    }
    tree_index(r->c, object);
    check_duplicates(r, object);
    if (base && base->kind == TREE_list) {
        for (uint32_t i = 0; i < base->count; i++)
            if (!merge_members(r, object, base->items[i], &room))
                return false;
    } else if (base && !merge_members(r, object, base, &room)) {
        return false;
    }
    return true;
}

static Tree *read_collection(Reader *r, TreeKind kind, Span span, const yaml_char_t *anchor, int depth)
{
    if (depth > LIMIT_DEPTH)
        return diag_add(r->c, span, DIAG_too_deep, LIMIT_DEPTH);
    Tree *tree = new_tree(r, kind, span);
    if (!tree)
        return NULL;
    keep_anchor(r, anchor, tree);
    tree->open = true;
    bool fine = kind == TREE_list ? read_list(r, tree, depth) : read_object(r, tree, depth);
    tree->open = false;
    return fine ? tree : NULL;
}

/* value: scalar | list | object | alias. Takes the event over. */
static Tree *read_value(Reader *r, yaml_event_t *event, int depth)
{
    Tree *tree = NULL;
    Span span = span_of(r, event);
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        if (!(tree = new_tree(r, TREE_scalar, span)))
            break;
        tree->text = arena_string(r->c->arena, (char *)event->data.scalar.value, event->data.scalar.length);
        tree->count = (uint32_t)event->data.scalar.length;
        tree->plain = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
        keep_anchor(r, event->data.scalar.anchor, tree);
        break;
    case YAML_SEQUENCE_START_EVENT:
        tree = read_collection(r, TREE_list, span, event->data.sequence_start.anchor, depth);
        break;
    case YAML_MAPPING_START_EVENT:
        tree = read_collection(r, TREE_object, span, event->data.mapping_start.anchor, depth);
        break;
    case YAML_ALIAS_EVENT:
        tree = find_anchor(r, (char *)event->data.alias.anchor, span);
        break;
    default:
        diag_add(r->c, span, DIAG_empty_document);
        break;
    }
    yaml_event_delete(event);
    return tree;
}

/* stream: [ document ] */
static Tree *read_stream(Reader *r)
{
    Tree *tree = NULL;
    for (yaml_event_t event;;) {
        if (!next_event(r, &event))
            return NULL;
        yaml_event_type_t type = event.type;
        Span span = span_of(r, &event);
        yaml_event_delete(&event);
        if (type == YAML_STREAM_END_EVENT)
            return tree ? tree : diag_add(r->c, span, DIAG_empty_document);
        if (type != YAML_DOCUMENT_START_EVENT)
            continue;
        if (tree)
            return diag_add(r->c, span, DIAG_many_documents);
        if (!next_event(r, &event) || !(tree = read_value(r, &event, 0)))
            return NULL;
    }
}

static bool is_json_name(const char *name)
{
    size_t size = strlen(name);
    return size > 5 && !strcmp(name + size - 5, ".json");
}

static bool check_json(Reader *r, const Source *source)
{
    if (!is_json_name(source->name))
        return true;
    const char *at = NULL;
    cJSON *json = cJSON_ParseWithLengthOpts(source->text, source->size + 1, &at, true);
    if (json) {
        cJSON_Delete(json);
        return true;
    }
    uint32_t offset = at ? (uint32_t)(at - source->text) : 0;
    diag_add(r->c, (Span){offset, offset + 1, r->file}, DIAG_not_json);
    return false;
}

Tree *read_document(Compile *c, uint32_t file)
{
    const Source *source = &c->sources[file];
    if (source->size > (size_t)LIMIT_DOCUMENT_MIB << 20)
        return diag_add(c, (Span){0, 0, file}, DIAG_too_large, LIMIT_DOCUMENT_MIB);
    Reader reader = {.c = c, .file = file};
    if (source->size >= 3 && !memcmp(source->text, "\xEF\xBB\xBF", 3))
        reader.start = 3;
    if (!map_characters(&reader, source) || !check_json(&reader, source))
        return NULL;
    if (!yaml_parser_initialize(&reader.parser))
        abort(); /* out of memory */
    yaml_parser_set_encoding(&reader.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&reader.parser, (const unsigned char *)source->text + reader.start,
                                 source->size - reader.start);
    Tree *tree = read_stream(&reader);
    yaml_parser_delete(&reader.parser);
    return tree;
}
