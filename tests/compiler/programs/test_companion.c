/* Texts that accompany a fragment program are complete: the code that unpacks a layout and the
 * vertex program of every pass, each parsed by glslang with only the lines in front of it that
 * docs/reference/layouts.md names, for every target. */
#include "tests/test.h"
#include "compiler/layout/custom.h"
#include "compiler/emit/emit.h"
#include "compiler/base/file.h"
#include "compiler/layout/layout.h"
#include "compiler/emit/validate.h"
#include "tests/value/documents.h"
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_CAPACITY = 1 << 16 };

/* The unpacking code behind a #version, in front of a light pass that reads every member; with a
 * vertex program, both linked. */
static bool is_whole(const LayoutRow *layout, Target target, const char *vertex)
{
    Arena arena = {0};
    MatcOptions options;
    Job job;
    const char *log = NULL;
    const TargetRow *row = &target_table[target];
    matc_options_init(&options);
    options.target = target_table[target].name;
    Session session = {.options = &options, .arena = &arena};
    assert_null(choice_job(&options, &job));
    job.layout = layout;
    const char *unpack = emit_unpack(&session, &job);
    Text text = text_new(&arena);
    text_format(&text, "#version %s\n%s", row->version, unpack);
    text_format(&text,
                "%svoid main() {\n    Surface s = unpackSurface(%s);\n    float sum = 0.0;\n",
                !row->in_out     ? ""
                : row->locations ? "layout(location = 0) out vec4 color;\n"
                                 : "out vec4 color;\n",
                row->words ? "ivec2(gl_FragCoord.xy)" : "gl_FragCoord.xy");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_has_slot(layout, (Slot)slot))
            text_format(&text, "    sum += length(s.%s);\n", slot_table[slot].name);
    text_format(&text, "    %s = vec4(sum);\n}\n", row->in_out ? "color" : "gl_FragColor");
    bool fine = validate(&session, target, &(ProgramTexts){vertex, text.at, 0}, &log);
    if (!fine)
        print_error("%s, %s: %s\n%s", layout->name, target_table[target].name, log, text.at);
    arena_free(&arena);
    return fine;
}

static bool is_read(const LayoutRow *layout, Target target)
{
    return target_table[target].words || !layout_has_words(layout);
}

/* ES links a uniform of both shaders only if both give it the same precision: so the samplers are
 * held to be highp, and what would be lowp without a word is found. */
static bool samplers_are_exact(const LayoutRow *layout)
{
    char vertex[TEXT_CAPACITY];
    int size = snprintf(vertex, sizeof vertex, "#version 300 es\n");
    for (int i = 0; i < layout_targets(layout); i++)
        size += snprintf(vertex + size, sizeof vertex - (size_t)size,
                         "uniform highp %ssampler2D matc_gbuffer%d;\n",
                         format_table[layout->formats[i]].words ? "u" : "", i);
    snprintf(vertex + size, sizeof vertex - (size_t)size, "void main() { gl_Position = vec4(0.0)");
    for (int i = 0; i < layout_targets(layout); i++) {
        size = (int)strlen(vertex);
        snprintf(vertex + size, sizeof vertex - (size_t)size,
                 " + vec4(texelFetch(matc_gbuffer%d, ivec2(0), 0))", i);
    }
    strncat(vertex, "; }\n", sizeof vertex - strlen(vertex) - 1);
    return is_whole(layout, TARGET_essl300, vertex);
}

static int check_layout(const LayoutRow *layout)
{
    int faults = 0;
    for (int target = 0; target < TARGET_COUNT; target++)
        if (is_read(layout, (Target)target))
            faults += !is_whole(layout, (Target)target, NULL);
    return faults + !samplers_are_exact(layout);
}

static void every_layout_is_read_by_text_that_is_whole(void **state)
{
    (void)state;
    int faults = 0;
    for (int i = 0; i < LAYOUT_COUNT; i++)
        faults += check_layout(&layout_table[i]);
    assert_int_equal(faults, 0);
}

/* The faults of every file that the pattern finds. */
static int check_files(const char *pattern, int (*check)(const char *path))
{
    glob_t found = {0};
    int faults = 0;
    if (glob(pattern, 0, NULL, &found))
        fail_msg("%s: no file", pattern);
    for (size_t i = 0; i < found.gl_pathc; i++)
        faults += check(found.gl_pathv[i]);
    globfree(&found);
    return faults;
}

static int check_layout_file(const char *path)
{
    MatcOptions options;
    size_t size;
    const char *why = NULL;
    char *text = file_read(path, &size, &why);
    assert_non_null(text);
    matc_options_init(&options);
    MatcLayout *layout = matc_layout_read(path, text, size, &options);
    assert_true(matc_layout_ok(layout));
    int faults = check_layout(layout->row);
    matc_layout_free(layout);
    free(text);
    return faults;
}

static void so_is_every_layout_of_the_examples(void **state)
{
    (void)state;
    assert_int_equal(check_files(SOURCE_FOLDER "/examples/layouts/*.yaml", check_layout_file), 0);
}

/* The layout for one document's materials. */
static int check_auto(const char *path)
{
    Document document;
    MatcRanges ranges;
    char *fault = NULL;
    if (!document_open(&document, path)) {
        bool library = document_is_library(&document);
        document_close(&document);
        return !library;
    }
    matc_ranges_init(&ranges);
    for (int i = 0; i < document.graph->material_count; i++)
        if (!matc_ranges_add(&ranges, document.document, i, &document.options, &fault))
            fail_msg("%s: %s", path, fault);
    MatcLayout *layout = matc_layout_for(&ranges, 0, &document.options);
    assert_true(matc_layout_ok(layout));
    int faults = check_layout(layout->row);
    matc_layout_free(layout);
    document_close(&document);
    return faults;
}

static void so_is_every_layout_of_auto(void **state)
{
    (void)state;
    assert_int_equal(check_files(SOURCE_FOLDER "/examples/materials/*.yaml", check_auto), 0);
    assert_int_equal(check_files(SOURCE_FOLDER "/tests/layouts/*.yaml", check_auto), 0);
}

/* Each vertex program without its fragment program. */
static void vertex_programs_are_whole(void **state)
{
    (void)state;
    static const char text[] =
        "material: Phong\ninput: { map: BumpMap, displacement: { map: Granite } }\n"
        "diffuse: { map: Checker, input: { map: Turbulence } }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &options);
    for (int i = 0; i < TARGET_COUNT * PASS_COUNT; i++) {
        Arena arena = {0};
        Session session = {.options = &options, .arena = &arena};
        const char *log = NULL;
        options.target = target_table[i % TARGET_COUNT].name;
        options.pass = pass_table[i / TARGET_COUNT].name;
        MatcProgram *program = matc_compile(document, 0, MATC_VERTEX, &options);
        const char *vertex = matc_output(program, MATC_VERTEX, NULL);
        if (!vertex || !validate(&session, (Target)(i % TARGET_COUNT),
                                 &(ProgramTexts){.vertex = vertex}, &log))
            fail_msg("%s, %s: %s\n%s", options.target, options.pass, log ? log : "none",
                     vertex ? vertex : "");
        matc_program_free(program);
        arena_free(&arena);
    }
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_layout_is_read_by_text_that_is_whole),
        cmocka_unit_test(so_is_every_layout_of_the_examples),
        cmocka_unit_test(so_is_every_layout_of_auto),
        cmocka_unit_test(vertex_programs_are_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
