/* Words of the command line, a row for each option that takes one of a few. */
#include "runtime/view/words.h"
#include "compiler/base/suggest.h"
#include "runtime/gl/context.h"
#include "runtime/gl/shape.h"
#include "runtime/scene/scene.h"
#include "runtime/view/slot.h"
#include <stdio.h>
#include <string.h>

static const char *shape_word(const void *user, int i)
{
    (void)user;
    return shape_name((ShapeKind)i);
}

static const char *gl_word(const void *user, int i)
{
    (void)user;
    return gl_kind_name((GlKind)i);
}

static const char *slot_word(const void *user, int i)
{
    (void)user;
    return slot_look_name(i);
}

static const char *shadows_word(const void *user, int i)
{
    (void)user;
    return scene_shadows_name((Word)i);
}

static const char *indirect_word(const void *user, int i)
{
    (void)user;
    return scene_indirect_name((Word)i);
}

static const char *list_word(const void *user, int i) { return ((const char *const *)user)[i]; }

#define WORDS(...)                                                                                                     \
    {                                                                                                                  \
        list_word, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)     \
    }
static const struct {
    const char *option;
    NameChoice words;
    bool several; /* with commas between them */
} rows[] = {
    {"--shape", {shape_word, NULL, SHAPE_count}, false},
    {"--gl", {gl_word, NULL, GL_KIND_count}, false},
    {"--slot", {slot_word, NULL, SLOT_LOOK_COUNT}, false},
    {"--pass", WORDS("gbuffer", "sky"), false},
    {"--edges", WORDS("coverage", "none"), false},
    {"--format", WORDS("png", "exr"), false},
    {"--shadows", {shadows_word, NULL, WORD_COUNT}, false},
    {"--indirect", {indirect_word, NULL, WORD_COUNT}, false},
    {"--compare", WORDS("shadows", "indirect", "displacement"), false},
    {"--transparency", WORDS("auto", "lists", "peeling"), false},
    {"--lights", WORDS("auto", "bounded", "all"), false},
    {"--tools", WORDS("grid", "axes", "lights", "none"), true},
    {"--emit", WORDS("frame"), false},
};

static bool is_one(const NameChoice *words, const char *word)
{
    for (int i = 0; i < words->count; i++) {
        const char *name = words->name(words->user, i);
        if (name && !strcmp(name, word))
            return true;
    }
    return false;
}

static const char *say(WordsRoom room, const char *option, const char *word, const NameChoice *words)
{
    Arena arena = {0};
    snprintf(room.text, room.size, "%s: there is no '%s', but %s%s", option, word, suggest_list(&arena, words),
             suggest(&arena, word, words->name, words->user, words->count));
    arena_free(&arena);
    return room.text;
}

static const char *words_of(WordsRoom room, int row, const char *value)
{
    Arena arena = {0};
    const char *fault = NULL;
    for (const char *at = value; at && !fault; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
        const char *word = arena_string(&arena, at, rows[row].several ? strcspn(at, ",") : strlen(at));
        if (!is_one(&rows[row].words, word))
            fault = say(room, rows[row].option, word, &rows[row].words);
    }
    arena_free(&arena);
    return fault;
}

const char *words_fault(WordsRoom room, const char *option, const char *value)
{
    for (int i = 0; i < (int)(sizeof rows / sizeof *rows); i++)
        if (!strcmp(rows[i].option, option))
            return words_of(room, i, value);
    return NULL;
}

enum { OPTIONS = 128 };
typedef struct {
    const char *names[OPTIONS];
    int count;
} OptionNames;

/* Each "--name" in it, and the two that are letters. */
static OptionNames names_in(Arena *arena, const char *help)
{
    OptionNames found = {{"-o", "-d"}, 2};
    for (const char *at = help; (at = strstr(at, "--")) && found.count < OPTIONS; at += 2) {
        const size_t size = 2 + strspn(at + 2, "abcdefghijklmnopqrstuvwxyz");
        if (size > 2)
            found.names[found.count++] = arena_string(arena, at, size);
    }
    return found;
}

const char *words_option(WordsRoom room, const char *option, const char *wrong)
{
    Arena arena = {0};
    const char *name = arena_string(&arena, option, strcspn(option, "="));
    const OptionNames found = names_in(&arena, room.help);
    if (is_one(&(NameChoice){list_word, found.names, found.count}, name))
        snprintf(room.text, room.size, "%s %s", name, wrong);
    else
        snprintf(room.text, room.size, "there is no option '%s'%s", name,
                 suggest(&arena, name, list_word, found.names, found.count));
    arena_free(&arena);
    return room.text;
}

const char *words_number(WordsRoom room, const char *wants, const char *value)
{
    snprintf(room.text, room.size, "%s, not '%s'", wants, value);
    return room.text;
}
