/* The parser of command lines that matc, matview and matbench share. A program has a table with a
 * row for each option: its name, the kind of its value, the member that stores it, and its text in
 * --help.
 *
 *     {"--size", OPTION_int, offsetof(Command, size), .label = "=N", .min = 1, .max = 16384,
 *      .wants = "--size wants a number from 1 to 16384", .help = "pixels of an edge: 512"}
 *
 *     --size=9, --size 9                  command.size = 9
 *     --size=0                            "--size wants a number from 1 to 16384, not '0'"
 *     --sice=9                            "there is no option '--sice'; did you mean '--size'?"
 *     --help                              "  --size=N             pixels of an edge: 512" */
#ifndef MATC_OPTION_H
#define MATC_OPTION_H
#include "compiler/base/suggest.h"
#include "compiler/base/text.h"

typedef enum {
    OPTION_heading, /* not an option: --help prints `help` unchanged */
    OPTION_flag,    /* sets a bool to true */
    OPTION_clear,   /* sets a bool to false */
    OPTION_text,    /* the argument as a const char * */
    OPTION_maybe,   /* const char *; `otherwise` if the value is missing, as in "--list" */
    OPTION_list,    /* const char **, and an int count at `count_place`; each use adds a string */
    OPTION_int,     /* int, from min to max */
    OPTION_real,    /* double, from min to max */
    OPTION_word,    /* const char *, one of `words` */
    OPTION_index,   /* int or enum, the index of one of `words` */
    OPTION_set,     /* bool[words.count]: the words between commas; the last use counts */
} OptionKind;

typedef struct Option Option;
struct Option {
    const char *name; /* name "--size"; "-o" also takes its value without a space: "-oFILE" */
    OptionKind kind;
    size_t place, count_place; /* offsets of the value and of its count in the program's struct */
    NameChoice words;
    const char *otherwise;
    double min, max;
    bool clamped;      /* an int above max becomes max */
    const char *wants; /* fault for a bad value: "--size wants a number from 1 to 16384" */
    /* Stores the value in place of the parser, which has already checked it against `words`.
     * `value` is NULL if it is missing. Returns NULL or a fault. */
    const char *(*set)(void *to, const Option *option, const char *value);
    const char *label;           /* text that follows the name in --help: "=N" */
    const char *help;            /* lines of --help; NULL: another row describes the option */
    void (*put_help)(Text *out); /* writes names from tables ahead of `help`; NULL: no names */
};

typedef struct {
    const Option *rows;
    int count;
    /* Finds the values of an option without `words`, so that a fault can list the values; NULL:
     * unknown. */
    bool (*values)(const char *name, NameChoice *values);
    /* Takes an argument that is not an option. `literal`: it follows "--". Returns NULL or a
     * fault. */
    const char *(*input)(void *to, const char *argument, bool literal);
} OptionTable;

/* Reads argv from argv[1] on into the struct `to`. Returns NULL or the first fault, in the
 * arena. */
const char *option_read(const OptionTable *table, void *to, Arena *arena, int argc, char **argv);
/* Appends each row's lines of --help: name and label, then the text from column 23 on. */
void option_put_help(Text *out, const Option *rows, int count);

/* Returns the fault "--target: there is no 'hlsl', but glsl110, ...; did you mean ...?". */
const char *option_fault_value(Arena *arena, const char *option, const char *value,
                               const NameChoice *values);
/* Returns the fault "--size wants a number, not 'x'". */
const char *option_fault_number(Arena *arena, const char *wants, const char *value);

/* OPTION_WORDS("a", "b") is a NameChoice of these words; option_word returns the i-th. */
const char *option_word(const void *user, int i);
#define OPTION_WORDS(...)                                                                          \
    {                                                                                              \
        option_word, (const char *const[]){__VA_ARGS__},                                           \
            sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)                            \
    }
#endif
