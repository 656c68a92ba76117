/* Each limit of the compiler: the last value that passes and the first that is refused, from
 * tests/limits.def. */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "compiler/base/session.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define A_PHONG "material: Phong\n"

/* -- Documents with `count` parts */

static void put_many(Text *out, const char *text, int count)
{
    for (int i = 0; i < count; i++)
        text_put(out, text);
}

static void bytes_of_document(Text *out, int count)
{
    text_put(out, A_PHONG "#");
    char *rest = malloc((size_t)count);
    assert_non_null(rest);
    memset(rest, 'x', (size_t)count);
    text_add(out, rest, (size_t)count - out->size);
    free(rest);
}

/* `count` levels of nesting within the outermost object. */
static void nested_lists(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: ");
    put_many(out, "[", count);
    text_put(out, "1");
    put_many(out, "]", count);
}

static void nested_json(Text *out, int count)
{
    text_put(out, "{\"material\": \"Phong\", \"diffuse\": ");
    put_many(out, "[", count);
    text_put(out, "1");
    put_many(out, "]", count);
    text_put(out, "}");
}

/* Each map is the input of the next one, by a reference: m1, m2, ... */
static void put_chain(Text *out, int maps)
{
    text_put(out, "defs:\n  m1: { map: UVTransform, scaleU: 1.5 }\n");
    for (int i = 2; i <= maps; i++)
        text_format(out, "  m%d: { map: UVTransform, scaleU: 1.5, input: { ref: m%d } }\n", i,
                    i - 1);
}

/* Levels below a material: a Checker, then the chain. Materials before the last resolve the chain
 * from below, so that few references are open at once. */
static void maps_below_one_another(Text *out, int count)
{
    const int maps = count - 1, step = 500;
    put_chain(out, maps);
    text_put(out, "materials:\n");
    for (int i = step; i < maps; i += step)
        text_format(out,
                    "  a%d: { material: Phong, diffuse: { map: Checker, input: { ref: m%d } } }\n",
                    i, i);
    text_format(
        out, "  last: { material: Phong, diffuse: { map: Checker, input: { ref: m%d } } }\n", maps);
}

/* A material, a Checker, and for each map of the chain the map and the reference to it; one more
 * reference where the number is odd. */
static void open_references(Text *out, int count)
{
    const int maps = (count - 2) / 2;
    put_chain(out, maps);
    text_format(out, "  odd: { ref: m%d }\n", maps);
    text_format(out, A_PHONG "diffuse: { map: Checker, input: { ref: %s%.0d } }\n",
                count % 2 ? "odd" : "m", count % 2 ? 0 : maps);
}

/* The file "3" includes "2", which includes "1". */
static void nested_includes(Text *out, int count)
{
    text_format(out, "include: nest%d\n" A_PHONG, count);
}

static void many_includes(Text *out, int count)
{
    text_put(out, A_PHONG "include: [");
    for (int i = 0; i < count; i++)
        text_format(out, "leaf%d, ", i);
    text_put(out, "]\n");
}

static void long_name(Text *out, int count)
{
    text_put(out, "materials: { ");
    put_many(out, "m", count);
    text_put(out, ": { material: Phong } }\n");
}

/* Chains of two equal halves, and one more wave where the number is odd. */
static void put_waves(Text *out, int count)
{
    if (count == 1) {
        text_put(out, "Sin");
        return;
    }
    const bool odd = count % 2;
    text_format(out, "{ wave: Chain, first: &a%d ", count);
    put_waves(out, odd ? count - 1 : count / 2);
    if (odd)
        text_put(out, ", second: Sin }");
    else
        text_format(out, ", second: *a%d }", count);
}

static void many_waves(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: { map: Wood, waveForm: ");
    put_waves(out, count);
    text_put(out, " }\n");
}

static void many_params(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: { map: Switch, which: 0, maps: [");
    for (int i = 0; i < count; i++)
        text_format(out, "{ param: p%d, default: 0 }, ", i);
    text_put(out, "] }\n");
}

static void many_attributes(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: \"= 0");
    for (int i = 0; i < count; i++)
        text_format(out, " + attribute('a%d', float)", i);
    text_put(out, "\"\n");
}

static void parameters_of_definition(Text *out, int count)
{
    text_put(out, A_PHONG "defs: { a: { params: { ");
    for (int i = 0; i < count; i++)
        text_format(out, "p%d: 0, ", i);
    text_put(out, "}, map: Checker } }\n");
}

/* The limit does not count the '=' before the formula. */
static void bytes_of_formula(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: \"=u");
    put_many(out, " ", count - 2);
    text_put(out, ";\"\n");
}

static void many_tags(Text *out, int count)
{
    text_put(out, "%YAML 1.1\n");
    for (int i = 0; i < count; i++)
        text_format(out, "%%TAG !t%d! tag:a,2000:\n", i);
    text_put(out, "---\n" A_PHONG);
}

static void items_in_disorder(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: { map: Blend, input: { map: Granite }, blend: [");
    for (int i = 0; i < count; i++)
        text_format(out, "{ value: %s%d, input: %s }, ", i ? "0." : "0.9", i % 9 + 1,
                    i % 2 ? "red" : "blue");
    text_put(out, "] }\n");
}

static void filters_within_filters(Text *out, int count)
{
    text_put(out, A_PHONG "diffuse: ");
    put_many(out, "{ map: Smooth3D, input: ", count);
    text_put(out, "{ map: Wood }");
    put_many(out, " }", count);
    text_put(out, "\n");
}

static void fields_of_layout(Text *out, int count)
{
    text_put(out, "layout: a\ntargets: [RGBA32UI]\nfields: [");
    put_many(out, "{ slot: diffuse.r, encoding: unorm, bits: 1 }, ", count);
    text_put(out, "]\n");
}

/* The fields of the layout itself count as a case. */
static void cases_of_layout(Text *out, int count)
{
    text_put(out, "layout: a\ntargets: [RGBA32UI]\nfields: [{ slot: diffuse, encoding: unorm, "
                  "bits: 8 }]\ncases: [");
    put_many(out, "{ fields: [{ slot: specular, encoding: unorm, bits: 8 }] }, ", count - 1);
    text_put(out, "]\n");
}

/* -- Diagnostics of these documents */

typedef void Make(Text *out, int count);
typedef struct {
    const char *limit;
    int last;
    DiagKind kind;
    Make *make; /* NULL: another test has the limit, or nothing is refused */
    const char *file, *text;
} Row;

static const Row rows[] = {
#define BORDER(limit, last, kind, make) {#limit, last, DIAG_##kind, make, NULL, NULL},
#define BORDER_IN(limit, file, text)    {#limit, 0, DIAG_COUNT, NULL, file, text},
#define NO_BORDER(limit, why)           {#limit, 0, DIAG_COUNT, NULL, NULL, NULL},
#include "tests/limits.def"
#undef BORDER
#undef BORDER_IN
#undef NO_BORDER
};
enum { ROWS = sizeof rows / sizeof *rows };

/* Included files: "nest3" includes "nest2"; any other defines its own name. */
static char *read_included(void *user, const char *path, size_t *size, const char **why)
{
    char text[64];
    const int nested = !strncmp(path, "nest", 4) ? atoi(path + 4) : 0;
    (void)user, (void)why;
    if (nested > 1)
        snprintf(text, sizeof text, "include: nest%d\n", nested - 1);
    else
        snprintf(text, sizeof text, "defs: { %s: 0 }\n", path);
    *size = strlen(text);
    return strdup(text);
}

static bool is_layout(const char *text) { return !strncmp(text, "layout:", 7); }

/* Number of messages of the kind. */
static int count_in(const char *messages, DiagKind kind)
{
    char name[128];
    int count = 0;
    snprintf(name, sizeof name, "\"kind\": \"%s\"", diag_table[kind].name);
    for (const char *at = messages; (at = strstr(at, name)); at++)
        count++;
    return count;
}

static int reported_of_layout(const Text *text, const MatcOptions *options, DiagKind kind)
{
    MatcLayout *layout = matc_layout_read("limit.yaml", text->at, text->size, options);
    const int count = count_in(matc_layout_diagnostics(layout, MATC_JSON), kind);
    matc_layout_free(layout);
    return count;
}

static int reported(Make *make, int parts, DiagKind kind)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.read_file = read_included;
    make(&text, parts);
    int count = 0;
    if (is_layout(text.at)) {
        count = reported_of_layout(&text, &options, kind);
        arena_free(&arena);
        return count;
    }
    MatcDocument *document =
        matc_read(*text.at == '{' ? "limit.json" : "limit.yaml", text.at, text.size, &options);
    count = count_in(matc_diagnostics(document, MATC_JSON), kind);
    if (matc_material_count(document) == 1 && kind == DIAG_long_walk) {
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        count += count_in(matc_program_diagnostics(program, MATC_JSON), kind);
        matc_program_free(program);
    }
    matc_document_free(document);
    arena_free(&arena);
    return count;
}

static void borders(void **state)
{
    int faults = 0;
    (void)state;
    for (int i = 0; i < ROWS; i++) {
        const Row *row = &rows[i];
        if (!row->make)
            continue;
        const int at = reported(row->make, row->last, row->kind),
                  beyond = reported(row->make, row->last + 1, row->kind);
        if (at || !beyond)
            print_error("%s, row %d: %s at the border, %s one beyond\n", row->limit, i,
                        at ? "refused" : "passes", beyond ? "refused" : "passes");
        faults += at || !beyond;
    }
    assert_int_equal(faults, 0);
}

/* A message quotes the first 256 letters of a name of 300. */
static void quotes_are_cut(void **state)
{
    char text[400] = A_PHONG "diffuse: ", wanted[300];
    (void)state;
    const size_t before = strlen(text);
    memset(text + before, 'q', 300);
    text[before + 300] = '\n';
    MatcDocument *document = matc_read("limit.yaml", text, before + 301, NULL);
    memset(wanted, 'q', sizeof wanted);
    wanted[LIMIT_QUOTE] = 0;
    const char *json = matc_diagnostics(document, MATC_JSON);
    assert_non_null(strstr(json, wanted));
    wanted[LIMIT_QUOTE] = 'q';
    wanted[LIMIT_QUOTE + 1] = 0;
    assert_null(strstr(json, wanted));
    matc_document_free(document);
}

static bool stands_in(const char *file, const char *wanted)
{
    size_t size;
    const char *why;
    char *text = file_read(file, &size, &why);
    const bool found = text && strstr(text, wanted);
    free(text);
    return found;
}

/* Reads the names of the limits from the text of session.h. */
static void every_limit_has_a_row(void **state)
{
    size_t size;
    const char *why;
    int missing = 0, limits = 0;
    (void)state;
    char *header = file_read("compiler/base/session.h", &size, &why);
    assert_non_null(header);
    for (const char *at = header; (at = strstr(at, "    LIMIT_")); limits++) {
        at += 4;
        const size_t length = strcspn(at, " =");
        bool found = false;
        for (int i = 0; i < ROWS; i++)
            found |= strlen(rows[i].limit) == length && !strncmp(rows[i].limit, at, length);
        if (!found)
            print_error("tests/limits.def has no row of %.*s\n", (int)length, at);
        missing += !found;
    }
    free(header);
    for (int i = 0; i < ROWS; i++)
        if (rows[i].file && !stands_in(rows[i].file, rows[i].text)) {
            print_error("%s: \"%s\" does not stand in %s\n", rows[i].limit, rows[i].text,
                        rows[i].file);
            missing++;
        }
    assert_true(limits > 25);
    assert_int_equal(missing, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(borders), cmocka_unit_test(quotes_are_cut),
                                       cmocka_unit_test(every_limit_has_a_row)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
