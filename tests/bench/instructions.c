/* matbench instructions: compares our shader with a hand-written one for the same material. Both
 * go through glslang and spirv-opt -O, and the SPIR-V instructions within functions are counted.
 * The hand-written shaders do not filter, so ours are compiled with --aa=none. The documents and
 * shaders are in tests/bench/; formulas have theirs in formulas.def. Also a test: no shader of
 * ours may have more than LARGEST_RATIO times the instructions; exit status 77 without
 * spirv-opt. */
#include "matbench.h"
#include "compiler/base/session.h"
#include "compiler/matc.h"
#include "compiler/emit/validate.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double LARGEST_RATIO = 1.05;

enum { SKIPPED = 77 }; /* ctest's status for skipped tests */
enum {
    OP_EXTENDED = 12,
    OP_FUNCTION = 54,
    OP_LABEL = 248,
    HEADER_WORDS = 5,
    EXTENDED_SMOOTHSTEP = 49,
    SMOOTHSTEP_OPERATIONS = 7,
    LONGEST_PATH = 1024,
    LARGEST_WORDS = 1 << 20,
    LARGEST_FORMULA = 1024,
    LARGEST_SHADER = 1 << 13
};

static const char *const names[] = {"plain",         "checker",   "uvChecker", "wood",
                                    "granite",       "marble",    "image",     "bumpImage",
                                    "volumeChecker", "sideSwitch"};
enum { NAME_COUNT = sizeof names / sizeof *names };

/* Counts instructions from the first function on, without labels. A smoothstep of SPIR-V counts
 * as its definition, which is what matc writes: t = clamp((x - low) * scale, 0, 1), t * t (3 - 2
 * * t). */
static int count_instructions(const uint32_t *words, size_t count)
{
    int instructions = 0;
    bool inside = false;
    for (size_t at = HEADER_WORDS; at < count && words[at] >> 16; at += words[at] >> 16) {
        uint32_t op = words[at] & 0xFFFF;
        inside |= op == OP_FUNCTION;
        instructions += inside && op != OP_LABEL;
        if (op == OP_EXTENDED && words[at + 4] == EXTENDED_SMOOTHSTEP)
            instructions += SMOOTHSTEP_OPERATIONS - 1;
    }
    return instructions;
}

/* spirv-opt is required. */
static bool has_spirv_opt(void)
{
    if (!system("spirv-opt --version >/dev/null 2>&1"))
        return true;
    fputs("matbench: spirv-opt is not installed (Debian: spirv-tools), and it is what instructions "
          "are counted behind\n",
          stderr);
    return false;
}

/* Count after spirv-opt -O; -1 if that fails. */
static int optimised_count(const void *spirv, size_t size)
{
    char from[] = "/tmp/matbenchXXXXXX", to[sizeof from + 4], command[2 * sizeof from + 64];
    static uint32_t words[LARGEST_WORDS];
    int file = mkstemp(from), count = -1;
    snprintf(to, sizeof to, "%s.opt", from);
    if (file < 0 || write(file, spirv, size) != (ssize_t)size || close(file))
        return -1;
    snprintf(command, sizeof command, "spirv-opt -O %s -o %s", from, to);
    FILE *result = system(command) ? NULL : fopen(to, "rb");
    if (result) {
        count = count_instructions(words, fread(words, sizeof *words, LARGEST_WORDS, result));
        fclose(result);
    }
    remove(from);
    remove(to);
    return count;
}

static char *read_text(const char *name, const char *suffix, char *path, size_t *size)
{
    snprintf(path, LONGEST_PATH, "%s/tests/bench/shaders/%s%s", SOURCE_FOLDER, name, suffix);
    FILE *file = fopen(path, "rb");
    char *text = calloc(1, 1 << 20);
    if (!file || !text) {
        free(text);
        return NULL;
    }
    *size = fread(text, 1, (1 << 20) - 1, file);
    fclose(file);
    return text;
}

int bench_count(const char *path, const char *text, size_t size, const char *layout)
{
    size_t spirv_size = 0;
    MatcOptions options;
    matc_options_init(&options);
    options.target = "spirv";
    options.layout = layout;
    options.aa = "none"; /* the hand-written programs do not filter */
    MatcDocument *document = matc_read(path, text, size, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_SPIRV, &options);
    const char *spirv = matc_output(program, MATC_SPIRV, &spirv_size);
    const int count = spirv ? optimised_count(spirv, spirv_size) : -1;
    if (!spirv)
        fprintf(stderr, "%s%s", matc_diagnostics(document, MATC_TEXT),
                matc_program_diagnostics(program, MATC_TEXT));
    matc_program_free(program);
    matc_document_free(document);
    return count;
}

static int count_shader(const char *path, const char *text)
{
    const char *log = "";
    Arena arena = {0};
    MatcOptions options;
    matc_options_init(&options);
    Session session = {.arena = &arena, .options = &options};
    ValidateWords words;
    const bool fine =
        text &&
        validate_to_spirv(&session, &(ValidateStages){{[VALIDATE_fragment] = text}}, &words, &log);
    const int count =
        fine ? optimised_count(words.at[VALIDATE_fragment], words.size[VALIDATE_fragment]) : -1;
    if (!fine)
        fprintf(stderr, "%s: %s\n", path, log);
    arena_free(&arena);
    return count;
}

static int ours(const char *name)
{
    char path[LONGEST_PATH];
    size_t size = 0;
    char *text = read_text(name, ".yaml", path, &size);
    /* the same for our program */
    const int count = bench_count(path, text ? text : "", size, "thesis");
    free(text);
    return count;
}

static int by_hand(const char *name)
{
    char path[LONGEST_PATH];
    size_t size = 0;
    char *text = read_text(name, ".frag", path, &size);
    const int count = count_shader(path, text);
    free(text);
    return count;
}

typedef struct {
    const char *name, *formula, *hand;
} Formula;
static const Formula formulas[] = {
#define FORMULA(name, formula, hand) {#name, formula, hand},
#include "formulas.def"
};
enum { FORMULA_COUNT = sizeof formulas / sizeof *formulas };

static int formula_ours(const Formula *formula)
{
    char text[LARGEST_FORMULA];
    const int size =
        snprintf(text, sizeof text, "material: Phong\ndiffuse: \"= %s\"\n", formula->formula);
    return bench_count(formula->name, text, (size_t)size, "thesis");
}

/* The row's GLSL replaces the frame's mark. */
static int formula_by_hand(const Formula *formula)
{
    static const char mark[] = "// FORMULA";
    char path[LONGEST_PATH], text[LARGEST_SHADER];
    size_t size = 0;
    char *frame = read_text("formula", ".frag", path, &size);
    const char *at = frame ? strstr(frame, mark) : NULL;
    if (at)
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - frame), frame, formula->hand,
                 at + strlen(mark));
    const int count = count_shader(path, at ? text : NULL);
    free(frame);
    return count;
}

/* Returns false if a count is missing, or ours is too large. */
static bool put_row(const char *name, int hand, int mine)
{
    const double ratio = (double)mine / hand;
    printf("%-14s %8d %8d %8.3f\n", name, hand, mine, ratio);
    if (ratio > LARGEST_RATIO)
        fprintf(stderr,
                "matbench: %s has more than %g times the instructions of what is written by hand\n",
                name, LARGEST_RATIO);
    return hand >= 0 && mine >= 0 && ratio <= LARGEST_RATIO;
}

int bench_instructions(const BenchOptions *options)
{
    (void)options;
    bool fine = true;
    if (!has_spirv_opt())
        return SKIPPED;
    printf("both --layout=thesis --aa=none\n");
    printf("material        by hand     matc    ratio\n");
    for (int i = 0; i < NAME_COUNT; i++)
        fine &= put_row(names[i], by_hand(names[i]), ours(names[i]));
    printf("\nformula         by hand     matc    ratio\n");
    for (int i = 0; i < FORMULA_COUNT; i++)
        fine &=
            put_row(formulas[i].name, formula_by_hand(&formulas[i]), formula_ours(&formulas[i]));
    return !fine;
}
