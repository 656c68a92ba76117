/* Names and comments of a program come from its document: the author's name of a map, or else
 * its slot and kind; only names that GLSL accepts; the same bytes for the same document, and one
 * program for documents that differ in names only. */
#include "tests/test.h"
#include "compiler/matc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_CAPACITY = 4096, KEY_CAPACITY = 64 };

/* The program of the first material, from malloc; `key`, unless NULL, has its key. */
static char *program_of(const char *name, const char *text, const char *target, char *key)
{
    MatcOptions options;
    matc_options_init(&options);
    assert_true(matc_options_set(&options, "target", target));
    options.validate = true;
    MatcDocument *document = matc_read(name, text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program))
        fail_msg("%s\n%s%s", text, matc_diagnostics(document, MATC_TEXT),
                 matc_program_diagnostics(program, MATC_TEXT));
    if (key)
        snprintf(key, KEY_CAPACITY, "%s", matc_key(program));
    char *fragment = strdup(matc_output(program, MATC_FRAGMENT, NULL));
    assert_non_null(fragment);
    matc_program_free(program);
    matc_document_free(document);
    return fragment;
}

static void expect(const char *name, const char *text, const char *const *parts)
{
    char *fragment = program_of(name, text, "glsl330", NULL);
    for (; *parts; parts++)
        if (!strstr(fragment, *parts))
            fail_msg("no '%s' in\n%s", *parts, strstr(fragment, "void main"));
    free(fragment);
}

static const char wall[] = "defs:\n"
                           "  clay: &loam\n"
                           "    map: Blend\n"
                           "    blend: [{ value: 0, input: black }, { value: 0.6, input: red }, { "
                           "value: 1, input: white }]\n"
                           "    input: { map: Granite }\n"
                           "material: Phong\n"
                           "diffuse: *loam\n"
                           "emissive: &glow\n"
                           "  map: Blend\n"
                           "  blend: [{ value: 0.5, input: red }, { value: 0.7, input: *loam }, { "
                           "value: 0.9, input: blue }]\n"
                           "  input: { map: Wood }\n";

static void an_authors_words_are_the_names(void **state)
{
    (void)state;
    expect("some/where/wall.yaml", wall,
           (const char *const[]){"    // wall.yaml:3 clay\n",
                                 " clay = ", "    // wall.yaml:5 Granite\n", " clay_granite",
                                 "    // wall.yaml:9 glow\n", " glow = ", " glow_wood", NULL});
}

static void what_has_no_name_goes_by_slot_and_map(void **state)
{
    (void)state;
    expect("a.json",
           "{\"material\": \"Phong\", \"specular\": {\"map\": \"Blend\", \"blend\": [{\"value\": "
           "0, \"input\": 0},\n"
           "{\"value\": 0.4, \"input\": 0.1}, {\"value\": 1, \"input\": 1}], \"input\": {\"map\": "
           "\"Granite\"}}}",
           (const char *const[]){" specular_blend = ", " specular_granite",
                                 "    // a.json:1 Blend\n", NULL});
}

static void names_that_meet_have_numbers(void **state)
{
    (void)state;
    expect("two.yaml",
           "defs:\n  a b: &x { map: Granite }\n  a-b: &y { map: Wood }\nmaterial: Phong\n"
           "diffuse: { map: Blend, blend: [{ value: 0, input: *x }, { value: 1, input: *y }, { "
           "value: 2, input: *x },\n"
           "  { value: 3, input: *y }],\n"
           "  input: { map: Granite, frequency: 4, input: { map: XYZTransform, transform: { scale: "
           "3 } } } }\n",
           (const char *const[]){" a_b = ", " a_b2 = ", NULL});
}

/* Words of GLSL, of a target, of matc, of the document's params; what is no word at all. */
static const char *const hostile[] = {
    "mix",
    "float",
    "vec3",
    "main",
    "uv",
    "gl_x",
    "GL_ES",
    "a__b",
    "__",
    "_",
    "2tone",
    "p",
    "st",
    "position",
    "fragment0",
    "granite",
    "turbulence",
    "sampler2D",
    "input",
    "surface",
    "diffuse",
    "normal",
    "Constants",
    "Material",
    "shine",
    "uint",
    "texture",
    "\xD0\xB3\xD0\xBB\xD0\xB8\xD0\xBD\xD0\xB0",
    "Lehm, na\xC3\x9F",
    "*/",
    "// x",
    "a\\\\",
    "a\\n#error",
    "imageTexture0",
    "smooth3DInput0",
    "VULKAN",
    "filter",
    "a_very_long_word_of_more_than_sixty_four_letters_that_an_exporter_gave"};

static const char *document_with(const char *word)
{
    static char text[TEXT_CAPACITY];
    snprintf(text, sizeof text,
             "defs:\n  \"%s\": &x { map: Granite }\nmaterial: Phong\nspecular: { param: shine, "
             "default: 0.5 }\n"
             "diffuse: { map: Blend, blend: [{ value: 0, input: { map: Blend,\n"
             "  blend: [{ value: 0, input: black }, { value: 1, input: *x }], input: { map: Wood, "
             "input: *x } } },\n"
             "  { value: 1, input: { map: Wrinkles } }], input: *x }\n",
             word);
    return text;
}

static bool is_in_comment(const char *text, const char *at)
{
    while (at > text && at[-1] != '\n')
        at--;
    return !strncmp(at + strspn(at, " "), "//", 2);
}

static void no_word_breaks_a_program(void **state)
{
    static const char *const targets[] = {"glsl330", "glsl450", "glsl110", "essl300", "spirv"};
    (void)state;
    char first[KEY_CAPACITY], key[KEY_CAPACITY];
    for (size_t target = 0; target < sizeof targets / sizeof *targets; target++)
        for (size_t i = 0; i < sizeof hostile / sizeof *hostile; i++) {
            char *fragment = program_of("a\\\nb\xC3\xA9.yaml", document_with(hostile[i]),
                                        targets[target], i ? key : first);
            if (i)
                assert_string_equal(key, first);
            for (const char *c = fragment; *c; c++)
                if ((*c < ' ' && *c != '\n') || *c > '~' || *c == '\\')
                    fail_msg("'%s' writes the byte %d", hostile[i], (unsigned char)*c);
            for (const char *at = strstr(fragment, "void main"); (at = strstr(at, "__")); at++)
                assert_true(is_in_comment(fragment, at));
            free(fragment);
        }
}

/* Any file with the same document gives the same bytes; with another word only that word differs.
 * */
static void programs_differ_in_words_alone(void **state)
{
    (void)state;
    char *here = program_of("a.yaml", document_with("clay"), "glsl330", NULL),
         *there = program_of("/tmp/b/a.yaml", document_with("clay"), "glsl330", NULL),
         *other = program_of("a.yaml", document_with("sand"), "glsl330", NULL);
    assert_string_equal(here, there);
    assert_string_not_equal(here, other);
    for (char *at; (at = strstr(other, "sand"));)
        memcpy(at, "clay", 4);
    assert_string_equal(here, other);
    free(here);
    free(there);
    free(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_authors_words_are_the_names),
        cmocka_unit_test(what_has_no_name_goes_by_slot_and_map),
        cmocka_unit_test(names_that_meet_have_numbers),
        cmocka_unit_test(no_word_breaks_a_program),
        cmocka_unit_test(programs_differ_in_words_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
