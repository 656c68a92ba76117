/* Names temporaries and uniform block members after the author's names.
 *
 *     defs: { clay: { map: Blend, input: { map: Granite } } }   clay; its input clay_granite
 *     diffuse: { map: Blend }                                   diffuse_blend
 *     defs: { mix: { map: Blend } }                             blend_mix: mix is reserved
 *     an unnamed Mix without an owner                           mix_map
 *     defs: { "Lehm, naß": { map: Blend } }                     Lehm_na */
#include "compiler/ir/ir.h"
#include "compiler/graph/reserved.h"
#include "compiler/base/text.h"
#include <string.h>

enum { LONGEST_WORD = 32 }; /* characters of an author's name in an identifier or comment */

/* Appends the word's letters and digits; each run of other characters in between becomes an
 * underscore. */
static void put_identifier(Text *name, const char *word)
{
    const size_t before = name->size;
    bool gap = false;
    for (; *word && name->size - before < LONGEST_WORD; word++) {
        bool fits = text_is_alphanumeric(*word);
        if (fits && gap && name->size > before)
            text_char(name, '_');
        if (fits)
            text_char(name, *word);
        gap = !fits;
    }
}

static bool is_usable(const char *name)
{
    return text_is_letter(name[0]) && !reserved_is_word(name);
}

/* Joins owner, kind and own name, except those that are NULL. */
static const char *join_words(Arena *arena, const char *owner, const char *kind, const char *word)
{
    const char *const words[] = {owner, kind, word};
    Text name = text_new(arena);
    for (int i = 0; i < 3; i++) {
        Text own = text_new(arena);
        if (words[i])
            put_identifier(&own, words[i]);
        if (own.size && name.size)
            text_char(&name, '_');
        text_add(&name, own.at, own.size);
    }
    return name.size ? name.at : "";
}

/* Returns the simplest of the candidates that is a legal GLSL identifier. */
static const char *name_of(Arena *arena, const Node *map)
{
    const char *kind = kind_table[map->kind].function;
    const char *plain = map->name ? join_words(arena, NULL, NULL, map->name)
                                  : join_words(arena, map->owner, kind, NULL);
    if (is_usable(plain))
        return plain;
    const char *named = join_words(arena, NULL, kind, map->name ? map->name : map->owner);
    return is_usable(named) ? named : join_words(arena, NULL, kind, "map");
}

/* Returns true if a name can be used in a comment: printable ASCII, without the backslash, which
 * would join lines. */
static bool is_plain(const char *word)
{
    size_t size = strlen(word);
    for (const char *c = word; *c; c++)
        if (*c < ' ' || *c > '~' || *c == '\\')
            return false;
    return size > 0 && size <= LONGEST_WORD;
}

const char *ir_origin_title(const Node *map)
{
    return map->name && is_plain(map->name) ? map->name : kind_table[map->kind].name;
}

const char *ir_origin_name(Arena *arena, const Ir *ir, uint32_t origin)
{
    if (origin == ORIGIN_SURFACE)
        return "surface";
    return origin < ORIGIN_MAPS ? slot_table[origin - ORIGIN_SLOTS].name
                                : name_of(arena, ir_origin_map(ir, origin));
}

uint32_t ir_origin(Ir *ir, const Node *map)
{
    const uint32_t hash = hash_pointer(map);
    for (HashProbe probe = hash_probe(&ir->map_index, hash); hash_probe_next(&probe);)
        if (ir->maps[probe.number] == map)
            return ORIGIN_MAPS + probe.number;
    hash_index_add(ir->arena, &ir->map_index, hash, (uint32_t)ir->map_count);
    ARENA_PUSH(ir->arena, ir->maps, ir->map_count, ir->map_capacity, map);
    return ORIGIN_MAPS + (uint32_t)ir->map_count - 1;
}
