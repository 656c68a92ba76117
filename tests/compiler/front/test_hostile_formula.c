/* Hostile formulas, by kind: each compiles, or gives errors whose places are within the
 * document. The kinds nest, repeat, grow, hide built-in names, or contain odd characters; the
 * last kind shuffles pieces of formulas. */
#include "tests/test.h"
#include "tests/sanitized.h"
#include "tests/compile_text.h"

enum { CAPACITY = 1 << 21, PIECES = 40, ROUNDS = 400 / SANITIZED_STEP };

/* The document with the formula; its bytes as a JSON string. */
static char *document_of(const char *formula)
{
    char *text = malloc(6 * strlen(formula) + 64),
         *at = text + sprintf(text, "material: Phong\ndiffuse: \"= ");
    for (; *formula; formula++) {
        const unsigned char byte = (unsigned char)*formula;
        at += byte == '"' || byte == '\\' ? sprintf(at, "\\%c", byte)
              : byte < ' '                ? sprintf(at, "\\x%02x", byte)
                                          : sprintf(at, "%c", byte);
    }
    memcpy(at, "\"\n", 3);
    return text;
}

/* Every line of a diagnostic that is no source line begins with the document's name, a line and a
 * column. */
static void assert_placed(const char *reported, const char *formula)
{
    for (const char *at = strstr(reported, "error: "); at; at = strstr(at + 1, "error: ")) {
        const char *start = at;
        while (start > reported && start[-1] != '\n')
            start--;
        int line = 0, column = 0;
        if (sscanf(start, "test.yaml:%d:%d:", &line, &column) != 2 || line < 1 || column < 1)
            fail_msg("%.80s: without a place: %.120s", formula, start);
    }
}

/* True: it is a program. */
static bool attack_document(const char *text, const char *formula)
{
    const MatcOptions options = quick();
    MatcDocument *document = read_text(text, &options);
    bool compiled = false;
    if (matc_error_count(document)) {
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        assert_non_null(strstr(reported, "error: "));
        assert_placed(reported, formula);
    } else {
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        compiled = matc_ok(program);
        if (!compiled) {
            assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT), "error: "));
            assert_placed(matc_program_diagnostics(program, MATC_TEXT), formula);
        }
        matc_program_free(program);
    }
    matc_document_free(document);
    return compiled;
}

static bool attack(const char *formula)
{
    char *text = document_of(formula);
    const bool compiled = attack_document(text, formula);
    free(text);
    return compiled;
}

/* `before` so many times, `middle`, `after` as often. */
static bool nested(const char *before, const char *middle, const char *after, int count)
{
    const size_t front = strlen(before), back = strlen(after), core = strlen(middle);
    char *text = malloc((front + back) * (size_t)count + core + 1), *at = text;
    for (int i = 0; i < count; i++, at += front)
        memcpy(at, before, front);
    memcpy(at, middle, core);
    at += core;
    for (int i = 0; i < count; i++, at += back)
        memcpy(at, after, back);
    *at = 0;
    const bool compiled = attack(text);
    free(text);
    return compiled;
}

static void what_nests_or_repeats(void **state)
{
    (void)state;
    static const struct {
        const char *before, *middle, *after;
        int count;
    } cases[] = {
        {"(", "u", ")", 30000},
        {"(", "", "", 60000},
        {"", "u", ")", 60000},
        {"-", "u", "", 60000},
        {"!", "u", "", 60000},
        {"u^", "u", "", 30000},
        {"u+", "u", "", 30000},
        {"u?", "1", ":0", 10000},
        {"u?", "", "", 32000},
        {"u>v?0:", "1", "", 9000},
        {"sin(", "u", ")", 1000},
        {"[", "u", "]", 30000},
        {"[u,", "u", "", 20000},
        {"", "p", ".xyz", 10000},
        {"", "p", "[0]", 10000},
        {"min(u,", "u", ")", 5000},
        {"u,", "u", "", 20000},
        {"", "u", ";", 50000},
        {"", "u", " ", 65530},
        {"", "u", " ", 70000},
        {"a;", "u", "", 20000},
        {"sin", "(u)", "", 9000},
        {"1", "", "", 60000},
        {"0.", "1", "", 20000},
        {"u==", "u", "", 20000},
        {"u&&", "u", "", 20000},
        {"attribute(", "\"a\"", ")", 5000},
        {"attribute(\"a", "", "", 5000},
        {"\"", "", "", 9000},
        {"fbm(", "p,3", ")", 200},
        {"u<", "u", "", 20000},
        {"a", " = 1; 1", "", 60000},
        {"u + ", "u", "", 1 << 17},
        {"vec3(", "u", ")", 2000},
        {"p.x.", "x", "", 5000},
        {"#", "fff", "", 9000},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        nested(cases[i].before, cases[i].middle, cases[i].after, cases[i].count / SANITIZED_STEP);
}

/* A chain of locals, each of which reads the one before twice: as a tree it would have 2^2000
 * leaves. */
static void what_grows(void **state)
{
    (void)state;
    static const char *const forms[] = {"a%d=a%d+a%d;", "a%d=a%d*a%d;", "a%d=sin(a%d)*a%d;",
                                        "a%d=a%d>0?a%d:1;", "a%d=hypot(a%d,a%d);"};
    char *text = malloc(CAPACITY);
    for (size_t form = 0; form < sizeof forms / sizeof *forms; form++) {
        size_t size = (size_t)sprintf(text, "a0=u;");
        for (int i = 1; i < 1000 / SANITIZED_STEP; i++)
            size += (size_t)snprintf(text + size, CAPACITY - size, forms[form], i, i - 1, i - 1);
        sprintf(text + size, "a%d", 1000 / SANITIZED_STEP - 1);
        attack(text);
    }
    free(text);
}

static void odd_words_and_characters(void **state)
{
    (void)state;
    static const char *const faulty[] = {
        "",
        " ",
        ";",
        ",",
        "nan",
        "inf",
        "1.2.3",
        "0x10",
        "1e",
        "p[-1]",
        "p[.5]",
        "p[99999999999999999999]",
        "fbm(p, 1e9)",
        "fbm(p, -3)",
        "fbm(p, u*8)",
        "u \xe2\x88\x92 v",
        "u \xc3\x97 v",
        "\xef\xbd\x95 + v",
        "u\xc2\xa0+ v",
        "u\xe2\x80\x8d+v",
        "u \xe2\x80\xae+ v",
        "\xf0\x9f\x98\x80",
        "u \x01 + v",
        "u = 3; u",
        "p = [1,2,3]; p",
        "pi = 3; pi",
        "sin = 3; sin",
        "mix = 1; mix(u,v,mix)",
        "attribute = 1; attribute",
        "vertexColor = 1; 1",
        "a = a + 1; a",
        "a = 1; a = 2; a",
        "b = a; a = 1; b",
        "a = 1;",
        "a = 1",
        "#define u 3\nu",
        "u \\\n + v",
        "'u'",
        "`u`",
        "$u",
        "@u",
        "u += 1; u",
        "u++",
        "u ? v",
        "u : v",
        "0 < u < 1",
        "u = v",
        "p && u",
        "p ? u : v",
        "p + uv",
        "sin()",
        "sin(u,v)",
        "u(3)",
        "p(0)",
        "sin",
        "p.xr",
        "p.xyzxy",
        "uv.z",
        "p.q",
        "[u,u,u,u,u]",
        "[]",
        "attribute",
        "attribute()",
        "attribute(\"\", float)",
        "attribute(\"a\", float, u)",
        "attribute(\"a\", float, [])",
        "attribute(\"_a\", float)",
        "attribute(\"a__b\", float)",
        "attribute(\"gl_\", float)",
        "attribute(\"a\", mat3)",
        "attribute(\"a\", vec3, [1, 2])",
        "attribute(\"a\" float)",
    };
    static const char *const fine[] = {"u +\n v",
                                       "u\t+ v",
                                       "1/0",
                                       "u % 0",
                                       "sqrt(-1)",
                                       "0^0",
                                       "u^1000000",
                                       "2^1000000",
                                       "u^-3",
                                       "(-1)^.5",
                                       "attribute(\"main\", float)",
                                       "attribute(\"float\", vec2).y",
                                       "attribute(\"u\", vec4, #fff).a",
                                       "attribute(\"time\", float, -1)"};
    for (size_t i = 0; i < sizeof faulty / sizeof *faulty; i++)
        if (attack(faulty[i]))
            fail_msg("it is a program: %s", faulty[i]);
    for (size_t i = 0; i < sizeof fine / sizeof *fine; i++)
        if (!attack(fine[i]))
            fail_msg("it is no program: %s", fine[i]);
    assert_false(attack_document(
        "defs:\n  a: \"= b\"\n  b: \"= a\"\nmaterial: Phong\ndiffuse: \"= a\"\n", "defs"));
    assert_false(attack_document("material: Phong\ndiffuse: { map: Expression, is: q }\n", "is"));
    assert_false(attack_document(
        "material: Phong\ndiffuse: { map: Expression, is: [u], with: 3 }\n", "with"));
    assert_false(attack_document(
        "material: Phong\ndiffuse: { map: Expression, is: s, with: { s: { map: Sphere } } }\n",
        "with"));
}

static void pieces_in_any_order(void **state)
{
    (void)state;
    static const char *const pieces[] = {
        "u",  "v",    "p",   "N",  "uv", "sin",   "mix",        "(",     ")",         "[",
        "]",  ",",    "+",   "-",  "*",  "/",     "^",          "%",     "?",         ":",
        "<",  ">",    "=",   "==", "!",  "&&",    "||",         ";",     ".x",        ".xyz",
        "1",  ".5",   "1e9", "a",  "b",  "fbm",   "#",          "\"a\"", "attribute", "\xc3\xa9",
        "pi", "time", "V",   " ",  "\n", "float", "vertexColor"};
    enum { COUNT = sizeof pieces / sizeof *pieces };
    uint32_t seed = 5;
    int programs = 0;
    for (int round = 0; round < ROUNDS; round++) {
        char text[1024] = "";
        seed = seed * 1664525 + 1013904223;
        for (int i = (int)(seed >> 16) % PIECES; i >= 0; i--) {
            seed = seed * 1664525 + 1013904223;
            strcat(text, pieces[(seed >> 12) % COUNT]);
        }
        programs += attack(text);
    }
    assert_true(programs < ROUNDS / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_nests_or_repeats), cmocka_unit_test(what_grows),
        cmocka_unit_test(odd_words_and_characters), cmocka_unit_test(pieces_in_any_order)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
