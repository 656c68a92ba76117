/* Every example, through every pass and target and with either noise, is a program that glslang
 * parses and links. test_valid spirv: its SPIR-V passes spirv-val; status 77 where that is not
 * installed. */
/* ctest: seconds=80 */
#include "tests/test.h"
#include "compiler/choice.h"
#include "compiler/emit/validate.h"
#include "tests/sanitized.h"
#include "tests/value/documents.h"
#include "tests/value/share.h"
#include "tests/value/workers.h"
#include <pthread.h>
#include <spawn.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MODULES_MAX = 1 << 14, SKIPPED = 77, SHARES = 6 };

typedef struct {
    DocumentList documents;
    bool spirv_val; /* judges SPIR-V, and nothing else is looked at */
    atomic_int next, programs, faults;
    pthread_mutex_t lock;          /* of what follows */
    uint64_t modules[MODULES_MAX]; /* hashes of the SPIR-V that was looked at */
    int module_count;
} Run;

extern char **environ;

static bool run_spirv_val(const char *argument)
{
    posix_spawn_file_actions_t actions;
    pid_t process;
    int status = -1;
    char *const arguments[] = {"spirv-val", (char *)(uintptr_t)argument, NULL};
    posix_spawn_file_actions_init(&actions);
    if (!strcmp(argument, "--version"))
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 0x1 /* O_WRONLY */,
                                         0);
    if (posix_spawnp(&process, "spirv-val", &actions, NULL, arguments, environ) == 0)
        waitpid(process, &status, 0);
    posix_spawn_file_actions_destroy(&actions);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Not looked at before. */
static bool is_new(Run *run, const char *words, size_t size)
{
    uint64_t hash = 14695981039346656037u;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ (unsigned char)words[i]) * 1099511628211u;
    pthread_mutex_lock(&run->lock);
    int i = 0;
    while (i < run->module_count && run->modules[i] != hash)
        i++;
    bool fresh = i == run->module_count;
    if (fresh && run->module_count < MODULES_MAX)
        run->modules[run->module_count++] = hash;
    pthread_mutex_unlock(&run->lock);
    return fresh;
}

static bool passes_spirv_val(Run *run, const char *words, size_t size)
{
    if (!run->spirv_val || !is_new(run, words, size))
        return true;
    char path[] = "/tmp/matc-test-XXXXXX";
    int file = mkstemp(path);
    bool written = file >= 0 && write(file, words, size) == (ssize_t)size;
    if (file >= 0)
        close(file);
    bool valid = written && run_spirv_val(path);
    remove(path);
    return valid;
}

static void check_program(Run *run, const Document *d, int material, const MatcOptions *options)
{
    bool spirv = choice_target(options)->spirv;
    MatcProgram *program = matc_compile(
        d->document, material, MATC_FRAGMENT | MATC_VERTEX | (spirv ? MATC_SPIRV : 0), options);
    const char *what = NULL;
    size_t size = 0;
    const char *words = matc_output(program, MATC_SPIRV, &size);
    if (!matc_ok(program))
        what = matc_program_diagnostics(program, MATC_TEXT);
    else if (!matc_output(program, MATC_FRAGMENT, NULL) || !matc_output(program, MATC_VERTEX, NULL))
        what = "an output is missing";
    else if (spirv && !passes_spirv_val(run, words, size))
        what = "spirv-val refuses it";
    atomic_fetch_add(&run->programs, 1);
    if (what) {
        atomic_fetch_add(&run->faults, 1);
        fprintf(stderr, "%s %s, %s, pass %s, noise %s, -O%d: %s\n", document_name(d),
                matc_material_name(d->document, material), options->target, options->pass,
                options->noise, options->optimize, what);
    }
    matc_program_free(program);
}

/* As written only for one target: level 0 differs in its expressions, which are the same for
 * all. */
static void check_material(Run *run, const Document *d, int material)
{
    MatcOptions options = d->options;
    options.validate = !SANITIZED; /* glslang has no sanitizer */
    options.check = true;
    for (int i = 0; i < TARGET_COUNT * PASS_COUNT * axis_choices(AXIS_noise) * 2; i++) {
        int target = i % TARGET_COUNT, rest = i / TARGET_COUNT;
        options.target = target_table[target].name;
        options.pass = pass_table[rest % PASS_COUNT].name;
        options.noise = choice_table[axis_table[AXIS_noise].first +
                                     rest / PASS_COUNT % axis_choices(AXIS_noise)]
                            .name;
        options.optimize = rest / PASS_COUNT / axis_choices(AXIS_noise) ? 0 : 2;
        if ((target + rest) % SANITIZED_SHARE || !share_takes(target + rest, SHARES))
            continue;
        if (run->spirv_val ? options.optimize && target_table[target].spirv
                           : options.optimize || target == TARGET_DEFAULT)
            check_program(run, d, material, &options);
    }
}

static void *work(void *user)
{
    Run *run = user;
    /* of noises that a material has none of, programs are the same */
    MatcLinked *linked = matc_linked_new();
    for (int i; (i = atomic_fetch_add(&run->next, 1)) < run->documents.count;) {
        Document document;
        const char *only = getenv("VALUE_ONLY");
        if (only && !strstr(run->documents.paths[i], only))
            continue;
        bool good = document_open(&document, run->documents.paths[i]);
        document.options.linked = linked;
        if (!good && !document_is_library(&document)) {
            atomic_fetch_add(&run->faults, 1);
            fprintf(stderr, "%s: %s\n", run->documents.paths[i], document_fault(&document));
        }
        for (int material = 0; good && material < matc_material_count(document.document);
             material++)
            check_material(run, &document, material);
        document_close(&document);
    }
    matc_linked_free(linked);
    return NULL;
}

static void check_examples(bool spirv_val)
{
    Run run = {.spirv_val = spirv_val};
    run.documents = documents_tried(SOURCE_FOLDER);
    pthread_mutex_init(&run.lock, NULL);
    assert_true(run.documents.count > 100);
    workers_run(work, &run);
    documents_free(&run.documents);
    print_message("%d programs, %d modules of SPIR-V\n", run.programs, run.module_count);
    assert_int_equal(run.faults, 0);
    assert_true(!spirv_val || run.module_count > 100);
}

static void examples_are_valid(void **state)
{
    (void)state;
    check_examples(false);
}

static void spirv_passes_spirv_val(void **state)
{
    (void)state;
    check_examples(true);
}

/* Programs that were linked before are recognized, and no other is accepted for them. */
static void linked_programs_are_distinguished(void **state)
{
    (void)state;
    static const char head[] =
        "#version 330 core\nin vec3 p;\nlayout(location = 0) out vec4 color;\n";
    static const char good[] = "#version 330 core\nout vec3 p;\nvoid main() { p = vec3(1.0); "
                               "gl_Position = vec4(p, 1.0); }\n";
    static const char other[] =
        "#version 330 core\nout vec2 p;\nvoid main() { p = vec2(1.0); gl_Position = vec4(1.0); }\n";
    char fine[256], broken[256];
    const char *log = "";
    Arena arena = {0};
    MatcOptions options;
    matc_options_init(&options);
    options.linked = matc_linked_new();
    Session session = {.options = &options, .arena = &arena};
    size_t size = strlen(head);
    snprintf(fine, sizeof fine, "%svoid main() { color = vec4(p, 1.0); } // comment\n", head);
    snprintf(broken, sizeof broken, "%svoid main() { color = vec4(q, 1.0); }\n", head);
    assert_false(
        /* and is not remembered */
        validate(&session, TARGET_glsl330, &(ProgramTexts){other, fine, size}, &log));
    assert_false(validate(&session, TARGET_glsl330, &(ProgramTexts){other, fine, size}, &log));
    assert_true(validate(&session, TARGET_glsl330, &(ProgramTexts){good, fine, size}, &log));
    assert_true(validate(&session, TARGET_glsl330, &(ProgramTexts){good, fine, size}, &log));
    assert_false(validate(&session, TARGET_glsl330, &(ProgramTexts){good, broken, size}, &log));
    assert_non_null(strstr(log, ":4:")); /* lines are those of the text */
    assert_false(validate(&session, TARGET_glsl330, &(ProgramTexts){other, fine, size}, &log));
    matc_linked_free(options.linked);
    arena_free(&arena);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest spirv[] = {cmocka_unit_test(spirv_passes_spirv_val)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_are_valid),
        cmocka_unit_test(linked_programs_are_distinguished),
    };
    if (count < 2 || strcmp(arguments[1], "spirv") != 0)
        return cmocka_run_group_tests(tests, NULL, NULL);
    if (run_spirv_val("--version"))
        return cmocka_run_group_tests(spirv, NULL, NULL);
    puts("SKIPPED: spirv-val is not installed (Debian: spirv-tools), so no SPIR-V was judged");
    return SKIPPED;
}
