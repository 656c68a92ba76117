/* The manifest of small batches (compiler/tool/manifest.c), read by cJSON and compared with what is
 * written here by hand; every member that files.def lists occurs in one of them. */
#include "tests/test.h"
#include "compiler/tool/batch.h"
#include "tests/manifest_cases.h"
#include "tests/value/folder.h"
#include <cjson/cJSON.h>
#include <dirent.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { PATH_CAPACITY = 512, KEY_DIGITS = 32 };

/* -- running */

typedef struct {
    char folder[64], out[PATH_CAPACITY];
    int reported;
} Fixture;

static void write_text(const Fixture *f, const char *name, const char *text)
{
    char path[PATH_CAPACITY];
    snprintf(path, sizeof path, "%s/%s", f->folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static int set_up(void **state)
{
    static const char *const pictures[] = {"tiles.png", "ti\"le\\s.png"};
    char path[PATH_CAPACITY];
    Fixture *f = *state = calloc(1, sizeof *f);
    strcpy(f->folder, "/tmp/matc_manifestXXXXXX");
    if (!mkdtemp(f->folder))
        return -1;
    snprintf(f->out, sizeof f->out, "%s/out", f->folder);
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++)
        write_text(f, documents[i].name, documents[i].text);
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        snprintf(path, sizeof path, "%s/%s", f->folder, pictures[i]);
        if (symlink(SOURCE_FOLDER "/examples/tiles.png", path))
            return -1;
    }
    return 0;
}

static int tear_down(void **state)
{
    Fixture *f = *state;
    folder_remove(f->folder);
    free(f);
    return 0;
}

static void hear(void *user, const char *text)
{
    Fixture *f = user;
    f->reported += *text != 0;
}

/* The text with a folder for @ and quotes for '; from malloc. */
static char *expand(const Fixture *f, const char *text)
{
    char *expanded = NULL;
    size_t size;
    FILE *out = open_memstream(&expanded, &size);
    assert_non_null(out);
    for (; *text; text++)
        if (*text == '@')
            fputs(f->folder, out);
        else
            fputc(*text == '\'' ? '"' : *text, out);
    fclose(out);
    return expanded;
}

static bool run(Fixture *f, const Case *c, BatchResult *result)
{
    char *argv[4 + MAX_OPTIONS + MAX_DOCUMENTS] = {"matc", "-d", f->out, "--no-validate"},
                                 paths[MAX_DOCUMENTS][PATH_CAPACITY];
    char *options[MAX_OPTIONS] = {0};
    int argc = 4;
    CommandLine line;
    const char *fault = NULL;
    const BatchCalls calls = {hear, NULL, NULL, NULL, f};
    for (int i = 0; i < MAX_OPTIONS && c->options[i]; i++)
        argv[argc++] = options[i] = expand(f, c->options[i]);
    for (int i = 0; i < MAX_DOCUMENTS && c->documents[i]; i++) {
        snprintf(paths[i], sizeof paths[i], "%s/%s", f->folder, c->documents[i]);
        argv[argc++] = paths[i];
    }
    if (!options_read(&line, argc, argv, &fault))
        fail_msg("%s", fault);
    const bool fine = batch_run(&line, &calls, result);
    options_free(&line);
    for (int i = 0; i < MAX_OPTIONS; i++)
        free(options[i]);
    return fine;
}

static char *read_out(const Fixture *f, const char *name, size_t *size)
{
    char path[2 * PATH_CAPACITY];
    snprintf(path, sizeof path, "%s/%s", f->out, name);
    return read_whole(path, size);
}

/* -- keys and hashes */

/* Takes the keys out; they are 32 lower hexadecimal digits, each once. */
static void take_keys(cJSON *manifest)
{
    cJSON *programs = cJSON_GetObjectItemCaseSensitive(manifest, "programs"), *program, *other;
    cJSON_ArrayForEach(program, programs)
    {
        const char *key = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(program, "key"));
        assert_non_null(key);
        assert_int_equal(strlen(key), KEY_DIGITS);
        assert_int_equal(strspn(key, "0123456789abcdef"), KEY_DIGITS);
        for (other = program->next; other; other = other->next)
            assert_string_not_equal(
                key, cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(other, "key")));
    }
    cJSON_ArrayForEach(program, programs) cJSON_DeleteItemFromObjectCaseSensitive(program, "key");
}

static int count_files(const char *folder)
{
    int count = 0;
    DIR *dir = opendir(folder);
    assert_non_null(dir);
    for (struct dirent *item = readdir(dir); item; item = readdir(dir))
        count += *item->d_name != '.';
    closedir(dir);
    return count;
}

/* Takes the files out: all of the folder but the manifest, with XXH3 of their bytes. */
static void take_files(const Fixture *f, cJSON *manifest)
{
    cJSON *files = cJSON_DetachItemFromObjectCaseSensitive(manifest, "files"), *file;
    cJSON_ArrayForEach(file, files)
    {
        size_t size;
        char digits[KEY_DIGITS + 1], *bytes = read_out(f, file->string, &size);
        assert_non_null(bytes);
        const XXH128_hash_t hash = XXH3_128bits(bytes, size);
        snprintf(digits, sizeof digits, "%016llx%016llx", (unsigned long long)hash.high64,
                 (unsigned long long)hash.low64);
        assert_string_equal(cJSON_GetStringValue(file), digits);
        free(bytes);
    }
    assert_int_equal(cJSON_GetArraySize(files) + 1, count_files(f->out));
    cJSON_Delete(files);
}

/* -- files.def */

typedef enum { ROW_FILE, ROW_OBJECT, ROW_MEMBER } RowKind;
typedef struct {
    RowKind kind;
    const char *name;
    int must;
    const char *type, *of;
} Row;

static const Row rows[] = {
#define FILE(name, doc)                   {ROW_FILE, #name, 0, "", ""},
#define OBJECT(name, doc)                 {ROW_OBJECT, #name, 0, "", ""},
#define MEMBER(name, must, type, of, doc) {ROW_MEMBER, #name, must, #type, of},
#include "grammar/files.def"
};
enum { ROWS = sizeof rows / sizeof *rows };

/* The manifest's rows are the first of files.def. */
static int manifest_end(void)
{
    int end = 1;
    assert_string_equal(rows[0].name, "manifest");
    while (rows[end].kind != ROW_FILE)
        end++;
    return end;
}

static int find_object(const char *name)
{
    for (int i = 0; i < manifest_end(); i++)
        if (rows[i].kind == ROW_OBJECT && !strcmp(rows[i].name, name))
            return i;
    fail_msg("no object %s", name);
    return -1;
}

/* Marks the members that the object and all within it have; one without a row fails, as does one
 * that must be and is not. */
static void visit(const cJSON *json, const char *object, bool *seen)
{
    const cJSON *child;
    int known = 0;
    for (int i = find_object(object) + 1; rows[i].kind == ROW_MEMBER; i++) {
        const cJSON *member = cJSON_GetObjectItemCaseSensitive(json, rows[i].name), *item;
        if (!member && rows[i].must)
            fail_msg("%s lacks %s", object, rows[i].name);
        if (!member)
            continue;
        seen[i] = true;
        known++;
        if (!strcmp(rows[i].type, "object"))
            visit(member, rows[i].of, seen);
        else if (!strcmp(rows[i].type, "objects"))
            cJSON_ArrayForEach(item, member) visit(item, rows[i].of, seen);
    }
    cJSON_ArrayForEach(child, json) known--;
    assert_int_equal(known, 0);
}

/* -- tests */

static void manifests_are_as_written_by_hand(void **state)
{
    Fixture *f = *state;
    bool seen[ROWS] = {false};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        BatchResult result;
        size_t size;
        assert_true(run(f, &cases[i], &result));
        char *text = read_out(f, "manifest.json", &size), *wanted = expand(f, cases[i].manifest);
        cJSON *manifest = cJSON_Parse(text), *expected = cJSON_Parse(wanted);
        assert_non_null(manifest);
        if (!expected)
            fail_msg("not JSON: %s", cJSON_GetErrorPtr());
        visit(manifest, "manifest", seen);
        take_files(f, manifest);
        take_keys(manifest);
        if (!cJSON_Compare(manifest, expected, true))
            fail_msg("%s\ninstead of\n%s", text, wanted);
        assert_int_equal(result.programs,
                         cJSON_GetArraySize(cJSON_GetObjectItem(expected, "programs")));
        assert_int_equal(result.materials,
                         cJSON_GetArraySize(cJSON_GetObjectItem(expected, "materials")));
        cJSON_Delete(manifest);
        cJSON_Delete(expected);
        free(text);
        free(wanted);
    }
    assert_int_equal(f->reported, 0);
    for (int i = 0; i < manifest_end(); i++)
        if (rows[i].kind == ROW_MEMBER && !seen[i])
            fail_msg("no manifest here has %s", rows[i].name);
}

/* The words that a material puts into a shared program's buffer stand in its own program with
 * --constants=baked; some do not fit into 31 bits. Cases of the layout are those of all materials.
 * */
static void words_are_those_of_the_own_program(void **state)
{
    static const Case shared = {{NULL}, {"plain.yaml", "glass.yaml"}, NULL};
    static const Case baked = {{"--constants=baked"}, {"plain.yaml", "glass.yaml"}, NULL};
    static const char *const names[] = {"plain.frag", "glass.frag"};
    Fixture *f = *state;
    BatchResult result;
    size_t size;
    int words = 0, large = 0;
    assert_true(run(f, &shared, &result));
    assert_int_equal(result.buffered, 1);
    char *text = read_out(f, "manifest.json", &size);
    cJSON *manifest = cJSON_Parse(text), *layout = cJSON_GetObjectItem(manifest, "layout");
    const double found[] = {0, 1};
    cJSON *found_cases = cJSON_CreateDoubleArray(found, 2);
    assert_true(cJSON_Compare(cJSON_GetObjectItem(layout, "cases"), found_cases, true));
    cJSON_Delete(found_cases);
    assert_true(run(f, &baked, &result));
    assert_int_equal(result.programs, 2);
    for (int i = 0; i < 2; i++) {
        const cJSON *material = cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "materials"), i),
                    *word;
        char *program = read_out(f, names[i], &size), literal[32];
        const cJSON *use = cJSON_GetArrayItem(cJSON_GetObjectItem(material, "programs"), 0);
        assert_non_null(program);
        cJSON_ArrayForEach(word, cJSON_GetObjectItem(use, "constants"))
        {
            const double number = word->child->valuedouble;
            snprintf(literal, sizeof literal, " %.0fu", number);
            assert_non_null(strstr(program, literal));
            large += number > INT32_MAX;
            words++;
        }
        free(program);
    }
    assert_int_equal(words, 8);
    assert_true(large > 0);
    cJSON_Delete(manifest);
    free(text);
}

/* A document with a fault leaves the folder, and the manifest in it, as they were: there is none,
 * or the old one. */
static void a_fault_leaves_the_manifest_alone(void **state)
{
    static const Case good = {{NULL}, {"plain.yaml"}, NULL},
                      bad = {{NULL}, {"glass.yaml", "bad.yaml"}, NULL};
    Fixture *f = *state;
    BatchResult result;
    size_t before, after;
    folder_remove(f->out);
    f->reported = 0;
    assert_false(run(f, &bad, &result));
    assert_true(f->reported > 0);
    assert_int_equal(access(f->out, F_OK), -1);
    assert_true(run(f, &good, &result));
    char *old = read_out(f, "manifest.json", &before);
    assert_false(run(f, &bad, &result));
    char *new = read_out(f, "manifest.json", &after);
    assert_non_null(new);
    assert_int_equal(before, after);
    assert_memory_equal(old, new, after);
    assert_int_equal(count_files(f->out), 2);
    free(old);
    free(new);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(manifests_are_as_written_by_hand, set_up, tear_down),
        cmocka_unit_test_setup_teardown(words_are_those_of_the_own_program, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_fault_leaves_the_manifest_alone, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
