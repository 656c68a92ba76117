/* Reads a command line by a table of options, and prints --help from it. */
#include "compiler/base/option.h"
#include <stdlib.h>

enum { SHORT = 2, HELP_LABEL = 21 };

typedef struct {
    const OptionTable *table;
    void *to;
    Arena *arena;
} Reader;

const char *option_word(const void *user, int i) { return ((const char *const *)user)[i]; }

const char *option_fault_value(Arena *arena, const char *option, const char *value,
                               const NameChoice *values)
{
    Text out = text_new(arena);
    text_format(&out, "%s: unknown value '%s'; expected %s%s", option, value,
                suggest_list(arena, values),
                suggest(arena, value, values->name, values->user, values->count));
    return out.at;
}

const char *option_fault_number(Arena *arena, const char *wants, const char *value)
{
    Text out = text_new(arena);
    text_format(&out, "%s, not '%s'", wants, value);
    return out.at;
}

static const char *say(Arena *arena, const char *name, const char *what)
{
    Text out = text_new(arena);
    text_format(&out, "%s%s", name, what);
    return out.at;
}

/* Returns the index of a word; -1: none. */
static int find_word(const NameChoice *words, const char *word, size_t size)
{
    for (int i = 0; i < words->count; i++) {
        const char *name = words->name(words->user, i);
        if (name && strlen(name) == size && !strncmp(name, word, size))
            return i;
    }
    return -1;
}

static const char *store_set(const Reader *r, const Option *option, bool *set, const char *list)
{
    bool any = false;
    memset(set, 0, sizeof *set * (size_t)option->words.count);
    for (size_t size; *list; list += size + (list[size] == ',')) {
        size = strcspn(list, ",");
        const int i = find_word(&option->words, list, size);
        if (i < 0)
            return option_fault_value(r->arena, option->name, arena_string(r->arena, list, size),
                                      &option->words);
        set[i] = any = true;
    }
    return any ? NULL : say(r->arena, option->name, " names nothing");
}

static void store_list(const Reader *r, const Option *option, const char *value)
{
    const char ***list = (void *)((char *)r->to + option->place);
    int *count = (void *)((char *)r->to + option->count_place);
    const char **longer = ARENA_ARRAY(r->arena, const char *, *count + 1);
    for (int i = 0; i < *count; i++)
        longer[i] = (*list)[i];
    longer[(*count)++] = value;
    *list = longer;
}

static const char *store_int(const Reader *r, const Option *option, int *to, const char *value)
{
    char *end;
    long number = strtol(value, &end, 10);
    if (option->clamped && number > option->max)
        number = (long)option->max;
    if (*end || end == value || number < option->min || number > option->max)
        return option_fault_number(r->arena, option->wants, value);
    *to = (int)number;
    return NULL;
}

static const char *store_real(const Reader *r, const Option *option, double *to, const char *value)
{
    if (!text_number(value, strlen(value), to) || !(*to >= option->min && *to <= option->max))
        return option_fault_number(r->arena, option->wants, value);
    return NULL;
}

static const char *store(const Reader *r, const Option *option, const char *value)
{
    void *at = (char *)r->to + option->place;
    int word = 0;
    if (option->kind == OPTION_word || option->kind == OPTION_index)
        word = find_word(&option->words, value, strlen(value));
    if (word < 0)
        return option_fault_value(r->arena, option->name, value, &option->words);
    if (option->set)
        return option->set(r->to, option, value);
    switch (option->kind) {
    case OPTION_heading:
        break;
    case OPTION_flag:
    case OPTION_clear:
        *(bool *)at = option->kind == OPTION_flag;
        break;
    case OPTION_maybe:
    case OPTION_text:
    case OPTION_word:
        *(const char **)at = value ? value : option->otherwise;
        break;
    case OPTION_index:
        *(int *)at = word;
        break;
    case OPTION_list:
        store_list(r, option, value);
        break;
    case OPTION_int:
        return store_int(r, option, at, value);
    case OPTION_real:
        return store_real(r, option, at, value);
    case OPTION_set:
        return store_set(r, option, at, value);
    }
    return NULL;
}

/* Returns the fault "--aa wants a value: auto, none, box, aniso". */
static const char *missing_value(const Reader *r, const Option *option)
{
    NameChoice values = option->words;
    Text out = text_new(r->arena);
    text_format(&out, "%s expects a value", option->name);
    if (values.count || (r->table->values && r->table->values(option->name, &values)))
        text_format(&out, ": %s", suggest_list(r->arena, &values));
    return out.at;
}

static const char *option_name(const void *user, int i)
{
    const Option *option = (const Option *)user + i;
    return option->kind == OPTION_heading ? NULL : option->name;
}

static const char *unknown(const Reader *r, const char *argument)
{
    const char *name = arena_string(r->arena, argument, strcspn(argument, "="));
    const NameChoice names = {option_name, r->table->rows, r->table->count};
    Text out = text_new(r->arena);
    if (find_word(&names, name, strlen(name)) >= 0)
        return say(r->arena, name, " takes no value");
    text_format(&out, "unknown option '%s'%s", name,
                suggest(r->arena, name, names.name, names.user, names.count));
    return out.at;
}

/* Reads "--name", "--name=value", "--name value", "-o value" or "-ovalue". *next is the
 * following argument or NULL; *next becomes NULL if that argument was used as the value. */
static const char *read_one(const Reader *r, const char *argument, const char **next)
{
    for (int i = 0; i < r->table->count; i++) {
        const Option *option = &r->table->rows[i];
        const size_t size = option->kind == OPTION_heading ? 0 : strlen(option->name);
        const bool bare = option->kind == OPTION_flag || option->kind == OPTION_clear;
        const char *value = argument + size;
        if (!size || strncmp(argument, option->name, size) != 0)
            continue;
        if (!*value && (bare || option->kind == OPTION_maybe))
            return store(r, option, NULL);
        if (bare || (*value && *value != '=' && size != SHORT))
            continue;
        if (*value)
            return store(r, option, value + (*value == '='));
        if (!*next)
            return missing_value(r, option);
        value = *next;
        *next = NULL;
        return store(r, option, value);
    }
    return unknown(r, argument);
}

const char *option_read(const OptionTable *table, void *to, Arena *arena, int argc, char **argv)
{
    const Reader r = {table, to, arena};
    const char *fault = NULL;
    bool literal = false;
    for (int i = 1; i < argc && !fault; i++) {
        const char *argument = argv[i], *next = i + 1 < argc ? argv[i + 1] : NULL, *before = next;
        if (!literal && !strcmp(argument, "--"))
            literal = true;
        else if (literal || argument[0] != '-' || !argument[1])
            fault = table->input(to, argument, literal);
        else
            fault = read_one(&r, argument, &next);
        i += next != before;
    }
    return fault;
}

/* -- Output of --help */

static void put_spaces(Text *out, size_t count)
{
    while (count--)
        text_char(out, ' ');
}

static void put_row(Text *out, const Option *option)
{
    const char *label = option->label ? option->label : "", *help = option->help;
    const size_t size = strlen(option->name) + strlen(label);
    text_format(out, "  %s%s", option->name, label);
    if (*help || option->put_help)
        put_spaces(out, size < HELP_LABEL ? HELP_LABEL - size : 0);
    if (size > HELP_LABEL) {
        text_char(out, '\n');
        put_spaces(out, 2 + HELP_LABEL);
    }
    if (option->put_help)
        option->put_help(out);
    for (size_t line; *help; help += line + 1) {
        line = strcspn(help, "\n");
        text_add(out, help, line);
        if (!help[line])
            break;
        text_char(out, '\n');
        put_spaces(out, 2 + HELP_LABEL);
    }
    text_char(out, '\n');
}

void option_put_help(Text *out, const Option *rows, int count)
{
    for (int i = 0; i < count; i++)
        if (rows[i].kind == OPTION_heading)
            text_put(out, rows[i].help);
        else if (rows[i].help)
            put_row(out, &rows[i]);
}
