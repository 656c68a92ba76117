/* Host program that generates the reference pages (except those of the headers: docs/api.py) and
 * functions.yaml from the tables and the examples. docs OUTPUT_FOLDER EXAMPLES_FOLDER. Pictures
 * are referred to as pictures/<stem of the example>.png; matview renders them. */
#include "docs_formulas.h"
#include "docs_pages.h"
#include "compiler/describe/describe.h"
#include "compiler/matc.h"
#include "compiler/library/reference.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_PATH = 4096 };

static const char *examples; /* folder of the example documents */

static void fail(const char *what, const char *why)
{
    fprintf(stderr, "docs: %s: %s\n", what, why);
    exit(1);
}

/* Returns the text of a file; NULL: unreadable. */
static char *read_file_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    enum { MOST = 1 << 20 };
    char *text = calloc(1, MOST);
    if (!text || fread(text, 1, MOST - 1, file) == MOST - 1 || ferror(file))
        fail(path, "cannot be read");
    fclose(file);
    return text;
}

static void write_file(const char *folder, const char *name, const Text *text)
{
    char path[LONGEST_PATH];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(text->at, 1, text->size, file) != text->size || fclose(file))
        fail(path, "cannot be written");
}

/* Converts a name to camel case: "SunSkyLight" -> "sunSkyLight", "RGBA" -> "rgba". */
static void camel(const char *name, char *out)
{
    for (bool start = true; *name; name++, out++) {
        *out = start ? text_lower(*name) : *name;
        start = start && text_is_upper(name[1]) && !text_is_lower(name[2]);
        out[1] = 0;
    }
}

static bool is_material(Kind kind) { return kind_table[kind].lowering == LOWERING_MATERIAL; }

/* Finds the example of a kind or preset and reads its text. If the file is missing, the name is
 * tried without its last word: sunSky. */
static char *find_example(Kind kind, const char *name, char *stem, char *path)
{
    if (is_material(kind) || strcmp(name, kind_table[kind].name) != 0)
        camel(name, stem);
    else
        strcpy(stem, kind_table[kind].function);
    for (size_t size = strlen(stem); size; stem[size] = 0) {
        int length = snprintf(path, LONGEST_PATH, "%s/%s%s.yaml", examples,
                              is_material(kind) ? "materials/" : "", stem);
        char *text = length < LONGEST_PATH ? read_file_text(path) : NULL;
        if (text)
            return text;
        while (size && !text_is_upper(stem[size]))
            size--;
    }
    fail(name, "has no example");
    return NULL;
}

/* Writes the function main() of the example's program. */
static void put_main(Text *out, Kind kind, const char *path, const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    if (!is_material(kind)) {
        options.pass = "value";
        options.slot = section_of(kind) == SECTION_normal ? "normal" : "diffuse";
    } else if (kind == KIND_SunSkyLight) {
        options.pass = "sky";
    }
    MatcDocument *document = matc_read(path, text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
    if (!fragment)
        fail(path, matc_diagnostics(document, MATC_TEXT));
    text_format(out,
                "\n<details><summary>`main()` of its program for the pass "
                "%s</summary>\n\n```glsl\n%s```\n</details>\n",
                options.pass ? options.pass : "gbuffer", strstr(fragment, "void main()"));
    matc_program_free(program);
    matc_document_free(document);
}

static void put_example(Text *out, Kind kind, const char *name)
{
    char stem[LONGEST_PATH], path[LONGEST_PATH];
    char *text = find_example(kind, name, stem, path);
    text_format(out, "\n![%s](pictures/%s.png)\n\n```yaml\n%s```\n", name, stem, text);
    put_main(out, kind, path, text);
    free(text);
}

/* Writes text in a cell of a table. */
static void put_cell(Text *out, const char *text)
{
    text_put(out, " ");
    for (; *text; text++) {
        if (*text == '|')
            text_char(out, '\\');
        text_char(out, *text);
    }
    text_put(out, " |");
}

static void put_parameters(Text *out, const KindRow *row)
{
    text_put(out, "\n| parameter | type | default | range | |\n| --- | --- | --- | --- | --- |\n");
    for (int i = row->first; i < row->first + row->count; i++) {
        const ParamRow *param = &param_table[i];
        Text initial = text_new(out->arena), range = text_new(out->arena);
        text_put(&range, "");
        describe_default(&initial, param, NULL);
        describe_range(&range, param);
        text_format(out, "| `%s` |", param->name);
        put_cell(out, describe_type(param));
        put_cell(out, initial.at);
        put_cell(out, range.at);
        put_cell(out, param->doc);
        text_char(out, '\n');
    }
}

static void put_aliases(Text *out, Kind kind)
{
    int count = 0;
    for (int i = 0; i < alias_count; i++)
        if (alias_table[i].kind == kind)
            text_format(out, count++ ? ", `%s`" : "\nAlso called `%s`", alias_table[i].alias);
    text_put(out, count ? ".\n" : "");
}

static void put_presets(Text *out, Kind kind)
{
    for (int i = 0; i < preset_count; i++) {
        const PresetRow *row = &preset_table[i];
        if (row->kind != kind || !describe_is_preset_head(i))
            continue;
        text_format(out, "\n#### %s\n\n%s `map: %s` is `map: %s` with", row->name, row->doc,
                    row->name, kind_table[kind].name);
        for (int k = i; k < preset_count && !strcmp(preset_table[k].name, row->name); k++) {
            text_format(out, k > i ? ", `%s` " : " `%s` ", param_table[preset_table[k].param].name);
            text_plain(out, preset_table[k].init);
        }
        text_put(out, ".\n");
        put_example(out, kind, row->name);
    }
}

static void put_kind(Text *out, Kind kind)
{
    const KindRow *row = &kind_table[kind];
    text_format(out, "\n### %s\n\n%s\n", row->name, row->doc);
    put_aliases(out, kind);
    text_format(out, "\n```\n%s\n", kind_table[kind].formula);
    describe_translations(out, kind, "");
    text_put(out, "```\n");
    put_parameters(out, row);
    text_format(out, "\nAnswers: %s\n", kind_table[kind].answers);
    put_example(out, kind, row->name);
    put_presets(out, kind);
}

static double wave_value(WaveKind kind, double v)
{
    switch (kind) {
#define WAVE(name, reference, build, doc)                                                          \
    case WAVE_##name:                                                                              \
        return reference;
#include "grammar/waves.def"
    default:
        return v;
    }
}

static void put_waves(Text *out)
{
    static const double points[] = {-1, -0.5, 0, 0.25, 0.5, 1};
    enum { POINT_COUNT = sizeof points / sizeof *points };
    text_put(out, "\n## Waves\n\n`waveForm: NAME` sends a volume map's value through a function of "
                  "a number v.\n"
                  "`{ wave: Chain, first: A, factor: 1, shift: 0, second: B }` is " CHAIN_DOC
                  "\n\n| wave | |");
    for (int i = 0; i < POINT_COUNT; i++)
        text_format(out, i ? " %s |" : " at v = %s |",
                    (char *[]){"-1", "-1/2", "0", "1/4", "1/2", "1"}[i]);
    text_put(out, "\n| --- | --- |");
    for (int i = 0; i < POINT_COUNT; i++)
        text_put(out, " ---: |");
    for (int kind = 0; kind < WAVE_COUNT; kind++) {
        text_format(out, "\n| `%s` |", wave_table[kind].name);
        put_cell(out, wave_table[kind].doc);
        for (int i = 0; i < POINT_COUNT; i++) {
            Text number = text_new(out->arena);
            double value = wave_value((WaveKind)kind, points[i]);
            text_rounded(&number, fabs(value) < 1e-9 ? 0 : value, 4);
            put_cell(out, number.at);
        }
    }
    text_char(out, '\n');
}

/* Writes tables whose rows have a name and a doc. */
#define LIST(out, title, what, table, count)                                                       \
    do {                                                                                           \
        text_format(out, "\n## %s\n\n| %s | |\n| --- | --- |\n", title, what);                     \
        for (int i = 0; i < (count); i++) {                                                        \
            text_format(out, "| `%s` |", (table)[i].name);                                         \
            put_cell(out, (table)[i].doc);                                                         \
            text_char(out, '\n');                                                                  \
        }                                                                                          \
    } while (0)

static void put_contents(Text *out)
{
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        const SectionRow *section = &section_table[section_of((Kind)kind)];
        char anchor[LONGEST_PATH] = "";
        for (size_t i = 0; kind_table[kind].name[i]; i++)
            anchor[i] = text_lower(kind_table[kind].name[i]), anchor[i + 1] = 0;
        if (section->first == kind)
            text_format(out, "\n- %s: ", section->title);
        text_format(out, section->first == kind ? "[%s](#%s)" : ", [%s](#%s)",
                    kind_table[kind].name, anchor);
    }
    text_char(out, '\n');
}

static void put_reference(Text *out)
{
    text_put(out, "# Maps and materials\n\n"
                  "Made from matc's tables and examples, as of version " MATC_VERSION ".\n");
    put_contents(out);
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        const SectionRow *section = &section_table[section_of((Kind)kind)];
        if (section->first == kind)
            text_format(out, "\n## %s\n", section->title);
        put_kind(out, (Kind)kind);
    }
    docs_functions(out);
    docs_library(out);
    put_waves(out);
    LIST(out, "Channels", "channel", channel_table, CHANNEL_COUNT);
    LIST(out, "Slots", "slot", slot_table, SLOT_COUNT);
    LIST(out, "Targets", "target", target_table, TARGET_COUNT);
    LIST(out, "Passes", "pass", pass_table, PASS_COUNT);
    LIST(out, "Normals of a G-buffer", "space", normals_table, NORMALS_COUNT);
    text_put(out, "\n## Variants\n\n| option | choice | |\n| --- | --- | --- |\n");
    for (int i = 0; i < CHOICE_COUNT; i++) {
        const AxisRow *axis = &axis_table[choice_table[i].axis];
        text_format(out, "| `--%s` | `%s`%s | %s |\n", axis->name, choice_table[i].name,
                    axis->first == i ? " (default)" : "", choice_table[i].doc);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fputs("usage: docs OUTPUT_FOLDER EXAMPLES_FOLDER\n", stderr);
        return 2;
    }
    examples = argv[2];
    Arena arena = {0};
    static const struct {
        const char *name;
        void (*put)(Text *);
    } files[] = {{"functions.yaml", docs_function_document},
                 {"reference.md", put_reference},
                 {"scenes.md", docs_scenes},
                 {"diagnostics.md", docs_diagnostics},
                 {"layout-tables.md", docs_layouts}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        Text text = text_new(&arena);
        files[i].put(&text);
        write_file(argv[1], files[i].name, &text);
    }
    arena_free(&arena);
    return 0;
}
