/* matc reads and writes the same in every locale. Compares all messages about documents, layouts
 * and keywords in the C locale and in a locale with decimal commas whose letters include bytes
 * above ASCII, set for the process or for a thread. */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "compiler/matc.h"
#include "grammar/layout_tables.h"
#include <ctype.h>
#include <ftw.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_DOCUMENTS = 4096, OUTPUTS = MATC_FRAGMENT | MATC_REFLECT | MATC_IR };

static const unsigned outputs[] = {MATC_FRAGMENT, MATC_REFLECT, MATC_IR};

static struct {
    char *paths[MAX_DOCUMENTS];
    int count;
} found; /* nftw takes no argument of one's own */

static int note(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)walk;
    const char *dot = strrchr(path, '.');
    if (kind != FTW_F || !dot || (strcmp(dot, ".yaml") != 0 && strcmp(dot, ".json") != 0))
        return 0;
    assert_in_range(found.count, 0, MAX_DOCUMENTS - 1);
    found.paths[found.count++] = strdup(path);
    return 0;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static MatcOptions quick(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    return options;
}

/* -- everything that is said */

static void say(FILE *out, const char *what, const char *text)
{
    fprintf(out, "%s: %s\n", what, text ? text : "none");
}

static void report_document(FILE *out, const char *path, const char *text, size_t size)
{
    const MatcOptions options = quick();
    MatcDocument *document = matc_read(path, text, size, &options);
    say(out, path, matc_tree_text(document));
    for (int i = 0; i < matc_material_count(document); i++) {
        const char *fault;
        MatcProgram *program = matc_compile(document, i, OUTPUTS, &options);
        for (size_t k = 0; k < sizeof outputs / sizeof *outputs; k++)
            say(out, path, matc_output(program, (MatcOutput)outputs[k], NULL));
        say(out, path, matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        if (strstr(path, "bomb"))
            continue; /* its value takes as long as a value may */
        char *values = matc_eval(document, i, "u=0.3 v=0.45 x=1.5e-1", &options, &fault);
        say(out, path, values ? values : fault);
        free(values);
    }
    say(out, path, matc_diagnostics(document, MATC_TEXT));
    say(out, path, matc_diagnostics(document, MATC_JSON));
    matc_document_free(document);
}

static void report_layout(FILE *out, const char *what, MatcLayout *layout)
{
    say(out, what, matc_layout_ok(layout) ? matc_layout_text(layout) : "none");
    say(out, what, matc_layout_ok(layout) ? matc_layout_report(layout) : "none");
    say(out, what, matc_layout_diagnostics(layout, MATC_TEXT));
    matc_layout_free(layout);
}

static void report_auto_layout(FILE *out, const char *path, const char *text, size_t size)
{
    char *fault;
    MatcRanges ranges;
    const MatcOptions options = quick();
    MatcDocument *document = matc_read(path, text, size, &options);
    matc_ranges_init(&ranges);
    for (int i = 0; i < matc_material_count(document); i++)
        if (!matc_ranges_add(&ranges, document, i, &options, &fault))
            free(fault);
    report_layout(out, path, matc_layout_for(&ranges, 0.004, &options));
    matc_document_free(document);
}

static void report_word(FILE *out, const char *word)
{
    char *text = matc_explain(word);
    say(out, word, text);
    free(text);
}

static void report_words(FILE *out)
{
    static const char *const schemas[] = {NULL, "layout", "manifest", "reflection"};
    char *list = matc_list();
    say(out, "list", list);
    free(list);
    for (int i = 0; i < KIND_COUNT; i++)
        report_word(out, kind_table[i].name);
    for (int i = 0; i < LAYOUT_COUNT; i++)
        report_word(out, layout_table[i].name);
    for (int i = 0; i < ENCODING_COUNT; i++)
        report_word(out, encoding_table[i].name);
    for (size_t i = 0; i < sizeof schemas / sizeof *schemas; i++) {
        char *schema = matc_schema(schemas[i]);
        say(out, "schema", schema);
        free(schema);
    }
}

/* All of it; only of the paths that begin so. */
static char *everything(const char *folder)
{
    char *all = NULL;
    size_t capacity;
    FILE *out = open_memstream(&all, &capacity);
    for (int i = 0; i < found.count; i++) {
        size_t size;
        const char *why;
        if (strncmp(found.paths[i], folder, strlen(folder)) != 0)
            continue;
        char *text = file_read(found.paths[i], &size, &why);
        assert_non_null(text);
        const MatcOptions options = quick();
        report_document(out, found.paths[i], text, size);
        if (strstr(found.paths[i], "/conversions/"))
            report_auto_layout(out, found.paths[i], text, size);
        if (strstr(found.paths[i], "layout"))
            report_layout(out, found.paths[i],
                          matc_layout_read(found.paths[i], text, size, &options));
        free(text);
    }
    report_words(out);
    fclose(out);
    return all;
}

/* -- in another locale */

static void expect_same(const char *a, const char *b)
{
    const char *line_a = a, *line_b = b;
    for (; *a && *a == *b; a++, b++)
        if (*a == '\n')
            line_a = a + 1, line_b = b + 1;
    if (*a || *b)
        fail_msg("\"%.*s\" is \"%.*s\"", (int)strcspn(line_a, "\n"), line_a,
                 (int)strcspn(line_b, "\n"), line_b);
}

static void a_process_may_have_any_locale(void **state)
{
    (void)state;
    char number[16], *plain = everything("");
    assert_non_null(setlocale(LC_ALL, "comma"));
    snprintf(number, sizeof number, "%g", 1.5);
    assert_string_equal(number, "1,5"); /* it is in force */
    assert_true(isalpha(0xE4));
    char *other = everything("");
    expect_same(plain, other);
    free(plain);
    free(other);
}

static void a_thread_may_have_any_locale(void **state)
{
    (void)state;
    char number[16], *plain = everything("examples/waves");
    locale_t comma = newlocale(LC_ALL_MASK, "comma", (locale_t)0);
    assert_true(comma != (locale_t)0);
    locale_t before = uselocale(comma);
    char *other = everything("examples/waves");
    snprintf(number, sizeof number, "%g", 1.5);
    assert_string_equal(number, "1,5"); /* it still is */
    uselocale(before);
    freelocale(comma);
    expect_same(plain, other);
    free(plain);
    free(other);
}

/* Times differ from run to run, but each is a number with a point. */
static void times_have_a_point(void **state)
{
    (void)state;
    const char text[] = "material: Phong\ndiffuse: 0.25\n";
    const MatcOptions options = quick();
    assert_non_null(setlocale(LC_ALL, "comma"));
    MatcDocument *document = matc_read("test.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_STATS, &options);
    const char *stats = matc_output(program, MATC_STATS, NULL), *lower = strstr(stats, "\nlower");
    assert_non_null(lower);
    lower += strcspn(lower, "0123456789");
    lower += strspn(lower, "0123456789");
    assert_int_equal(*lower, '.');
    matc_program_free(program);
    matc_document_free(document);
}

static int leave(void **state)
{
    (void)state;
    uselocale(LC_GLOBAL_LOCALE);
    return !setlocale(LC_ALL, "C");
}

/* -- the locale */

static bool make_locale(const char *folder)
{
    char path[256], command[1024];
    snprintf(path, sizeof path, "%s/latin", folder);
    FILE *charmap = fopen(path, "w");
    assert_non_null(charmap);
    fputs("<code_set_name> LATIN\n<mb_cur_min> 1\n<mb_cur_max> 1\n<escape_char> /\n<comment_char> "
          "%\nCHARMAP\n",
          charmap);
    for (int i = 0; i < 256; i++)
        fprintf(charmap, "<U%04X> /x%02x\n", i, i);
    fputs("END CHARMAP\n", charmap);
    fclose(charmap);
    snprintf(command, sizeof command,
             "localedef -c --no-archive -i tests/locale/comma -f %s/latin %s/comma >/dev/null 2>&1",
             folder, folder);
    if (system(command) == -1) /* it warns of what is not defined, and ends with 1 */
        return false;
    setenv("LOCPATH", folder, 1);
    bool there = setlocale(LC_ALL, "comma");
    setlocale(LC_ALL, "C");
    return there;
}

static void remove_locale(const char *folder)
{
    char command[512];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (system(command))
        fprintf(stderr, "%s stays\n", folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(a_process_may_have_any_locale, leave),
        cmocka_unit_test_teardown(a_thread_may_have_any_locale, leave),
        cmocka_unit_test_teardown(times_have_a_point, leave),
    };
    char folder[] = "/tmp/matc_localeXXXXXX";
    if (!mkdtemp(folder))
        return 1;
    if (!make_locale(folder)) {
        printf("SKIPPED: localedef makes no locale\n");
        remove_locale(folder);
        return 77;
    }
    nftw("examples/conversions", note, 16, FTW_PHYS);
    nftw("examples/layouts", note, 16, FTW_PHYS);
    nftw("examples/materials", note, 16, FTW_PHYS);
    nftw("examples/waves", note, 16, FTW_PHYS);
    nftw("tests/errors", note, 16, FTW_PHYS);
    qsort(found.paths, (size_t)found.count, sizeof *found.paths, by_name);
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    for (int i = 0; i < found.count; i++)
        free(found.paths[i]);
    remove_locale(folder);
    return failed;
}
