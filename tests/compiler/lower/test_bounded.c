/* --trigonometry=bounded never calls the driver's sines and cosines: neither a library function
 * nor a whole program contains a call. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/emit/chunks.h"
#include "tests/value/documents.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>

static const char *const drivers[] = {"sin",  "cos",  "tan",  "asin", "acos",
                                      "atan", "sinh", "cosh", "tanh"};
enum { DRIVER_COUNT = sizeof drivers / sizeof *drivers, MAX_SHOWN = 10 };

static bool is_driver_call(const char *name, size_t size)
{
    for (int i = 0; i < DRIVER_COUNT; i++)
        if (strlen(drivers[i]) == size && !strncmp(drivers[i], name, size))
            return name[size] == '(';
    return false;
}

/* The first call of such a function outside of comments, or NULL. */
static const char *driver_call(const char *text)
{
    while (*text) {
        if (!strncmp(text, "//", 2)) {
            text += strcspn(text, "\n");
            continue;
        }
        size_t size = 0;
        while (isalnum((unsigned char)text[size]) || text[size] == '_')
            size++;
        if (is_driver_call(text, size))
            return text;
        text += size ? size : 1;
    }
    return NULL;
}

static void calls_are_seen(void **state)
{
    (void)state;
    static const char *const calls[] = {"x = sin(y);", "atan(y, x)", "2.0*cos(1.0)"};
    static const char *const others[] = {"// of sin(x)\nfloat x;", "mySin(x)", "sinMean(x)",
                                         "a_sin(x)", "float sin = 1.0;"};
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        assert_non_null(driver_call(calls[i]));
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_null(driver_call(others[i]));
}

static int check_function(int function, Target target)
{
    MatcOptions options = {0};
    Arena arena = {0};
    Session session = {.options = &options, .arena = &arena};
    Chunks chunks = {0};
    Job job = {.target = target, .choice[AXIS_trigonometry] = CHOICE_trigonometry_bounded};
    int faults = 0;
    for (int noise = 0; noise < axis_choices(AXIS_noise); noise++) {
        job.choice[AXIS_noise] = (Choice)(axis_table[AXIS_noise].first + noise);
        assert_true(chunks_add(&session, &chunks, function_row(function)->name, &job));
    }
    for (size_t i = 0; i < chunks.count; i++) {
        const char *call = driver_call(chunks.at[i]->body);
        if (!call)
            continue;
        faults++;
        fprintf(stderr, "%s, %s of %s: %.*s\n", target_table[target].name, chunks.at[i]->name,
                function_row(function)->name, (int)strcspn(call, "\n"), call);
    }
    arena_free(&arena);
    return faults;
}

static void functions_call_none(void **state)
{
    (void)state;
    int faults = 0;
    for (int target = 0; target < TARGET_COUNT; target++)
        for (int i = 0; i < FUNCTION_COUNT; i++)
            if (function_row(i)->name)
                faults += check_function(i, (Target)target);
    assert_int_equal(faults, 0);
}

static int check_program(const Document *d, int material, const MatcOptions *options)
{
    MatcProgram *program = matc_compile(d->document, material, MATC_FRAGMENT, options);
    const char *text = matc_output(program, MATC_FRAGMENT, NULL);
    if (!text)
        fail_msg("%s: %s", d->path, matc_program_diagnostics(program, MATC_TEXT));
    const char *call = driver_call(text);
    static int shown;
    if (call && shown++ < MAX_SHOWN)
        fprintf(stderr, "%s %s, pass %s, aa=%s, derivatives=%s: %.*s\n", document_name(d),
                matc_material_name(d->document, material), options->pass, options->aa,
                options->derivatives, (int)strcspn(call, "\n"), call);
    matc_program_free(program);
    return call != NULL;
}

/* Every way in which a sine comes into a program: as it is written, by a mean over the pixel, by a
 * slope, by the sky. */
static int check_material(const Document *d, int material)
{
    static const char *const passes[] = {"gbuffer", "sky"}, *const aa[] = {"none", "box", "aniso"},
                             *const derivatives[] = {"auto", "analytic"};
    MatcOptions options = d->options;
    options.validate = false;
    options.trigonometry = "bounded";
    int faults = 0;
    for (int i = 0; i < 12; i++) {
        options.pass = passes[i % 2];
        options.derivatives = derivatives[i / 2 % 2];
        options.aa = aa[i / 4];
        faults += check_program(d, material, &options);
    }
    return faults;
}

static void programs_call_none(void **state)
{
    (void)state;
    DocumentList list = documents_list(SOURCE_FOLDER);
    int faults = 0;
    for (int i = 0; i < list.count; i++) {
        Document d;
        if (document_open(&d, list.paths[i]))
            for (int material = 0; material < matc_material_count(d.document); material++)
                faults += check_material(&d, material);
        document_close(&d);
    }
    documents_free(&list);
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_are_seen),
        cmocka_unit_test(functions_call_none),
        cmocka_unit_test(programs_call_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
