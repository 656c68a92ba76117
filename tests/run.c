/* The golden runner. Compares output with files that are stored:
 *   for every document in examples/       tests/golden/<name>.ir and .frag; .json unless in a
 *                                         subfolder; .comp, its compute program, if it displaces
 *   for every file in examples/layouts/   the layout's page, .txt, and GLSL to pack and unpack it
 *   for every file in tests/errors/       its diagnostics, <name>.err next to it
 *   for every tests/ir/<pass>-<case>.ir   the pass' result, .out next to it
 * `run FOLDER` compares; `run FOLDER --update` rewrites files that differ and lists them: read the
 * difference before you commit it. Under CI it does not update. */
#include "compiler/matc.h"
#include "compiler/opt/opt.h"
#include "compiler/base/output.h"
#include "tests/value/read_whole.h"
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LONGEST_PATH = 1024, MAX_FILES = 4096 };

typedef struct {
    bool update;
    int passed, failed, updated;
} Run;

/* nftw has no user argument */
static char *found[MAX_FILES];
static int found_count;

static bool has_suffix(const char *path, const char *suffix)
{
    size_t size = strlen(path), end = strlen(suffix);
    return size > end && !strcmp(path + size - end, suffix);
}

static int remember(const char *path, const struct stat *info, int type, struct FTW *where)
{
    (void)info, (void)where;
    if (strstr(path, "examples/engine/")) /* built by a separate test */
        return 0;
    bool wanted =
        has_suffix(path, ".yaml") || has_suffix(path, ".json") || strstr(path, "tests/ir/");
    /* tests/packaging/install.sh builds that example */
    wanted &= !strstr(path, "examples/engine/");
    if (type == FTW_F && found_count < MAX_FILES && wanted && !has_suffix(path, ".out"))
        found[found_count++] = strdup(path);
    return 0;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void find_documents(const char *folder)
{
    for (int i = 0; i < found_count; i++)
        free(found[i]);
    found_count = 0;
    nftw(folder, remember, 16, FTW_PHYS);
    qsort(found, (size_t)found_count, sizeof *found, by_name);
}

static void show_difference(const char *path, const char *expected, const char *actual)
{
    int line = 1;
    const char *a = expected ? expected : "", *b = actual;
    while (*a && *a == *b) {
        line += *a == '\n';
        a++, b++;
    }
    while (a > expected && a[-1] != '\n' && expected)
        a--, b--;
    printf("%s:%d: differs\n  expected: %.*s\n  actual:   %.*s\n", path, line,
           (int)strcspn(a, "\n"), a, (int)strcspn(b, "\n"), b);
}

static void compare(Run *run, const char *path, const char *actual)
{
    size_t size;
    char *expected = read_whole(path, &size);
    if (expected && !strcmp(expected, actual)) {
        run->passed++;
    } else if (run->update) {
        const char *why = output_write(path, actual, strlen(actual));
        printf(why ? "cannot write %s: %s\n" : "updated %s\n", path, why);
        run->updated++;
    } else {
        run->failed++;
        show_difference(path, expected, actual);
    }
    free(expected);
}

/* "examples/waves/Sin.yaml" -> "tests/golden/waves-Sin", then the material if there are several. */
static void golden_path(char *path, const char *document, const char *material, const char *suffix)
{
    char name[LONGEST_PATH / 2];
    snprintf(name, sizeof name, "%s", document + strlen("examples/"));
    *strrchr(name, '.') = 0;
    for (char *c = name; *c; c++)
        if (*c == '/')
            *c = '-';
    snprintf(path, LONGEST_PATH, "tests/golden/%s%s%.200s%s", name, material ? "-" : "",
             material ? material : "", suffix);
}

static void run_material(Run *run, const MatcDocument *document, const char *name, int material)
{
    char path[LONGEST_PATH];
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false; /* test_valid validates for every target */
    options.check = true;
    MatcProgram *program =
        matc_compile(document, material, MATC_FRAGMENT | MATC_IR | MATC_REFLECT, &options);
    const char *which =
        matc_material_count(document) > 1 ? matc_material_name(document, material) : NULL;
    if (!matc_ok(program) || *matc_program_diagnostics(program, MATC_TEXT)) {
        printf("%s: %s", name, matc_program_diagnostics(program, MATC_TEXT));
        run->failed++;
    } else {
        golden_path(path, name, which, ".ir");
        compare(run, path, matc_output(program, MATC_IR, NULL));
        golden_path(path, name, which, ".frag");
        compare(run, path, matc_output(program, MATC_FRAGMENT, NULL));
        golden_path(path, name, which, ".json");
        if (!strchr(name + strlen("examples/"), '/'))
            compare(run, path, matc_output(program, MATC_REFLECT, NULL));
    }
    matc_program_free(program);
}

/* Compares a displacing material's compute program and its reflection. */
static void run_compute(Run *run, const MatcDocument *document, const char *name)
{
    char path[LONGEST_PATH];
    MatcOptions options;
    matc_options_init(&options);
    options.target = "glsl450";
    options.validate = false;
    MatcProgram *program = matc_compile(document, 0, MATC_COMPUTE | MATC_REFLECT, &options);
    if (matc_ok(program) && matc_displacement_bound(program) != 0) {
        golden_path(path, name, NULL, ".comp");
        compare(run, path, matc_output(program, MATC_COMPUTE, NULL));
        golden_path(path, name, NULL, ".comp.json");
        compare(run, path, matc_output(program, MATC_REFLECT, NULL));
    }
    matc_program_free(program);
}

static MatcDocument *open_document(const char *name)
{
    size_t size;
    MatcOptions options;
    matc_options_init(&options);
    char *text = read_whole(name, &size);
    MatcDocument *document = matc_read(name, text ? text : "", size, &options);
    free(text);
    return document;
}

static bool is_layout(const char *name) { return strstr(name, "/layouts/") != NULL; }

static MatcLayout *open_layout(const char *name)
{
    size_t size;
    MatcOptions options;
    matc_options_init(&options);
    char *text = read_whole(name, &size);
    MatcLayout *layout = matc_layout_read(name, text ? text : "", size, &options);
    free(text);
    return layout;
}

/* Compares a layout's page and its unpacking GLSL. */
static void run_layout(Run *run, const char *name)
{
    static const char material[] = "material: Phong\nspecular: 0.1\nshininess: 0.6\n";
    char path[LONGEST_PATH];
    MatcOptions options;
    MatcLayout *layout = open_layout(name);
    matc_options_init(&options);
    options.custom = layout;
    options.validate = false;
    MatcDocument *document = matc_read("material.yaml", material, sizeof material - 1, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_UNPACK | MATC_FRAGMENT, &options);
    if (!matc_layout_ok(layout) || !matc_ok(program)) {
        printf("%s%s", matc_layout_diagnostics(layout, MATC_TEXT),
               matc_program_diagnostics(program, MATC_TEXT));
        run->failed++;
    } else {
        golden_path(path, name, NULL, ".txt");
        compare(run, path, matc_layout_report(layout));
        golden_path(path, name, NULL, ".unpack.glsl");
        compare(run, path, matc_output(program, MATC_UNPACK, NULL));
        golden_path(path, name, NULL, ".frag");
        compare(run, path, matc_output(program, MATC_FRAGMENT, NULL));
    }
    matc_program_free(program);
    matc_document_free(document);
    matc_layout_free(layout);
}

static void run_layout_error(Run *run, const char *name)
{
    char path[LONGEST_PATH];
    MatcLayout *layout = open_layout(name);
    snprintf(path, sizeof path, "%.*s.err", (int)(strrchr(name, '.') - name), name);
    compare(run, path, matc_layout_diagnostics(layout, MATC_TEXT));
    matc_layout_free(layout);
}

/* Examples must compile without warnings; those of channels and conversions are corner cases,
 * whose warnings are goldens, .err. */
static void check_silence(Run *run, MatcDocument *document, const char *name)
{
    char path[LONGEST_PATH];
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    golden_path(path, name, NULL, ".err");
    if (!*reported && access(path, F_OK))
        return;
    if (strstr(name, "/channels/") || strstr(name, "/conversions/")) {
        compare(run, path, reported);
    } else {
        printf("%s", reported);
        run->failed++;
    }
}

static void run_example(Run *run, const char *name)
{
    if (is_layout(name)) {
        run_layout(run, name);
        return;
    }
    MatcDocument *document = open_document(name);
    const bool palette = !matc_material_count(document) && !matc_error_count(document);
    if (!palette)
        check_silence(run, document, name);
    run->failed += !matc_material_count(document) && !palette;
    for (int i = 0; i < matc_material_count(document); i++)
        run_material(run, document, name, i);
    if (matc_material_count(document) == 1 && !strchr(name + strlen("examples/"), '/'))
        run_compute(run, document, name);
    matc_document_free(document);
}

/* Compares all messages about a faulty document, from reading and from compiling. */
static void run_error(Run *run, const char *name)
{
    char path[LONGEST_PATH], *text = NULL;
    size_t size;
    if (is_layout(name)) {
        run_layout_error(run, name);
        return;
    }
    FILE *all = open_memstream(&text, &size);
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    MatcDocument *document = open_document(name);
    fputs(matc_diagnostics(document, MATC_TEXT), all);
    for (int i = 0; i < matc_material_count(document); i++) {
        MatcProgram *program = matc_compile(document, i, MATC_FRAGMENT, &options);
        fputs(matc_program_diagnostics(program, MATC_TEXT), all);
        matc_program_free(program);
    }
    fclose(all);
    snprintf(path, sizeof path, "%.*s.err", (int)(strrchr(name, '.') - name), name);
    compare(run, path, text);
    matc_document_free(document);
    free(text);
}

static const struct {
    const char *name;
    bool (*run)(Ir *ir);
} passes[] = {{"fold", opt_fold},     {"algebra", opt_algebra}, {"swizzle", opt_swizzle},
              {"select", opt_select}, {"power", opt_power},     {"range", opt_range},
              {"polish", opt_polish}, {"dead", opt_dead},       {"function", opt_function},
              {"centre", opt_centre}, {"group", opt_group}};

/* Runs one pass on an IR text; then compares the text of the result, and checks the IR. */
static void run_pass(Run *run, const char *name)
{
    char path[LONGEST_PATH];
    size_t size;
    const char *fault = "no such pass", *base = strrchr(name, '/') + 1;
    Arena arena = {0};
    Session session = {.arena = &arena};
    Graph graph = {0};
    Text out = text_new(&arena);
    char *text = read_whole(name, &size);
    Ir *ir = ir_read(&session, text, &graph, &fault);
    for (size_t i = 0; ir && i < sizeof passes / sizeof *passes; i++)
        if (!strncmp(base, passes[i].name, strlen(passes[i].name)))
            passes[i].run(ir);
    fault = ir ? ir_check(ir) : fault;
    if (ir)
        ir_print(&out, ir);
    if (fault) {
        printf("%s: %s\n", name, fault);
        run->failed++;
    } else {
        snprintf(path, sizeof path, "%.*s.out", (int)(strlen(name) - 3), name);
        compare(run, path, out.at);
    }
    if (ir)
        ir_done(ir);
    arena_free(&arena);
    free(text);
}

int main(int argc, char **argv)
{
    Run run = {.update = argc > 2 && !strcmp(argv[2], "--update")};
    if (argc < 2 || chdir(argv[1])) {
        fputs("usage: run FOLDER [--update]\n", stderr);
        return 2;
    }
    if (run.update && getenv("CI")) {
        fputs("run: goldens are not updated under CI\n", stderr);
        return 2;
    }
    find_documents("examples");
    for (int i = 0; i < found_count; i++)
        run_example(&run, found[i]);
    find_documents("tests/errors");
    for (int i = 0; i < found_count; i++)
        run_error(&run, found[i]);
    find_documents("tests/ir");
    for (int i = 0; i < found_count; i++)
        run_pass(&run, found[i]);
    find_documents("/nonexistent"); /* frees the list */
    printf("%d passed, %d failed\n", run.passed, run.failed);
    if (run.updated)
        printf("%d updated: read the difference\n", run.updated);
    return run.failed || !(run.passed + run.updated);
}
