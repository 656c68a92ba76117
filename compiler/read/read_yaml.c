/* YAML -> Tree, from libyaml's events. An alias shares the node of its anchor, so aliases are
 * never expanded. */
#include "compiler/read/read.h"
#include "compiler/base/memory.h"
#include "compiler/read/read_common_error.h"
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum { MARK_STEP = 64 };

typedef struct {
    const char *name;
    Tree *tree;
} Anchor;

typedef struct {
    TreeBuilder *b;
    Session *session;
    yaml_parser_t parser;
    /* Byte offset of every MARK_STEP-th character; NULL for ASCII text, where both counts agree. */
    const uint32_t *bytes;
    size_t characters; /* length of the whole text in characters */
    Anchor *anchors;
    size_t anchor_count, anchor_capacity;
    HashIndex anchor_index; /* finds anchors by name */
} Reader;

/* Prepares the conversion of positions: libyaml counts characters, a Span bytes. */
static void map_characters(Reader *r, const Source *source)
{
    const unsigned char *text = (const unsigned char *)source->text, *end = text + source->size;
    const unsigned char *at = text + r->b->start;
    while (at < end && *at < 0x80)
        at++;
    r->characters = source->size - r->b->start;
    if (at == end)
        return;
    r->characters = 0;
    uint32_t *bytes =
        arena_alloc(r->session->arena, (source->size / MARK_STEP + 1) * sizeof *bytes);
    for (at = text + r->b->start; at < end; at += text_utf8_length(at, end), r->characters++)
        if (r->characters % MARK_STEP == 0)
            bytes[r->characters / MARK_STEP] = (uint32_t)(at - text);
    r->bytes = bytes;
}

static uint32_t offset_of(const Reader *r, yaml_mark_t mark)
{
    const Source *source = &r->session->sources[r->b->file];
    const unsigned char *text = (const unsigned char *)source->text, *end = text + source->size;
    if (mark.index >= r->characters)
        return (uint32_t)source->size;
    if (!r->bytes)
        return r->b->start + (uint32_t)mark.index;
    const unsigned char *at = text + r->bytes[mark.index / MARK_STEP];
    for (size_t left = mark.index % MARK_STEP; left > 0 && at < end; left--)
        at += text_utf8_length(at, end);
    return (uint32_t)(at - text);
}

static Span span_of(const Reader *r, const yaml_event_t *event)
{
    return (Span){offset_of(r, event->start_mark), offset_of(r, event->end_mark), r->b->file};
}

static bool next_event(Reader *r, yaml_event_t *event)
{
    if (yaml_parser_parse(&r->parser, event))
        return true;
    if (r->parser.error == YAML_MEMORY_ERROR)
        memory_exhausted();
    const char *problem = r->parser.problem ? r->parser.problem : "not YAML";
    yaml_mark_t mark = r->parser.problem_mark;
    uint32_t at = offset_of(r, mark);
    if (r->parser.error == YAML_READER_ERROR)
        /* reader errors have a byte offset and no mark */
        at = r->b->start + (uint32_t)r->parser.problem_offset;
    const YamlFault fault = {
        problem, at, r->parser.context ? offset_of(r, r->parser.context_mark) : at, r->b->file};
    if (read_common_error(r->session, &fault))
        return false;
    diag_add(r->session, (Span){at, at + 1, r->b->file}, DIAG_syntax, problem);
    if (r->parser.context && r->parser.context_mark.line != mark.line) {
        uint32_t context = offset_of(r, r->parser.context_mark);
        diag_add(r->session, (Span){context, context + 1, r->b->file}, DIAG_syntax_in,
                 r->parser.context);
    }
    return false;
}

static const char *keep_text(Reader *r, const yaml_event_t *event, Span span)
{
    const size_t size = event->data.scalar.length;
    tree_build_check_text(r->b, (const char *)event->data.scalar.value, size, span);
    return memcpy(tree_build_text(r->b, size), event->data.scalar.value, size);
}

static Anchor *anchor_of(const Reader *r, const char *name)
{
    for (HashProbe probe = hash_probe(&r->anchor_index, tree_hash(name, strlen(name)));
         hash_probe_next(&probe);)
        if (!strcmp(r->anchors[probe.number].name, name))
            return &r->anchors[probe.number];
    return NULL;
}

static void keep_anchor(Reader *r, const yaml_char_t *name, Tree *tree)
{
    if (!name)
        return;
    const size_t size = strlen((const char *)name);
    Anchor *given = anchor_of(r, (const char *)name);
    if (given) { /* a name may be redefined */
        tree->name = given->name;
        given->tree = tree;
        return;
    }
    tree->name = memcpy(tree_build_text(r->b, size), name, size);
    Anchor anchor = {tree->name, tree};
    r->anchors =
        tree_build_capacity(r->anchors, r->anchor_count, &r->anchor_capacity, sizeof *r->anchors);
    hash_index_add(NULL, &r->anchor_index, tree_hash(anchor.name, size), (uint32_t)r->anchor_count);
    r->anchors[r->anchor_count++] = anchor;
}

static Tree *find_anchor(Reader *r, const char *name, Span span)
{
    const Anchor *found = anchor_of(r, name);
    if (!found)
        return diag_add(r->session, span, DIAG_unknown_anchor, name);
    Tree *tree = found->tree;
    if (tree->open)
        return diag_add(r->session, span, DIAG_anchor_cycle, name);
    tree->shared = true;
    return tree;
}

static Tree *read_value(Reader *r, yaml_event_t *event, int depth);

/* Reads a list: [ value, ... ] */
static bool read_list(Reader *r, Tree *list, int depth)
{
    const size_t from = r->b->item_count;
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
        tree_build_item(r->b, item);
    }
    tree_build_list(r->b, list, from);
    return true;
}

/* A key with an anchor becomes a value as well: `&a key: 1`, `other: *a`. */
static bool keep_key(Reader *r, const yaml_event_t *event, const Member *member)
{
    Tree *tree = tree_build_value(r->b, TREE_scalar, member->span);
    if (!tree)
        return false;
    tree->text = member->key;
    tree->count = member->size;
    tree->plain = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
    keep_anchor(r, event->data.scalar.anchor, tree);
    return true;
}

/* Converts a key's event to a member without a value; *merge: the key is `<<`. Deletes the
 * event. */
static bool read_key(Reader *r, yaml_event_t *event, Member *member, bool *merge)
{
    *member = (Member){.span = span_of(r, event)};
    bool name = event->type == YAML_SCALAR_EVENT;
    if (name) {
        member->key = keep_text(r, event, member->span);
        member->size = (uint32_t)event->data.scalar.length;
        *merge = !strcmp(member->key, "<<") && event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
        name = !event->data.scalar.anchor || keep_key(r, event, member);
    } else {
        diag_add(r->session, member->span, DIAG_key_not_name);
    }
    yaml_event_delete(event);
    return name;
}

/* `<<: *base` adds the members of base that the object lacks; in `<<: [*a, *b]` earlier bases
 * take precedence. */
static bool merge_members(Reader *r, Tree *object, Tree *base)
{
    return base->kind == TREE_list ? tree_build_merge(r->b, object, base->items, base->count)
                                   : tree_build_merge(r->b, object, &base, 1);
}

/* Reads an object: { name: value, ... } */
static bool read_object(Reader *r, Tree *object, int depth)
{
    const size_t from = r->b->member_count;
    Tree *base = NULL;
    for (yaml_event_t event;;) {
        Member member;
        bool merge = false;
        if (!next_event(r, &event))
            return false;
        if (event.type == YAML_MAPPING_END_EVENT) {
            object->span.end = offset_of(r, event.end_mark);
            yaml_event_delete(&event);
            break;
        }
        if (!read_key(r, &event, &member, &merge) || !next_event(r, &event))
            return false;
        if (!(member.value = read_value(r, &event, depth + 1)))
            return false;
        if (merge && base)
            return diag_add(r->session, member.span, DIAG_duplicate_key, member.key);
        if (merge)
            base = member.value;
        else
            tree_build_member(r->b, member);
    }
    tree_build_object(r->b, object, from);
    return !base || merge_members(r, object, base);
}

static Tree *read_collection(Reader *r, TreeKind kind, Span span, const yaml_char_t *anchor,
                             int depth)
{
    if (depth > LIMIT_DEPTH)
        return diag_add(r->session, span, DIAG_too_deep, LIMIT_DEPTH);
    Tree *tree = tree_build_value(r->b, kind, span);
    if (!tree)
        return NULL;
    keep_anchor(r, anchor, tree);
    tree->open = true;
    bool fine = kind == TREE_list ? read_list(r, tree, depth) : read_object(r, tree, depth);
    tree->open = false;
    return fine ? tree : NULL;
}

/* Reads a value: scalar | list | object | alias. Deletes the event. */
static Tree *read_value(Reader *r, yaml_event_t *event, int depth)
{
    Tree *tree = NULL;
    Span span = span_of(r, event);
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        if (!(tree = tree_build_value(r->b, TREE_scalar, span)))
            break;
        tree->text = keep_text(r, event, span);
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
        diag_add(r->session, span, DIAG_empty_document);
        break;
    }
    yaml_event_delete(event);
    return tree;
}

/* Reads the stream: [ document ] */
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
            return tree ? tree : diag_add(r->session, span, DIAG_empty_document);
        if (type != YAML_DOCUMENT_START_EVENT)
            continue;
        if (tree)
            return diag_add(r->session, span, DIAG_many_documents);
        if (!next_event(r, &event) || !(tree = read_value(r, &event, 0)))
            return NULL;
    }
}

/* Limits the lines that begin with %TAG, anywhere in the text: libyaml parses all of them before
 * its first event. */
static bool check_tags(const TreeBuilder *b, const Source *source)
{
    static const char tag[] = "%TAG";
    const size_t size = sizeof tag - 1;
    int count = 0;
    const char *end = source->text + source->size;
    for (const char *at = source->text + b->start; at && (size_t)(end - at) >= size;) {
        uint32_t offset = (uint32_t)(at - source->text);
        if (!memcmp(at, tag, size) && ++count > LIMIT_TAGS)
            return diag_add(b->session, (Span){offset, offset + (uint32_t)size, b->file},
                            DIAG_too_many_tags, LIMIT_TAGS);
        at = memchr(at, '\n', (size_t)(end - at));
        at = at ? at + 1 : NULL;
    }
    return true;
}

Tree *read_yaml(TreeBuilder *b)
{
    const Source *source = &b->session->sources[b->file];
    if (!check_tags(b, source))
        return NULL;
    Reader reader = {.b = b, .session = b->session};
    map_characters(&reader, source);
    if (!yaml_parser_initialize(&reader.parser))
        memory_exhausted();
    yaml_parser_set_encoding(&reader.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&reader.parser, (const unsigned char *)source->text + b->start,
                                 source->size - b->start);
    Tree *tree = read_stream(&reader);
    yaml_parser_delete(&reader.parser);
    free(reader.anchors);
    hash_index_free(&reader.anchor_index);
    return tree;
}
