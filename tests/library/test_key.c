/* Equality of programs' keys and shapes, the places of their constants, and the mapping of
 * places to members of a buffer. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/matc.h"
#include "tests/stress/generate.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_MEMBERS = 256, BLOCK_CAPACITY = 16 * MAX_MEMBERS };

static const char plain[] =
    "material: Phong\n"
    "diffuse: { map: Checker, color1: [0.1, 0.2, 0.3], color2: [0.4, 0.5, 0.6],\n"
    "  input: { map: UVTransform, offsetU: 0.3, scaleV: 5.5 } }\n";

typedef struct {
    MatcDocument *document;
    MatcProgram *program;
    MatcOptions options;
} Compiled;

static Compiled compile(const char *name, const char *text, const char *option, const char *value)
{
    Compiled c = {0};
    matc_options_init(&c.options);
    c.options.read_file = generate_file;
    if (option)
        assert_true(matc_options_set(&c.options, option, value));
    c.document = matc_read(name, text, strlen(text), &c.options);
    c.program = matc_compile(c.document, 0, MATC_KEY, &c.options);
    if (!matc_ok(c.program))
        fail_msg("%s%s", matc_diagnostics(c.document, MATC_TEXT),
                 matc_program_diagnostics(c.program, MATC_TEXT));
    return c;
}

static void release(Compiled *c)
{
    matc_program_free(c->program);
    matc_document_free(c->document);
}

/* Returns bits: 1, the keys are equal; 2, the shapes. */
static int meeting(const char *text, const char *other, const char *option, const char *value)
{
    Compiled a = compile("a.yaml", text, option, value),
             b = compile("b.yaml", other, option, value);
    int equal = !strcmp(matc_key(a.program), matc_key(b.program)) +
                2 * !strcmp(matc_shape(a.program), matc_shape(b.program));
    release(&a);
    release(&b);
    return equal;
}

/* The text with a part of it replaced. */
static const char *with(const char *text, const char *part, const char *by)
{
    static char changed[4096];
    const char *at = strstr(text, part);
    assert_non_null(at);
    snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - text), text, by, at + strlen(part));
    return changed;
}

enum { KEYS = 1, SHAPES = 2 };

static void keys_are_of_what_a_program_is(void **state)
{
    static const char image[] = "material: Phong\ndiffuse: { map: ImageMap, image: tiles.png }\n";
    static const char param[] = "material: Phong\nspecular: { param: shine, default: 0.5 }\n";
    (void)state;
    assert_int_equal(meeting(plain, plain, NULL, NULL), KEYS | SHAPES);
    assert_int_equal(meeting(plain,
                             with(plain, "material: Phong", "# another text\nmaterial:   Phong"),
                             NULL, NULL),
                     KEYS | SHAPES);
    assert_int_equal(meeting(plain,
                             with(plain, "offsetU: 0.3, scaleV: 5.5", "scaleV: 5.5, offsetU: 0.3"),
                             NULL, NULL),
                     KEYS | SHAPES);
    assert_int_equal(meeting(plain, with(plain, "0.4", "0.45"), NULL, NULL), SHAPES);
    assert_int_equal(meeting(plain, with(plain, "offsetU: 0.3", "offsetU: 0.35"), NULL, NULL),
                     SHAPES);
    /* added, multiplied */
    assert_int_equal(meeting(plain, with(plain, "offsetU: 0.3", "scaleU: 0.3"), NULL, NULL), 0);
    assert_int_equal(meeting(plain, with(plain, "offsetU: 0.3", "offsetV: 0.3"), NULL, NULL),
                     SHAPES); /* components of a vec2 */
    assert_int_equal(meeting(plain, with(plain, "Checker", "VolumeChecker"), NULL, NULL), 0);
    assert_int_equal(meeting(plain, with(plain, "0.4", "0.45"), "constants", "uniform"),
                     KEYS | SHAPES);
    assert_int_equal(
        meeting(plain, with(plain, "offsetU: 0.3", "scaleU: 0.3"), "constants", "uniform"), 0);
    assert_int_equal(meeting(plain, with(plain, "0.4", "0.45"), "pass", "depth"), KEYS | SHAPES);
    assert_int_equal(meeting(image, image, NULL, NULL), KEYS | SHAPES);
    assert_int_equal(
        meeting(image, with(image, "tiles.png", "tiles.png, bilinearFiltering: false"), NULL, NULL),
        0);
    /* another texture is another program: its reflection says what it holds */
    assert_int_equal(
        meeting(image, with(image, "tiles.png", "tiles.png, colorspace: srgb"), NULL, NULL), 0);
    assert_int_equal(
        meeting(image, with(image, "tiles.png", "tiles.png, colorspace: linear"), NULL, NULL),
        KEYS | SHAPES);
    assert_int_equal(meeting(image, with(image, "tiles.png", "tiles.png, channel: g"), NULL, NULL),
                     0);
    assert_int_equal(meeting(param, with(param, "0.5", "0.7"), NULL, NULL),
                     KEYS | SHAPES); /* a param's default is no part */
    assert_int_equal(meeting(param, with(param, "shine", "gloss"), NULL, NULL), 0);
}

/* One document, compiled in another way each time. */
static void keys_are_of_how_it_is_compiled(void **state)
{
    static const char *const options[][2] = {
        {NULL, NULL},          {"pass", "depth"},       {"pass", "value"},
        {"target", "glsl110"}, {"target", "glsl450"},   {"target", "essl300"},
        {"layout", "thesis"},  {"layout", "integer"},   {"noise", "groimp"},
        {"noise", "simplex"},  {"constants", "uniform"}};
    enum { COUNT = sizeof options / sizeof *options };
    char keys[COUNT][33];
    (void)state;
    for (int i = 0; i < COUNT; i++) {
        Compiled c = compile("a.yaml", plain, options[i][0], options[i][1]);
        snprintf(keys[i], sizeof keys[i], "%s", matc_key(c.program));
        assert_int_equal(strspn(keys[i], "0123456789abcdef"), 32);
        for (int k = 0; k < i; k++)
            if (!strcmp(keys[i], keys[k]))
                fail_msg("%s and %s meet", options[i][1],
                         options[k][1] ? options[k][1] : "the default");
        release(&c);
    }
}

static void places_become_members(void **state)
{
    Compiled c = compile("a.yaml", plain, NULL, NULL);
    int members[MAX_MEMBERS], count = matc_place_count(c.program);
    unsigned char block[BLOCK_CAPACITY];
    (void)state;
    assert_in_range(count, 4, MAX_MEMBERS);
    for (int i = 0; i < count; i++)
        members[i] = i;
    MatcOptions options = c.options;
    options.members = members;
    options.member_count = count;
    MatcProgram *placed = matc_compile(c.document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(placed))
        fail_msg("%s", matc_program_diagnostics(placed, MATC_TEXT));
    assert_int_equal(matc_constant_count(placed), count);
    assert_in_range(matc_constant_bytes(placed), 16, BLOCK_CAPACITY);
    matc_constant_block(placed, block);
    for (int i = 0, end = 0; i < count; i++) {
        const MatcConstant *member = matc_constant(placed, i),
                           *place = matc_place(c.program, member->member);
        float first;
        memcpy(&first, block + member->offset, sizeof first);
        assert_string_equal(member->type, place->type);
        assert_memory_equal(member->values, place->values,
                            sizeof(double) * (size_t)place->components);
        assert_true(member->type[0] == 'u' || first == (float)place->values[0]);
        assert_true(member->offset >= end &&
                    member->offset % (member->components < 3 ? 4 * member->components : 16) == 0);
        assert_non_null(strstr(matc_output(placed, MATC_FRAGMENT, NULL), member->name));
        end = member->offset + 4 * member->components;
        assert_true(end <= matc_constant_bytes(placed));
    }
    matc_program_free(placed);
    release(&c);
}

static void places_can_share_or_stay(void **state)
{
    static const char gray[] = "material: Phong\nspecular: 0.3\ndiffuse: { map: Checker, color1: "
                               "0.25, color2: 0.75 }\nshininess: 0.4\n";
    Compiled c = compile("a.yaml", gray, "layout", "thesis");
    int members[MAX_MEMBERS], count = matc_place_count(c.program), first = -1;
    (void)state;
    assert_in_range(count, 2, MAX_MEMBERS);
    for (int i = 0; i < count; i++)
        members[i] = -1;
    MatcOptions options = c.options;
    options.members = members;
    options.member_count = count;
    MatcProgram *same = matc_compile(c.document, 0, MATC_KEY, &options);
    assert_true(matc_ok(same));
    assert_int_equal(matc_constant_count(same), 0);
    assert_string_equal(matc_key(same), matc_key(c.program)); /* nothing was placed */
    matc_program_free(same);
    for (int i = 0; i < count; i++) { /* all places of one value */
        const MatcConstant *place = matc_place(c.program, i),
                           *other = matc_place(c.program, first < 0 ? i : first);
        bool equal =
            place->components == other->components && !strcmp(place->type, other->type) &&
            !memcmp(place->values, other->values, sizeof(double) * (size_t)place->components);
        members[i] = equal ? 0 : -1;
        first = first < 0 ? i : first;
    }
    MatcProgram *one = matc_compile(c.document, 0, MATC_KEY, &options);
    assert_true(matc_ok(one));
    assert_int_equal(matc_constant_count(one), 1);
    assert_string_not_equal(matc_key(one), matc_key(c.program));
    matc_program_free(one);
    options.member_count = count - 1;
    MatcProgram *wrong = matc_compile(c.document, 0, MATC_KEY, &options);
    assert_false(matc_ok(wrong));
    assert_non_null(strstr(matc_program_diagnostics(wrong, MATC_TEXT), "error"));
    matc_program_free(wrong);
    release(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_are_of_what_a_program_is),
        cmocka_unit_test(keys_are_of_how_it_is_compiled),
        cmocka_unit_test(places_become_members),
        cmocka_unit_test(places_can_share_or_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
