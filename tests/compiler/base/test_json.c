/* Strict JSON: which texts are refused, and at which byte; which are accepted, and with which
 * values. cJSON parses every text as a second opinion. The whole of JSONTestSuite is in suites/. */
/* ctest: quick */
#include "tests/test.h"
#include "tests/read_text.h"
#include "compiler/tool/batch_state.h"
#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONG_KEY = 100000, LONG_NUMBER = 5000 };

typedef enum { REFUSES, ACCEPTS } Verdict; /* of cJSON, for a text that RFC 8259 refuses */

/* TEXT("...") may hold zero bytes. */
#define TEXT(text) text, sizeof(text) - 1

static const struct {
    const char *text;
    size_t size;
    uint32_t at; /* the byte of the fault */
    Verdict cjson;
} refused[] = {
    /* numbers */
    {TEXT("[01]"), 1, ACCEPTS},
    {TEXT("[-01]"), 2, ACCEPTS},
    {TEXT("[00]"), 1, ACCEPTS},
    {TEXT("[1.]"), 3, ACCEPTS},
    {TEXT("[2.e3]"), 3, ACCEPTS},
    {TEXT("[-.5]"), 2, ACCEPTS},
    {TEXT("[.5]"), 1, REFUSES},
    {TEXT("[+1]"), 1, REFUSES},
    {TEXT("[1e]"), 3, REFUSES},
    {TEXT("[1e+]"), 4, REFUSES},
    {TEXT("[1e-]"), 4, REFUSES},
    {TEXT("[-]"), 2, REFUSES},
    {TEXT("[0x10]"), 2, REFUSES},
    {TEXT("[1.2.3]"), 4, REFUSES},
    {TEXT("[NaN]"), 1, REFUSES},
    {TEXT("[Infinity]"), 1, REFUSES},
    {TEXT("[-Infinity]"), 2, REFUSES},
    {TEXT("-"), 1, REFUSES},
    {TEXT("1e"), 2, REFUSES},
    {TEXT("1."), 2, ACCEPTS},
    /* texts */
    {TEXT("[\"a\tb\"]"), 3, ACCEPTS},
    {TEXT("[\"a\nb\"]"), 3, ACCEPTS},
    {TEXT("[\"\x1f\"]"), 2, ACCEPTS},
    {TEXT("[\"a\0b\"]"), 3, ACCEPTS},
    {TEXT("[\"\\x\"]"), 2, REFUSES},
    {TEXT("[\"\\U0041\"]"), 2, REFUSES},
    {TEXT("[\"\\u004\"]"), 2, REFUSES},
    {TEXT("[\"\\u00G1\"]"), 2, ACCEPTS},
    {TEXT("[\"\\\0\"]"), 2, REFUSES},
    {TEXT("[\"\\"), 2, REFUSES},
    {TEXT("[\"\\u12"), 2, REFUSES},
    {TEXT("[\"\\ud800\"]"), 2, REFUSES},
    {TEXT("[\"\\udc00\"]"), 2, REFUSES},
    {TEXT("[\"a\\ud800b\"]"), 3, REFUSES},
    {TEXT("[\"\\ud800\\ud800\"]"), 2, REFUSES},
    {TEXT("[\"\\ud800\\n\"]"), 2, REFUSES},
    {TEXT("[\"\\udc00\\ud800\"]"), 2, REFUSES},
    {TEXT("[\"abc]"), 6, REFUSES},
    {TEXT("['a']"), 1, REFUSES},
    /* what is no UTF-8: cJSON does not look */
    {TEXT("[\"\x80\"]"), 2, ACCEPTS},
    {TEXT("[\"\xc0\xaf\"]"), 2, ACCEPTS},
    {TEXT("[\"\xed\xa0\x80\"]"), 2, ACCEPTS},
    {TEXT("[\"\xf4\x90\x80\x80\"]"), 2, ACCEPTS},
    {TEXT("[\"\xe2\x82\"]"), 2, ACCEPTS},
    /* structure */
    {TEXT(""), 0, REFUSES},
    {TEXT(" "), 1, REFUSES},
    {TEXT("[1,]"), 2, REFUSES},
    {TEXT("[1 , ]"), 3, REFUSES},
    {TEXT("{\"a\":1,}"), 6, REFUSES},
    {TEXT("[,1]"), 1, REFUSES},
    {TEXT("[1,,2]"), 3, REFUSES},
    {TEXT("[1 2]"), 3, REFUSES},
    {TEXT("[1"), 2, REFUSES},
    {TEXT("[1,"), 3, REFUSES},
    {TEXT("["), 1, REFUSES},
    {TEXT("{"), 1, REFUSES},
    {TEXT("[1}"), 2, REFUSES},
    {TEXT("{]"), 1, REFUSES},
    {TEXT("{\"a\"}"), 4, REFUSES},
    {TEXT("{\"a\" 1}"), 5, REFUSES},
    {TEXT("{\"a\":}"), 5, REFUSES},
    {TEXT("{\"a\":1 \"b\":2}"), 7, REFUSES},
    {TEXT("{a:1}"), 1, REFUSES},
    {TEXT("{1:1}"), 1, REFUSES},
    {TEXT("{\"a\":1"), 6, REFUSES},
    {TEXT("[1]]"), 3, REFUSES},
    {TEXT("1 2"), 2, REFUSES},
    {TEXT("[1]\0"), 3, ACCEPTS},
    {TEXT("]"), 0, REFUSES},
    {TEXT("[1]//"), 3, REFUSES},
    {TEXT("[1/**/]"), 2, REFUSES},
    {TEXT("#a\n[1]"), 0, REFUSES},
    {TEXT("a: 1"), 0, REFUSES},
    {TEXT("- 1"), 1, REFUSES},
    {TEXT("&a [1]"), 0, REFUSES},
    {TEXT("[*a]"), 1, REFUSES},
    {TEXT("[True]"), 1, REFUSES},
    {TEXT("[nul]"), 1, REFUSES},
    {TEXT("[nullx]"), 1, REFUSES},
    {TEXT("[1\f]"), 2, ACCEPTS},
    {TEXT("[1\xc2\xa0]"), 2, REFUSES},
    {TEXT("[\xef\xbb\xbf]"), 1, REFUSES},
};

/* A text of one list with one item. */
static const struct {
    const char *text;
    size_t size;
    const char *value;
    size_t value_size;
    bool plain;
    Verdict cjson;
} accepted[] = {
    {TEXT("[0]"), TEXT("0"), true, ACCEPTS},
    {TEXT("[-0]"), TEXT("-0"), true, ACCEPTS},
    {TEXT("[-0.0e-0]"), TEXT("-0.0e-0"), true, ACCEPTS},
    {TEXT("[1E+10]"), TEXT("1E+10"), true, ACCEPTS},
    {TEXT("[1e00]"), TEXT("1e00"), true, ACCEPTS},
    {TEXT("[true]"), TEXT("true"), true, ACCEPTS},
    {TEXT("[false]"), TEXT("false"), true, ACCEPTS},
    {TEXT("[null]"), TEXT("null"), true, ACCEPTS},
    {TEXT("[\"null\"]"), TEXT("null"), false, ACCEPTS},
    {TEXT("[\"\"]"), TEXT(""), false, ACCEPTS},
    {TEXT("[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"]"), TEXT("\"\\/\b\f\n\r\t"), false, ACCEPTS},
    {TEXT("[\"\\u0041\\u00e9\\u20AC\"]"), TEXT("A\xc3\xa9\xe2\x82\xac"), false, ACCEPTS},
    {TEXT("[\"\\ud83d\\uDE00\"]"), TEXT("\xf0\x9f\x98\x80"), false, ACCEPTS},
    {TEXT("[\"\\ud800\\udc00\\udbff\\udfff\"]"), TEXT("\xf0\x90\x80\x80\xf4\x8f\xbf\xbf"), false,
     ACCEPTS},
    {TEXT("[\"\\ud7ff\\ue000\\uffff\"]"), TEXT("\xed\x9f\xbf\xee\x80\x80\xef\xbf\xbf"), false,
     ACCEPTS},
    {TEXT("[\"\x7f\"]"), TEXT("\x7f"), false, ACCEPTS},
    {TEXT("[\"\xef\xbf\xbe\"]"), TEXT("\xef\xbf\xbe"), false, ACCEPTS},
    {TEXT("[\"\xf0\x9f\x98\x80\"]"), TEXT("\xf0\x9f\x98\x80"), false, ACCEPTS},
    {TEXT("\t[\n1\r\n]\t "), TEXT("1"), true, ACCEPTS},
    {TEXT("\xef\xbb\xbf[1]"), TEXT("1"), true, ACCEPTS},
};

static bool cjson_accepts(const char *text, size_t size)
{
    cJSON *json = cJSON_ParseWithLengthOpts(text, size + 1, NULL, true);
    cJSON_Delete(json);
    return json != NULL;
}

static void test_refused(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        ReadText r;
        read_text(&r, "a.json", refused[i].text, refused[i].size);
        if (r.tree || r.session.diags.errors != 1 ||
            r.session.diags.at[0].span.start != refused[i].at)
            fail_msg("%s: %d errors, at %u for %u", refused[i].text, r.session.diags.errors,
                     r.session.diags.count ? r.session.diags.at[0].span.start : 0, refused[i].at);
        if (cjson_accepts(refused[i].text, refused[i].size) != (refused[i].cjson == ACCEPTS))
            fail_msg("%s: cJSON's verdict is another", refused[i].text);
        read_text_done(&r);
    }
}

static void test_accepted(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof accepted / sizeof *accepted; i++) {
        ReadText r;
        read_text(&r, "a.json", accepted[i].text, accepted[i].size);
        if (!r.tree || r.session.diags.count || r.tree->kind != TREE_list || r.tree->count != 1)
            fail_msg("%s: refused: %s", accepted[i].text,
                     r.session.diags.count ? r.session.diags.at[0].message : "no list");
        const Tree *value = r.tree->items[0];
        if (value->kind != TREE_scalar || value->plain != accepted[i].plain ||
            value->count != accepted[i].value_size ||
            memcmp(value->text, accepted[i].value, value->count + 1) != 0)
            fail_msg("%s: another value: %s", accepted[i].text, value->text);
        if (cjson_accepts(accepted[i].text, accepted[i].size) != (accepted[i].cjson == ACCEPTS))
            fail_msg("%s: cJSON's verdict is another", accepted[i].text);
        read_text_done(&r);
    }
}

/* "a":, "b":, ... each once more with a zero byte and the name of another: they are different keys,
 * and no document has them. */
static void test_zero_bytes(void **state)
{
    (void)state;
    ReadText r;
    static const char text[] = "{\"a\": 1, \"a\\u0000b\": 2, \"a\\u0000c\": \"d\\u0000e\"}";
    read_text(&r, "a.json", text, sizeof text - 1);
    assert_non_null(r.tree);
    assert_int_equal(r.tree->count, 3);
    assert_int_equal(r.tree->members[2].size, 3);
    assert_memory_equal(r.tree->members[2].key, "a\0c", 4);
    assert_int_equal(r.tree->members[2].value->count, 3);
    assert_ptr_equal(tree_find(r.tree, "a"), &r.tree->members[0]);
    assert_int_equal(r.session.diags.errors, 1);
    assert_int_equal(r.session.diags.at[0].kind, DIAG_zero_byte);
    assert_int_equal(r.session.diags.at[0].span.start, strchr(text, '\\') - 2 - text);
    read_text_done(&r);
}

/* Keys and numbers of any length: libyaml has 1,024 letters for a key, cJSON 63 for a number. */
static void test_long(void **state)
{
    (void)state;
    ReadText r;
    Arena arena = {0};
    Text text = text_new(&arena);
    text_put(&text, "{\"");
    for (int i = 0; i < LONG_KEY; i++)
        text_char(&text, 'k');
    text_put(&text, "\"\n:\n0.");
    for (int i = 0; i < LONG_NUMBER; i++)
        text_char(&text, '3');
    text_put(&text, "}");
    read_text(&r, "a.json", text.at, text.size);
    assert_non_null(r.tree);
    assert_int_equal(r.session.diags.count, 0);
    assert_int_equal(r.tree->members[0].size, LONG_KEY);
    double number;
    assert_true(tree_number(r.tree->members[0].value, &number));
    assert_true(number == 1 / 3.);
    read_text_done(&r);
    arena_free(&arena);
}

/* Every value has the bytes that it stands in. */
static void test_places(void **state)
{
    (void)state;
    ReadText r;
    static const char text[] = "\xef\xbb\xbf { \"\xc3\xa9\" : [ 12 , \"\\u0041\" ] }";
    read_text(&r, "a.json", text, sizeof text - 1);
    assert_non_null(r.tree);
    const Member *member = &r.tree->members[0];
    const Span spans[] = {r.tree->span, member->span, member->value->span,
                          member->value->items[0]->span, member->value->items[1]->span};
    static const char *const expected[] = {"{ \"\xc3\xa9\" : [ 12 , \"\\u0041\" ] }",
                                           "\"\xc3\xa9\"", "[ 12 , \"\\u0041\" ]", "12",
                                           "\"\\u0041\""};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(spans[i].end - spans[i].start, strlen(expected[i]));
        assert_memory_equal(text + spans[i].start, expected[i], strlen(expected[i]));
    }
    read_text_done(&r);
}

static void test_duplicates(void **state)
{
    (void)state;
    ReadText r;
    static const char text[] = "{\"ab\": 1, \"b\": 2, \"\\u0061b\": 3}";
    read_text(&r, "a.json", text, sizeof text - 1);
    assert_int_equal(r.session.diags.count, 2);
    assert_int_equal(r.session.diags.at[0].kind, DIAG_duplicate_key);
    assert_int_equal(r.session.diags.at[0].span.start, strstr(text, "\"\\u") - text);
    assert_int_equal(r.session.diags.at[1].span.start, 1);
    read_text_done(&r);
}

static void check_depth(int depth, bool fine)
{
    ReadText r;
    char *text = calloc(1, 2 * (size_t)depth + 1);
    memset(text, '[', (size_t)depth);
    memset(text + depth, ']', (size_t)depth);
    read_text(&r, "a.json", text, 2 * (size_t)depth);
    assert_int_equal(r.tree != NULL, fine);
    if (!fine)
        assert_int_equal(r.session.diags.at[0].span.start, LIMIT_DEPTH + 1);
    read_text_done(&r);
    free(text);
}

static void test_depth(void **state)
{
    (void)state;
    check_depth(LIMIT_DEPTH + 1, true); /* the outermost is at depth 0 */
    check_depth(LIMIT_DEPTH + 2, false);
    check_depth(1000000, false);
}

/* A host may have read JSON of its own, and asks cJSON where that was wrong after we read ours. */
static void test_host(void **state)
{
    (void)state;
    ReadText r;
    static const char own[] = "[1, x]";
    assert_null(cJSON_Parse(own));
    const char *fault = cJSON_GetErrorPtr();
    assert_non_null(fault);
    read_text(&r, "a.json", TEXT("[1, 2"));
    read_text_done(&r);
    assert_ptr_equal(cJSON_GetErrorPtr(), fault);

    static Batch batch; /* its manifest is read by cJSON: nothing of that one's text is kept */
    manifest_remove_stale(&batch, "{ \"files\": x");
    assert_null(cJSON_GetErrorPtr());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refused),    cmocka_unit_test(test_accepted),
        cmocka_unit_test(test_zero_bytes), cmocka_unit_test(test_long),
        cmocka_unit_test(test_places),     cmocka_unit_test(test_duplicates),
        cmocka_unit_test(test_depth),      cmocka_unit_test(test_host),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
