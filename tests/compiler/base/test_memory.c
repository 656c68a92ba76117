/* Memory use: matc reads documents of every kind. Its peak resident size, less that for a
 * document of one line, is bounded by a multiple of the text's size
 * (docs/reference/stability.md, Memory). */
/* ctest: unsanitized small-pages seconds=15 */
#include "tests/test.h"
#include "compiler/base/text.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    SIZE = 2 << 20,
    READING = 40,  /* bytes for a byte of text, for what is refused once it is read */
    DOCUMENT = 60, /* and for what goes on to be a document */
    NOISE = 1 << 20,
};

typedef struct {
    const char *name, *first, *many, *last; /* `many` is repeated; its %x is a number */
    int filler;                             /* bytes of 'z' between first and many */
    int multiple;
} Row;

static const Row rows[] = {
    {"one.yaml", "material: Phong\n", NULL, "", 0, 0},
    {"numbers.json", "[", "0,", "0]", 0, READING},
    {"lists.json", "[", "[],", "0]", 0, READING},
    {"nested.json", "[", "[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]],", "0]", 0, READING},
    {"objects.json", "[", "{\"\":0},", "0]", 0, READING},
    {"one_key.json", "{", "\"\":0,", "\"\":0}", 0, READING},
    {"keys.json", "{", "\"%x\":0,", "\"\":0}", 0, READING},
    {"text.json", "[\"", "a", "\"]", 0, READING},
    {"escapes.json", "[\"", "\\n", "\"]", 0, READING},
    {"not_json.json", "[", "0,", "0", 0, READING},
    {"numbers.yaml", "[", "0,", "0]", 0, READING},
    {"lines.yaml", "", "- 0\n", "", 0, READING},
    {"anchors.yaml", "", "- &%x\n", "", 0, READING},
    {"letters.yaml", "", "- \xc3\xa9\n", "", 0, READING},
    {"umlauts.yaml", "\"", "\xc3\xa9", "\"", 0, READING},
    {"merges.yaml", "- &a {x: 0}\n- {k: 0, <<: [", "*a,", "*a]}", 0, READING},
    {"merged_objects.yaml", "- &a {x: 0, y: 0, z: 0}\n", "- {<<: *a}\n", "", 0, READING},
    {"unknown_keys.yaml", "material: Phong\n", "k%x: 0\n", "", 0, DOCUMENT},
    {"materials.yaml", "materials:\n", " d%x: {material: Phong}\n", "", 0, DOCUMENT},
    {"maps.yaml", "material: Phong\ndefs:\n", " d%x: {map: Wood}\n", "", 0, DOCUMENT},
    {"checkers.yaml", "material: Phong\ndefs:\n", " d%x: {map: Checker}\n", "", 0, DOCUMENT},
    {"julias.yaml", "material: Phong\ndiffuse: {map: Blend, blend: [", "{input: {map: Julia}},",
     "]}", 0, DOCUMENT},
    {"constants.yaml", "material: Phong\ndefs:\n", " d%x: 1\n", "", 0, DOCUMENT},
    {"waves.yaml", "material: Phong\ndefs:\n", " d%x: {map: Wood, waveForm: Sin}\n", "", 0,
     DOCUMENT},
    {"items.yaml", "material: Phong\ndiffuse: {map: Blend, blend: [", "{},", "]}", 0, DOCUMENT},
    {"no_items.yaml", "material: Phong\ndiffuse: {map: Blend, blend: [", "'',", "]}", 0, DOCUMENT},
    {"no_maps.yaml", "material: Phong\ndiffuse: {map: Blend, blend: [", "{input: {}},", "]}", 0,
     DOCUMENT},
    /* faults that name something long, again and again */
    {"long_map.yaml", "material: Phong\ndefs: {x: &a ", "{input: {map: *a}},", "]}}", SIZE / 2,
     DOCUMENT},
    {"long_color.yaml", "material: Phong\ndefs: {x: &a ", "{input: [*a]},", "]}}", SIZE / 2,
     DOCUMENT},
    {"long_ref.yaml", "material: Phong\ndefs: {x: &a ", "{input: {ref: *a}},", "]}}", SIZE / 2,
     DOCUMENT},
};

static void put_many(Text *text, const char *many)
{
    for (int i = 0; text->size < SIZE; i++) {
        const char *number = strstr(many, "%x");
        text_add(text, many, number ? (size_t)(number - many) : strlen(many));
        if (!number)
            continue;
        char digits[16];
        snprintf(digits, sizeof digits, "%x", (unsigned)i);
        text_put(text, digits);
        text_put(text, number + 2);
    }
}

static size_t write_document(const Row *row, const char *path)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    text_put(&text, row->first);
    for (int i = 0; i < row->filler; i++)
        text_char(&text, 'z');
    if (row->filler)
        text_put(&text, ", y: {map: Blend, blend: [");
    if (row->many)
        put_many(&text, row->many);
    text_put(&text, row->last);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text.at, 1, text.size, file), text.size);
    fclose(file);
    const size_t size = text.size;
    arena_free(&arena);
    return size;
}

/* The greatest resident size of matc, in bytes. */
static size_t memory_for(const char *path)
{
    struct rusage used;
    int status;
    const pid_t child = fork();
    assert_true(child >= 0);
    if (!child) {
        int nothing = open("/dev/null", O_WRONLY);
        dup2(nothing, STDOUT_FILENO);
        dup2(nothing, STDERR_FILENO);
        execl(MATC_PROGRAM, MATC_PROGRAM, "--eval", "u=0", path, (char *)NULL);
        _exit(127);
    }
    assert_int_equal(wait4(child, &status, 0, &used), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) <= 1);
    return (size_t)used.ru_maxrss * 1024;
}

static void test_documents(void **state)
{
    (void)state;
    size_t alone = 0;
    char folder[] = "/tmp/matc-test-XXXXXX";
    assert_non_null(mkdtemp(folder));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%s", folder, rows[i].name);
        const size_t size = write_document(&rows[i], path), memory = memory_for(path);
        remove(path);
        if (!i)
            alone = memory;
        const double multiple = memory < alone ? 0 : (double)(memory - alone) / (double)size;
        printf("%-20s %5.1f\n", rows[i].name, multiple);
        if (memory > alone + size * (size_t)rows[i].multiple + NOISE)
            fail_msg("%s: %.1f bytes for a byte, more than %d", rows[i].name, multiple,
                     rows[i].multiple);
    }
    remove(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_documents)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
