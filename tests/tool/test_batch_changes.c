/* Documents that change after a batch has read its materials and before it writes their shared
 * programs. */
#include "tests/test.h"
#include "compiler/tool/batch.h"
#include "tests/value/batch_set.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    char path[SET_PATH];
    const char *text;
    int reported;
} Change;

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void change_at_last(void *user, int done, int documents)
{
    Change *change = user;
    if (done == documents)
        write_text(change->path, change->text);
}

static void hear(void *user, const char *text)
{
    Change *change = user;
    change->reported +=
        strstr(text, change->path) && strstr(text, "the file changed while it was compiled");
}

static bool run_changing(const BatchSet *set, Change *change, BatchResult *result)
{
    char documents[2][SET_PATH], out[SET_PATH];
    char *argv[] = {"matc", "-d", out, "-j1", "--no-validate", documents[0], documents[1]};
    CommandLine line;
    const char *fault;
    const BatchCalls calls = {hear, change_at_last, NULL, NULL, change};
    snprintf(out, sizeof out, "%s/changing", set->folder);
    for (int i = 0; i < 2; i++)
        snprintf(documents[i], sizeof documents[i], "%s/d%d.yaml", set->folder, i);
    assert_true(options_read(&line, sizeof argv / sizeof *argv, argv, &fault));
    bool fine = batch_run(&line, &calls, result);
    options_free(&line);
    assert_int_equal(!access(out, F_OK), fine);
    return fine;
}

static void changes_are_noticed(void **state)
{
    static const char part[] = "defs: { tone: [0.1, 0.2, 0.3] }\n",
                      text[] = "include: part.yaml\nmaterial: Phong\n"
                               "diffuse: { ref: tone }\nspecular: 0.1\n";
    BatchSet set;
    BatchResult result;
    Change change = {.text = part};
    (void)state;
    assert_true(batch_set_open(&set));
    snprintf(change.path, sizeof change.path, "%s/part.yaml", set.folder);
    write_text(change.path, part);
    assert_int_equal(batch_set_add(&set, text, 1), 2);
    assert_true(run_changing(&set, &change, &result)); /* written again, as it was */
    assert_int_equal(result.programs, 1);
    assert_int_equal(result.buffered, 1);
    char command[2 * SET_PATH];
    snprintf(command, sizeof command, "rm -r '%s/changing'", set.folder);
    assert_int_equal(system(command), 0);
    change.text = "defs: { tone: { map: Checker } }\n";
    assert_false(run_changing(&set, &change, &result));
    assert_int_equal(change.reported, 1);
    write_text(change.path, part);
    snprintf(change.path, sizeof change.path, "%s/d0.yaml", set.folder);
    change.text = "material: Phong\n";
    assert_false(run_changing(&set, &change, &result));
    assert_int_equal(change.reported, 2);
    batch_set_close(&set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_are_noticed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
