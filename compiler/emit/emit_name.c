/* Names of temporaries, and source positions in comments.
 *
 *     // brick.yaml:19 Granite
 *     float clay_granite = granite(localPosition * 3.5);
 *     // brick.yaml:16 clay
 *     vec3 clay_1 = mix(vec3(0.1, 0.01, 0.0), vec3(0.3, 0.05, 0.02), ...);    intermediate
 *     vec3 clay = mix(clay_1, vec3(0.5, 0.15, 0.05), ...);                    the map's value */
#include "compiler/emit/emit_scope.h"
#include <string.h>

enum { LONGEST_FILE = 40 }; /* characters of a file's name in a comment */

/* Returns true if a name is used by a uniform, a member of the constants' block, or a function. */
static bool is_taken(const Scope *e, const char *name)
{
    if (names_find(&e->ir->graph->uniform_names, name) >= 0 || names_find(&e->constants, name) >= 0)
        return true;
    /* function names have no underscore: test_tables */
    const int functions = strchr(name, '_') ? 0 : FUNCTION_COUNT;
    for (int i = 0; i < functions; i++) {
        const char *other = function_row(i)->name;
        /* fast path: most names differ in the first letter */
        if (other && *other == *name && !strcmp(other, name))
            return true;
    }
    return false;
}

static const char *free_name(Scope *e, const char *wanted)
{
    const char *name = names_fresh(e->scratch, &e->fresh, wanted);
    while (is_taken(e, name))
        name = names_fresh(e->scratch, &e->fresh, wanted);
    return name;
}

/* Returns the naming of an origin; all its temporaries share a stem. */
static Naming *naming_of(Scope *e, uint32_t origin)
{
    Naming *naming = &e->naming[origin];
    if (naming->scope == e->number)
        return naming;
    const char *name = free_name(e, ir_origin_name(e->scratch, e->ir, origin));
    *naming = (Naming){.scope = e->number, .valued = naming->valued, .name = name};
    return naming;
}

const char *emit_new_name(Scope *e, const IrNode *node)
{
    Naming *naming = naming_of(e, node->origin);
    Text step = text_new(e->scratch);
    if (node->type == TYPE_uint || node->type == TYPE_uvec4) {
        text_put(&step, naming->name);
        text_put(&step, "_bits");
        return free_name(e, step.at);
    }
    const bool head = node->flags & NODE_head,
               plain = !naming->given && (head || naming->valued != e->number);
    naming->given |= plain;
    naming->steps += !head || !plain;
    if (plain)
        return naming->name;
    text_put(&step, naming->name);
    text_char(&step, '_');
    text_int(&step, naming->steps);
    return free_name(e, step.at);
}

void emit_forget_names(Scope *e)
{
    e->number++;
    e->fresh = (FreshNames){0};
    for (size_t i = 0; i < e->s.nodes.count; i++) {
        const IrNode *node = ir_at(e->ir, e->s.nodes.at[i]);
        if (ir_is_head(e->ir, e->s.nodes.at[i]) && !emit_is_leaf(e->ir, e->s.nodes.at[i]))
            e->naming[node->origin].valued = e->number;
    }
}

static const Lines *lines_of(Scope *e, uint32_t file)
{
    const Source *source = &e->session->sources[file];
    Lines *lines = &e->lines[file];
    uint32_t start = 0;
    if (lines->count)
        return lines;
    ARENA_PUSH(e->scratch, lines->starts, lines->count, lines->capacity, start);
    for (const char *at = source->text;
         (at = memchr(at, '\n', (size_t)(source->text + source->size - at)));) {
        start = (uint32_t)(++at - source->text);
        ARENA_PUSH(e->scratch, lines->starts, lines->count, lines->capacity, start);
    }
    return lines;
}

/* Returns the line number, from 1: the last line that begins at or before the offset. */
static size_t line_of(const Lines *lines, uint32_t offset)
{
    size_t low = 0, high = lines->count;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (lines->starts[middle] <= offset)
            low = middle;
        else
            high = middle;
    }
    return low + 1;
}

/* Appends the file's name without its folder, so that programs do not depend on the working
 * directory. Characters that are not allowed in a comment become underscores. */
static void put_file(Text *note, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    for (int i = 0; name[i] && i < LONGEST_FILE; i++)
        text_char(note, name[i] < ' ' || name[i] > '~' || name[i] == '\\' ? '_' : name[i]);
}

const char *emit_origin_note(Scope *e, const IrNode *node)
{
    const Node *map = ir_origin_map(e->ir, node->origin);
    if (!map || e->naming[node->origin].scope == e->number ||
        map->span.file >= e->session->source_count)
        return "";
    Text note = text_new(e->scratch);
    put_file(&note, e->session->sources[map->span.file].name);
    text_char(&note, ':');
    text_int(&note, (long)line_of(lines_of(e, map->span.file), map->span.start));
    text_char(&note, ' ');
    text_put(&note, ir_origin_title(map));
    return note.at;
}
