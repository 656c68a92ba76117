/* Lobe combinations of a Principled: compact holds any two, emission and cut-outs among them,
 * and warns about what it loses with more; --layout=auto holds any two and emission besides. All
 * parameters vary, the base's included. */
#include "tests/test.h"
#include "tests/compile_text.h"
#include "compiler/base/file.h"
#include <unistd.h>

static const struct {
    const char *name, *params;
} lobes[] = {
    {"coat", "coat: '= u'\ncoatRoughness: '= v'\ncoatColor: '= [u, v, 1]'\n"},
    {"fuzz", "fuzz: '= u'\nfuzzColor: '= [u, v, 1]'\nfuzzRoughness: '= v'\n"},
    {"transmission", "transmission: '= u'\ntransmissionColor: '= [v, 1, u]'\n"},
    {"subsurface", "subsurface: '= u'\nsubsurfaceColor: '= [u, v, 1]'\n"},
    {"leaf", "subsurface: '= u'\nsubsurfaceColor: '= [u, v, 1]'\nthinWalled: true\n"},
    {"anisotropy", "anisotropy: '= u'\nanisotropyRotation: '= v'\n"},
    {"film", "film: '= u'\nfilmThickness: '= v'\nfilmIor: '= 1.2 + u'\n"},
    {"emission", "emission: '= 3 * u'\nemissionColor: '= [u, v, 1]'\n"},
    {"holes", "opacity: '= u'\n"},
};
enum {
    LOBES = sizeof lobes / sizeof *lobes,
    SUBSURFACE = 3,
    LEAF = 4,
    FILM = 6,
    EMISSION = 7,
    LONGEST = 2048
};

static void put(char *text, int a, int b)
{
    strcpy(text, "material: Principled\nbaseColor: '= [u, v, .5]'\nmetalness: '= v'\nroughness: '= "
                 "u'\nspecular: '= v'\n");
    strcat(text, lobes[a].params);
    if (a != b)
        strcat(text, lobes[b].params);
}

static bool compact_loses(const char *text)
{
    MatcOptions options = quick();
    options.layout = "compact";
    MatcDocument *document = read_text(text, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(program));
    const bool loses = strstr(matc_program_diagnostics(program, MATC_TEXT), "case_loses") != NULL;
    matc_program_free(program);
    matc_document_free(document);
    return loses;
}

static void compact_holds_any_two(void **state)
{
    (void)state;
    char text[LONGEST];
    for (int a = 0; a < LOBES; a++)
        for (int b = a; b < LOBES; b++) {
            if (a == SUBSURFACE && b == LEAF)
                continue;
            put(text, a, b);
            if (compact_loses(text))
                fail_msg("%s and %s: compact loses one of them", lobes[a].name, lobes[b].name);
        }
}

/* Three are more than its bits are good for. */
static void compact_says_what_it_loses(void **state)
{
    (void)state;
    char text[LONGEST];
    put(text, 0, 1);
    strcat(text, lobes[FILM].params);
    assert_true(compact_loses(text));
}

/* How many materials of a document compact has no place for. */
static int count_lost(const char *name, int *seen)
{
    char path[LONGEST];
    size_t size;
    const char *why = NULL;
    MatcOptions options = quick();
    options.layout = "compact";
    snprintf(path, sizeof path, "%s/tests/published/%s.yaml", SOURCE_FOLDER, name);
    char *text = file_read(path, &size, &why);
    assert_non_null(text);
    MatcDocument *document = matc_read(path, text, size, &options);
    int count = 0;
    *seen += matc_material_count(document);
    for (int i = 0; i < matc_material_count(document); i++) {
        MatcProgram *program = matc_compile(document, i, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program));
        count += strstr(matc_program_diagnostics(program, MATC_TEXT), "case_loses") != NULL;
        matc_program_free(program);
    }
    matc_document_free(document);
    free(text);
    return count;
}

static void compact_holds_what_is_published(void **state)
{
    (void)state;
    int seen = 0, count = 0;
    count += count_lost("standard_surface", &seen) + count_lost("open_pbr", &seen);
    count += count_lost("gltf_pbr", &seen) + count_lost("usd_preview", &seen);
    assert_int_equal(seen, 48);
    assert_int_equal(count, 0);
}

/* The command alone makes layouts for sets. */
static bool auto_loses(const char *path, const char *text)
{
    char command[LONGEST], line[LONGEST];
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    snprintf(command, sizeof command, "'%s' --layout=auto --no-validate -o /dev/null '%s' 2>&1",
             MATC_PROGRAM, path);
    FILE *reported = popen(command, "r");
    bool loses = false;
    while (fgets(line, sizeof line, reported))
        loses |= strstr(line, "case_loses") || strstr(line, "error");
    return pclose(reported) || loses;
}

static void auto_holds_any_two_and_light(void **state)
{
    (void)state;
    char text[LONGEST], path[] = "/tmp/test_layout_lobes_XXXXXX.yaml";
    close(mkstemps(path, 5));
    for (int a = 0; a < LOBES; a++)
        for (int b = a; b < LOBES; b++) {
            if ((a == SUBSURFACE && b == LEAF) || a == EMISSION || b == EMISSION)
                continue;
            put(text, a, b);
            strcat(text, lobes[EMISSION].params);
            if (auto_loses(path, text))
                fail_msg("%s and %s with emission: auto loses one of them", lobes[a].name,
                         lobes[b].name);
        }
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(compact_holds_any_two),
        cmocka_unit_test(compact_says_what_it_loses),
        cmocka_unit_test(compact_holds_what_is_published),
        cmocka_unit_test(auto_holds_any_two_and_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
